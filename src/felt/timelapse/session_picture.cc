#include "felt/timelapse/session_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/base/check.h"
#include "felt/session/layer_edit.h"
#include "felt/timelapse/shown_edit.h"

namespace felt {
namespace {

/// Parts are painted one after another, and each traces the strokes that it touches. More parts
/// than this are joined.
constexpr std::size_t kMaxParts = 12;

/// Two parts are joined if this increases the number of pixels by at most this factor.
constexpr double kWorthJoining = 1.4;

/// Ink may touch this many pixels beyond its bounds.
constexpr double kMarginPx = 2.0;

std::int64_t pixels_in(PixelRect part) noexcept {
  return std::int64_t{part.width()} * part.height();
}

PixelRect joined(PixelRect a, PixelRect b) noexcept {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

/// Returns the pixels by which joining two parts increases the area.
std::int64_t cost_of_joining(PixelRect a, PixelRect b) noexcept {
  return pixels_in(joined(a, b)) - pixels_in(a) - pixels_in(b);
}

bool is_worth_joining(PixelRect a, PixelRect b) noexcept {
  return static_cast<double>(pixels_in(joined(a, b))) <=
         kWorthJoining * static_cast<double>(pixels_in(a) + pixels_in(b));
}

/// Adds a part, joined with parts nearby.
void add_part(PixelRect part, std::vector<PixelRect>& parts) {
  for (auto other = parts.begin(); other != parts.end();) {
    if (!is_worth_joining(part, *other)) {
      ++other;
      continue;
    }
    part = joined(part, *other);
    parts.erase(other);
    other = parts.begin();
  }
  if (parts.size() < kMaxParts) {
    parts.push_back(part);
    return;
  }
  auto nearest = std::min_element(parts.begin(), parts.end(), [part](PixelRect a, PixelRect b) {
    return cost_of_joining(a, part) < cost_of_joining(b, part);
  });
  *nearest = joined(*nearest, part);
}

PixelRect pixels_of(const Rect& area_px, PixelRect whole) noexcept {
  const auto inside = [](double px, int low, int high) {
    return static_cast<int>(std::clamp(px, static_cast<double>(low), static_cast<double>(high)));
  };
  return {inside(std::floor(area_px.x0 - kMarginPx), whole.x0, whole.x1),
          inside(std::floor(area_px.y0 - kMarginPx), whole.y0, whole.y1),
          inside(std::ceil(area_px.x1 + kMarginPx), whole.x0, whole.x1),
          inside(std::ceil(area_px.y1 + kMarginPx), whole.y0, whole.y1)};
}

/// Returns the edit that leaves out the pictures of a document that exported files do not show.
Edit hiding_pictures(const Document& document) {
  Edit edit;
  for (std::size_t i = 0; i < document.layers().size(); ++i) {
    const Layer& layer = document.layers()[i];
    if (!layer.picture || layer.picture->exported) continue;
    LayerState without = layer.state();
    without.picture = nullptr;
    edit.layers.push_back({layer.id, layer.state(), std::move(without), i, i});
  }
  return edit;
}

}  // namespace

Result<std::unique_ptr<SessionPicture>> SessionPicture::create(const PageOptions& page,
                                                               const Document& start) {
  FELT_CHECK(page.area.has_value());
  Result<PagePainter> blank = PagePainter::create({}, page);
  if (!blank) return tl::unexpected(blank.error());
  const View view = blank->view();
  return std::unique_ptr<SessionPicture>(
      new SessionPicture(std::move(blank->image()), view, page, start));
}

SessionPicture::SessionPicture(Image image, const View& view, const PageOptions& page,
                               const Document& start)
    : image_(std::move(image)),
      view_(view),
      paper_(page.paper),
      style_{.grain = page.grain, .is_seamless = true},
      scene_(start) {
  scene_.set_styles(page.grain.styles());
  const Edit hiding = hiding_pictures(start);
  if (!hiding.empty()) FELT_CHECK(scene_.apply(hiding, damage_).has_value());
  damage_.assign(1, *page.area);
}

void SessionPicture::set_materials(const Materials& materials) {
  if (!style_.grain.is_plain()) return;
  Grain grain = Grain::solid(materials);
  if (grain == style_.grain) return;
  style_.grain = std::move(grain);
  scene_.set_styles(style_.grain.styles());
  damage_.assign(1, view_.area_mm({0.0, 0.0}, {static_cast<double>(image_.width()),
                                               static_cast<double>(image_.height())}));
}

Result<void> SessionPicture::apply(const Edit& edit) {
  return scene_.apply(with_exported_pictures(with_layers_hidden(edit, hidden_)), damage_);
}

/// Hides the layers that have gone out of view since the last picture, and shows the others.
Result<void> SessionPicture::use_view_of(const Session& session) {
  const std::vector<LayerId> before = std::exchange(hidden_, session.out_of_view());
  if (before == hidden_) return {};
  const auto has = [](const std::vector<LayerId>& ids, LayerId id) {
    return std::binary_search(ids.begin(), ids.end(), id);
  };
  Edit edit;
  for (std::size_t i = 0; i < session.document().layers().size(); ++i) {
    const Layer& layer = session.document().layers()[i];
    LayerChange change{layer.id, layer.state(), layer.state(), i, i};
    if (has(before, layer.id)) change.before->visible = false;
    if (has(hidden_, layer.id)) change.after->visible = false;
    if (change.before != change.after) edit.layers.push_back(std::move(change));
  }
  return edit.empty() ? Result<void>() : scene_.apply(with_exported_pictures(edit), damage_);
}

Result<const Image*> SessionPicture::update(const Session& session) {
  const Result<void> shown =
      use_view_of(session).and_then([&] { return scene_.show(shown_edit(session), damage_); });
  if (!shown) return tl::unexpected(shown.error());
  set_materials(session.materials());
  repaint();
  return &image_;
}

std::vector<PixelRect> SessionPicture::damaged_parts() const {
  const PixelRect whole{0, 0, image_.width(), image_.height()};
  std::vector<PixelRect> parts;
  for (const Rect& area : damage_) {
    if (area.empty()) continue;
    const PixelRect part = pixels_of(view_.area_px(area), whole);
    if (!part.empty()) add_part(part, parts);
  }
  return parts;
}

void SessionPicture::repaint() {
  for (const PixelRect& part : damaged_parts()) paint(part);
  damage_.clear();
}

void SessionPicture::paint(PixelRect part) {
  painted_ += pixels_in(part);
  fill(image_.pixels(), part, paper_);
  InkJob job = TilePainter::job_of(scene_, view_, part);
  while (!job.is_done()) painter_.draw_next(job, style_, image_.pixels());
}

}  // namespace felt
