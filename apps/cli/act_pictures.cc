#include "act_pictures.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

#include "felt/render/page_painter.h"
#include "felt/render/plot_canvas.h"

namespace felt::cli {
namespace {

constexpr Rgba kPaper{255, 254, 250, 255};
constexpr Rgba kGround{255, 255, 255, 255};
constexpr Rgba kCaption{90, 90, 96, 255};
constexpr double kAroundMm = 7.0;
constexpr double kMinMm = 45.0;  // shortest side of the page area in a panel
constexpr double kMinAspect = 0.5;
constexpr double kUnits = 300.0;  // width of a panel in units of lines and letters
constexpr double kGapUnits = 8.0;
constexpr double kCaptionUnits = 16.0;
constexpr double kCaptionSize = 7.5;

/// Returns the area of what a layer of `from` has, but `other` has not.
Rect area_only_in(const Layer& layer, const Document& from, const Document& other) {
  Rect box;
  for (const StrokeId id : layer.strokes) {
    const StrokePtr stroke = from.find(id), its = other.find(id);
    if (!its || *its != *stroke) box.extend(stroke->bounds());
  }
  for (const FillId id : layer.fills) {
    const FillPtr area = from.find_fill(id), its = other.find_fill(id);
    if (!its || !(*its == *area)) box.extend(fill_bounds(*area));
  }
  return box;
}

/// Returns the area in which two documents differ.
Rect difference(const Document& a, const Document& b) {
  Rect box;
  for (const Layer& layer : a.layers()) box.extend(area_only_in(layer, a, b));
  for (const Layer& layer : b.layers()) box.extend(area_only_in(layer, b, a));
  return box;
}

/// Returns the part of the page around `box` that a panel shows. It is at least as wide as high,
/// but not very wide.
Rect panel_around(const Rect& box) {
  const Rect roomy = box.inflated(kAroundMm);
  const double half_width = 0.5 * std::max({roomy.width(), roomy.height(), kMinMm});
  const double half_height = std::max(0.5 * roomy.height(), kMinAspect * half_width);
  const Point middle{0.5 * (roomy.x0 + roomy.x1), 0.5 * (roomy.y0 + roomy.y1)};
  return {middle.x - half_width, middle.y - half_height, middle.x + half_width,
          middle.y + half_height};
}

void copy(Image& from, Image& to, int x0, int y0) {
  const Pixels in = from.pixels(), out = to.pixels();
  const int width = std::min(in.width, out.width - x0);
  for (int y = 0; y < in.height && y0 + y < out.height; ++y) {
    std::memcpy(out.data + (y0 + y) * out.stride + 4 * x0, in.data + y * in.stride,
                static_cast<std::size_t>(4 * width));
  }
}

}  // namespace

ActPictures::ActPictures(std::string_view act) : tool_(act.substr(act.find('-') + 1)) {
  tool_.resize(std::min(tool_.size(), tool_.find('-')));
}

void ActPictures::see(const Session& session, const PenSample& pen) {
  if (is_over_ || session.tool().info().id != tool_) return;
  if (!in_contact(pen)) {
    is_over_ = in_progress_.has_value();
    return;
  }
  if (!before_) before_ = SessionView{session.document(), {}, std::nullopt};
  in_progress_ = view_of(session, on_page(pen.position));
}

Result<Image> ActPictures::draw(const Session& after, int width_px) const {
  if (!before_ || !in_progress_) return fail(ErrorCode::kInvalidData, tool_ + " never touched");
  std::array<SessionView, 3> views{*before_, *in_progress_, view_of(after, std::nullopt)};
  // If the document did not change, the act only changed the selection. The last panel then keeps
  // the overlay, which shows the selection.
  if (!(views[0].document == views[2].document)) views[2].overlay.clear();
  constexpr std::array kCaptions{"before", "in progress", "after"};
  Rect box = difference(before_->document, views[2].document);
  SessionView shown = *in_progress_;
  shown.document = {};
  box.extend(bounds_of(shown));
  PictureOptions picture;
  picture.paper = kPaper;
  picture.area = panel_around(box);
  const double px_per_unit = width_px / (3.0 * kUnits + 2.0 * kGapUnits);
  const double panel_height = kUnits * picture.area->height() / picture.area->width();
  const int panel_px = static_cast<int>(kUnits * px_per_unit);
  const int height_px = static_cast<int>(panel_height * px_per_unit);
  const int step_px = static_cast<int>((kUnits + kGapUnits) * px_per_unit);
  const int caption_px = static_cast<int>(kCaptionUnits * px_per_unit);
  picture.dpi = kMmPerInch * panel_px / picture.area->width();
  Result<Image> whole = Image::create(2 * step_px + panel_px, height_px + caption_px);
  if (!whole) return whole;
  fill(whole->pixels(), whole->pixels().rect(), kGround);
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    Result<Image> panel = draw_view(views[k], picture, px_per_unit * 150.0 / picture.dpi);
    if (!panel) return panel;
    copy(*panel, *whole, i * step_px, 0);
    PlotCanvas canvas(whole->pixels(), px_per_unit);
    canvas.text({(kUnits + kGapUnits) * i + 0.5 * kUnits, panel_height + kCaptionUnits - 4.0},
                kCaptions[k], {kCaptionSize, kCaption, PlotAlign::kCenter});
  }
  return whole;
}

}  // namespace felt::cli
