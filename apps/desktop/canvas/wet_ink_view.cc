#include "desktop/canvas/wet_ink_view.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "felt/render/ink_look.h"

namespace felt::desktop {
namespace {

constexpr double kOutlinePx = 1.0;  // line width in outline mode, device-independent pixels
constexpr double kBandPx = 7.0;     // a band is wider than its ink by kBandPx
constexpr double kMinBandPx = 9.0;
/// Rows that are shaded at a time, so that the maps of a large picture stay small.
constexpr int kBandRows = 64;

/// Returns how many elements at the start of both sequences are equal.
template <class T>
std::size_t common(std::span<const T> a, std::span<const T> b) {
  const std::size_t largest = std::min(a.size(), b.size());
  std::size_t n = 0;
  while (n < largest && a[n] == b[n]) ++n;
  return n;
}

/// Draws the image exactly onto the device pixels, also at fractional screen scales, as tiles are
/// drawn.
void draw_pixels(QPainter& painter, const QImage& image, const PixelRect& pixels, double dpr) {
  painter.save();
  painter.scale(1.0 / dpr, 1.0 / dpr);
  painter.drawImage(QPoint(pixels.x0, pixels.y0), image);
  painter.restore();
}

}  // namespace

void InkBrush::fill(const DabRows& rows, std::size_t from, std::size_t to, const PixelRect& pixels,
                    Rgba color) {
  outline_.clear();
  rows.trace(pixels, outliner_, outline_, from, to);
  fill(outline_, pixels, color);
}

void InkBrush::fill(const Outline& outline, const PixelRect& pixels, Rgba color) {
  if (image_.width() != pixels.width() || image_.height() != pixels.height()) {
    image_ = QImage(pixels.width(), pixels.height(), QImage::Format_ARGB32_Premultiplied);
  }
  image_.fill(Qt::transparent);
  if (outline.points.empty()) return;
  const Pixels target{image_.bits(), image_.width(), image_.height(), image_.bytesPerLine(),
                      PixelOrder::kBgra};
  const View place{{static_cast<double>(pixels.x0), static_cast<double>(pixels.y0)}, 1.0};
  rasterizer_.fill(outline, place, target.rect(), color, target);
}

void InkBrush::paint(QPainter& painter, const QRectF& part, const DeviceView& view,
                     const DabRows& rows, Rgba color) {
  const QRectF ink = part.intersected(QRectF(view.part_of(rows.bounds())));
  if (ink.isEmpty()) return;
  const PixelRect pixels = view.pixels_of(ink);
  fill(rows, 0, DabRows::kAll, pixels, color);
  draw_pixels(painter, image_, pixels, view.dpr);
}

QImage& InkBrush::cover(const DabRows& rows, std::size_t from, std::size_t to,
                        const PixelRect& pixels) {
  fill(rows, from, to, pixels, {255, 255, 255, 255});
  return image_;
}

QImage& InkBrush::cover(const Outline& outline, const PixelRect& pixels) {
  fill(outline, pixels, {255, 255, 255, 255});
  return image_;
}

void WetInkView::add(Row& row, const Overlay::InkSegment& segment) const {
  Overlay::InkSegment shown = segment;
  if (outline_mode_) shown.start_width_mm = shown.end_width_mm = 0.0;
  row.dabs.add(shown, outline_mode_ ? kOutlinePx * view_.dpr : 0.0);
}

void WetInkView::set_view(const DeviceView& view) {
  view_ = view;
  const auto remake = [this](Row& row) {
    row.dabs.clear();
    row.dabs.set_view(view_);
    for (const Overlay::InkSegment& segment : row.segments) add(row, segment);
    const std::size_t settled = row.settled;
    unsettle(row);
    restyle(row);
    settle(row, settled);
  };
  remake(wet_);
  for (Row& row : drying_) remake(row);
}

void WetInkView::set_grain(const Grain& grain, const std::string& medium) {
  grain_ = grain;
  medium_ = medium;
}

void WetInkView::set_outline_mode(bool on) {
  outline_mode_ = on;
  set_view(view_);
}

/// First counts the unchanged segments at the start, n: segments that the previous and the new
/// overlay call stable, and then segments that compare equal. All later segments are replaced.
/// Segments that two consecutive changes left as they were are added to the mask (settle()). If a
/// segment in the mask changes, the mask is dropped.
QRegion WetInkView::update(const Overlay& overlay) {
  using Ink = std::span<const Overlay::InkSegment>;
  const Ink ink(overlay.ink);
  if (ink.empty() && wet_.segments.empty()) return {};
  const bool is_known = overlay.ink_stroke != 0 && overlay.ink_stroke == wet_.stroke;
  std::size_t n = is_known ? std::min(overlay.ink_stable, wet_.stable) : 0;
  n += common(Ink(wet_.segments).subspan(n), ink.subspan(n));
  if (overlay.ink_color != wet_.color || wet_.segments.empty()) n = 0;
  const bool had_style = wet_.has_style;
  const bool changes = n < ink.size() || n < wet_.segments.size();
  Rect box = wet_.dabs.bounds(had_style && changes ? 0 : n);
  if (n < wet_.settled || wet_.segments.empty()) unsettle(wet_);
  wet_.segments.resize(n);
  wet_.dabs.keep(n);
  wet_.stroke = overlay.ink_stroke;
  wet_.stable = overlay.ink_stable;
  wet_.color = overlay.ink_color;
  wet_.medium = medium_;
  for (const Overlay::InkSegment& segment : ink.subspan(n)) {
    wet_.segments.push_back(segment);
    add(wet_, segment);
  }
  if (changes || had_style) restyle(wet_);
  const bool is_redrawn = changes && (had_style || wet_.has_style);
  box.extend(wet_.dabs.bounds(is_redrawn ? 0 : n));
  // Segments that two changes left as they were will probably not change again, so they are added
  // to the mask. In the mask they may look slightly different, so their area is repainted.
  // If the stroke is known, only stable segments are added, because the others may change later.
  const std::size_t settled = wet_.settled;
  const std::size_t most = overlay.ink_stroke != 0 ? std::min(overlay.ink_stable, n) : n;
  if (changes) settle(wet_, std::min(std::exchange(wet_.firm, n), most));
  return QRegion(view_.part_of(box)) + view_.part_of(wet_.dabs.bounds(settled, wet_.settled));
}

PixelRect WetInkView::screen() const {
  return view_.pixels_of(QRectF(QPointF(0, 0), view_.view.size()));
}

void WetInkView::unsettle(Row& row) const {
  row.settled = row.firm = 0;
  row.mask.clear();
}

void WetInkView::restyle(Row& row) {
  const StrokeStyle* style = outline_mode_ ? nullptr : grain_.styles().find(row.medium);
  row.has_style = style && row.segments.size() <= kMaxStyled;
  row.styled.clear();
  if (!row.has_style) return;
  unsettle(row);
  row.dabs.trace_styled(styler_, *style, row.styled);
}

void WetInkView::settle(Row& row, std::size_t to) {
  if (to <= row.settled || row.has_style) return;
  const PixelRect all = screen();
  if (row.mask.empty()) {
    row.mask.assign(static_cast<std::size_t>(all.width()) * static_cast<std::size_t>(all.height()),
                    0);
  }
  const std::size_t from = std::exchange(row.settled, to);
  const QRect part = view_.part_of(row.dabs.bounds(from, to));
  const PixelRect pixels = view_.pixels_of(QRectF(part)).intersected(all);
  if (part.isEmpty() || pixels.empty()) return;
  // Fills earlier segments here, too: if the line crosses itself, two coverages cannot be combined.
  const QImage& cover = brush_.cover(row.dabs, 0, to, pixels);
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    const auto* line = reinterpret_cast<const QRgb*>(cover.constScanLine(y - pixels.y0));
    std::uint8_t* kept = row.mask.data() + static_cast<std::ptrdiff_t>(y) * all.width() + pixels.x0;
    for (int x = 0; x < pixels.width(); ++x) {
      kept[x] = std::max(kept[x], static_cast<std::uint8_t>(qAlpha(line[x])));
    }
  }
}

void WetInkView::dry() {
  if (is_empty()) return;
  drying_.push_back(std::exchange(wet_, Row{}));
  wet_.dabs.set_view(view_);
}

QRect WetInkView::release() {
  Rect box;
  for (const Row& row : std::exchange(drying_, {})) box.extend(row.dabs.bounds());
  return view_.part_of(box);
}

double WetInkView::width_mm() const noexcept {
  return is_empty() ? 0.0 : wet_.segments.back().end_width_mm;
}

void WetInkView::paint(QPainter& painter, const QRect& part, const Cover& cover) {
  for (const Row& row : drying_) paint_row(painter, part, row, cover);
  paint_row(painter, part, wet_, cover);
}

void WetInkView::paint_row(QPainter& painter, const QRect& part, const Row& row,
                           const Cover& cover) {
  const QRect ink = part & view_.part_of(row.dabs.bounds());
  const PixelRect pixels = view_.pixels_of(QRectF(ink)).intersected(screen());
  if (ink.isEmpty() || pixels.empty()) return;
  QImage& image = row.has_style ? brush_.cover(row.styled, pixels)
                                : brush_.cover(row.dabs, row.settled, DabRows::kAll, pixels);
  ink_pixels(image, pixels, row);
  if (cover) cover(image, {pixels.x0, pixels.y0});
  draw_pixels(painter, image, pixels, view_.dpr);
}

/// For each pixel of `pixels`, computes how hard the pen pressed there, which determines the grain,
/// and how often it was there.
void WetInkView::lay(const PixelRect& pixels, const Row& row, const InkLook& look) {
  pressure_.begin(pixels, look.edge);
  row.dabs.ways(pixels, [&](std::span<const Dab> dabs, std::span<const double> travels) {
    way_.clear();
    for (std::size_t i = 0; i < dabs.size(); ++i) {
      const Dab& dab = dabs[i];
      way_.push_back({{dab.center.x, dab.center.y}, dab.radius_mm, dab.tone, travels[i]});
    }
    pressure_.lay(way_);
  });
  look.builds_up ? visits_.find(pressure_, 0.0) : visits_.clear();
}

/// Turns coverage into colour. For each pixel, uses the mask's coverage if it is larger.
void WetInkView::ink_pixels(QImage& image, const PixelRect& pixels, const Row& row) {
  const auto look = outline_mode_ ? nullptr : grain_.look(row.medium, view_.px_per_mm());
  std::optional<InkShade> shade;
  if (look) shade.emplace(*look, view_.as_view());
  const Rgba color = row.color;
  const int opacity = outline_mode_ ? 255 : color.a;
  std::array<QRgb, 256> inks{};
  for (int c = 0; c < 256; ++c) {
    inks[static_cast<std::size_t>(c)] =
        qPremultiply(qRgba(color.r, color.g, color.b, (c * opacity + 127) / 255));
  }
  const int width = screen().width();
  std::vector<std::uint8_t> alphas(static_cast<std::size_t>(pixels.width()));
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    if (look && (y - pixels.y0) % kBandRows == 0) {
      lay({pixels.x0, y, pixels.x1, std::min(y + kBandRows, pixels.y1)}, row, *look);
    }
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y - pixels.y0));
    const std::uint8_t* kept =
        row.mask.empty() ? nullptr
                         : row.mask.data() + static_cast<std::ptrdiff_t>(y) * width + pixels.x0;
    for (int x = 0; x < pixels.width(); ++x) {
      alphas[static_cast<std::size_t>(x)] =
          static_cast<std::uint8_t>(std::max(qAlpha(line[x]), kept ? int{kept[x]} : 0));
    }
    if (shade) shade->row(pressure_, visits_, pixels.x0, y, pixels.width(), alphas.data());
    for (int x = 0; x < pixels.width(); ++x) line[x] = inks[alphas[static_cast<std::size_t>(x)]];
  }
}

DabRows& BandView::rows_of(Overlay::Role role) {
  for (auto& [known, rows] : bands_) {
    if (known == role) return rows;
  }
  bands_.emplace_back(role, DabRows{}).second.set_view(view_);
  return bands_.back().second;
}

void BandView::add(const Overlay::Span& span) {
  const double width = span.width_mm + kBandPx / view_.view.px_per_mm();
  rows_of(span.role).add({span.curve, width, width}, kMinBandPx * view_.dpr);
}

void BandView::set_view(const DeviceView& view) {
  view_ = view;
  bands_.clear();
  for (const Overlay::Span& span : spans_) add(span);
}

QRect BandView::update(std::span<const Overlay::Span> spans) {
  const std::size_t n = common(std::span<const Overlay::Span>(spans_), spans);
  if (n == spans.size() && n == spans_.size()) return {};
  Rect box;
  std::vector<std::pair<Overlay::Role, std::size_t>> kept;
  for (auto& [role, rows] : bands_) {
    const auto stays = static_cast<std::size_t>(
        std::count_if(spans_.begin(), spans_.begin() + static_cast<std::ptrdiff_t>(n),
                      [role = role](const Overlay::Span& span) { return span.role == role; }));
    box.extend(rows.bounds(stays));
    rows.keep(stays);
    kept.emplace_back(role, stays);
  }
  spans_.assign(spans.begin(), spans.end());
  for (const Overlay::Span& span : spans.subspan(n)) add(span);
  for (const auto& [role, rows] : bands_) {
    const auto known = std::find_if(kept.begin(), kept.end(),
                                    [role = role](const auto& k) { return k.first == role; });
    box.extend(rows.bounds(known == kept.end() ? 0 : known->second));
  }
  return view_.part_of(box);
}

}  // namespace felt::desktop
