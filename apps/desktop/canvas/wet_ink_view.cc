#include "desktop/canvas/wet_ink_view.h"

#include <algorithm>
#include <utility>

namespace felt::desktop {
namespace {

constexpr double kHairPx = 1.0;  // device-independent, of outline mode
constexpr double kBandPx = 7.0;  // that much broader than its ink
constexpr double kLeastBandPx = 9.0;
constexpr double kPressStep = 0.25;  // of the tip's radius, as PressureMap asks

bool same(const Overlay::InkSegment& a, const Overlay::InkSegment& b) {
  return a.curve == b.curve && a.start_width_mm == b.start_width_mm &&
         a.end_width_mm == b.end_width_mm;
}
bool same(const Overlay::Span& a, const Overlay::Span& b) {
  return a.curve == b.curve && a.width_mm == b.width_mm && a.role == b.role;
}

/// How many of both begin alike.
template <class T>
std::size_t common(std::span<const T> a, std::span<const T> b) {
  const std::size_t most = std::min(a.size(), b.size());
  std::size_t n = 0;
  while (n < most && same(a[n], b[n])) ++n;
  return n;
}

QRectF ink_part(const QRectF& part, const DeviceView& view, const DabRows& rows) {
  return part.intersected(QRectF(view.part_of(rows.bounds())));
}

}  // namespace

PixelRect InkBrush::prepare(const QRectF& part, const DeviceView& view, const DabRows& rows) {
  const QRectF ink = ink_part(part, view, rows);
  if (ink.isEmpty()) return {};
  const PixelRect pixels = view.pixels_of(ink);
  image_ = QImage(pixels.width(), pixels.height(), QImage::Format_ARGB32_Premultiplied);
  image_.fill(Qt::transparent);
  image_.setDevicePixelRatio(view.dpr);
  outline_.clear();
  rows.trace(pixels, outliner_, outline_);
  return outline_.points.empty() ? PixelRect{} : pixels;
}

void InkBrush::fill(const PixelRect& pixels, Rgba color) {
  const Pixels target{image_.bits(), image_.width(), image_.height(), image_.bytesPerLine(),
                      PixelOrder::kBgra};
  const View place{{static_cast<double>(pixels.x0), static_cast<double>(pixels.y0)}, 1.0};
  rasterizer_.fill(outline_, place, target.rect(), color, target);
}

void InkBrush::paint(QPainter& painter, const QRectF& part, const DeviceView& view,
                     const DabRows& rows, Rgba color) {
  const PixelRect pixels = prepare(part, view, rows);
  if (pixels.empty()) return;
  fill(pixels, color);
  painter.drawImage(QPointF(pixels.x0 / view.dpr, pixels.y0 / view.dpr), image_);
}

void InkBrush::paint(QPainter& painter, const QRectF& part, const DeviceView& view,
                     const DabRows& rows, Rgba color, const Grain& grain, double share) {
  if (grain.is_smooth() || !(share > 0.0)) return paint(painter, part, view, rows, color);
  const PixelRect pixels = prepare(part, view, rows);
  if (pixels.empty()) return;
  fill(pixels, {255, 255, 255, 255});
  press(rows, view, pixels);
  for (int y = 0; y < image_.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(image_.scanLine(y));
    for (int x = 0; x < image_.width(); ++x) {
      if (qAlpha(line[x]) == 0) continue;
      const Point place = view.to_mm({pixels.x0 + x + 0.5, pixels.y0 + y + 0.5});
      const auto pressure = static_cast<double>(pressure_.at(pixels.x0 + x, pixels.y0 + y));
      const double alpha = qAlpha(line[x]) * color.a / 255.0 * grain.alpha(place, pressure, share);
      line[x] = qPremultiply(qRgba(color.r, color.g, color.b, qRound(alpha)));
    }
  }
  painter.drawImage(QPointF(pixels.x0 / view.dpr, pixels.y0 / view.dpr), image_);
}

void InkBrush::press(const DabRows& rows, const DeviceView& view, const PixelRect& pixels) {
  pressure_.begin(pixels);
  rows.walk(pixels, kPressStep, [&](const Dab& dab) {
    pressure_.press({dab.center.x, dab.center.y}, dab.radius_mm,
                    pressure_of_width(2.0 * dab.radius_mm / view.px_per_mm()));
  });
}

void WetInkView::add(Row& row, const Overlay::InkSegment& segment) const {
  Overlay::InkSegment shown = segment;
  if (outline_mode_) shown.start_width_mm = shown.end_width_mm = 0.0;
  row.dabs.add(shown, outline_mode_ ? kHairPx * view_.dpr : 0.0);
}

void WetInkView::set_view(const DeviceView& view) {
  view_ = view;
  const auto remake = [this](Row& row) {
    row.dabs.clear();
    row.dabs.set_view(view_);
    for (const Overlay::InkSegment& segment : row.segments) add(row, segment);
  };
  remake(wet_);
  for (Row& row : drying_) remake(row);
}

void WetInkView::set_grain(const Grain& grain, double share) {
  grain_ = grain;
  share_ = share;
}

void WetInkView::set_outline_mode(bool on) {
  outline_mode_ = on;
  set_view(view_);
}

QRect WetInkView::update(std::span<const Overlay::InkSegment> ink, Rgba color) {
  if (ink.empty() && wet_.segments.empty()) return {};
  std::size_t n = common(std::span<const Overlay::InkSegment>(wet_.segments), ink);
  if (color != wet_.color || wet_.segments.empty()) n = 0;
  Rect box = wet_.dabs.bounds(n);
  wet_.segments.resize(n);
  wet_.dabs.keep(n);
  wet_.color = color;
  wet_.share = share_;
  for (const Overlay::InkSegment& segment : ink.subspan(n)) {
    wet_.segments.push_back(segment);
    add(wet_, segment);
  }
  box.extend(wet_.dabs.bounds(n));
  return view_.part_of(box);
}

void WetInkView::dry() {
  if (is_empty()) return;
  drying_.push_back(std::exchange(wet_, Row{}));
  wet_.dabs.set_view(view_);
}

QRect WetInkView::let_go() {
  Rect box;
  for (const Row& row : std::exchange(drying_, {})) box.extend(row.dabs.bounds());
  return view_.part_of(box);
}

double WetInkView::width_mm() const noexcept {
  return is_empty() ? 0.0 : wet_.segments.back().end_width_mm;
}

void WetInkView::paint(QPainter& painter, const QRect& part, InkBrush& brush) const {
  const auto show = [&](const Row& row) {
    Rgba color = row.color;
    if (outline_mode_) color.a = 255;
    brush.paint(painter, part, view_, row.dabs, color, grain_, outline_mode_ ? 0.0 : row.share);
  };
  for (const Row& row : drying_) show(row);
  show(wet_);
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
  rows_of(span.role).add({span.curve, width, width}, kLeastBandPx * view_.dpr);
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
