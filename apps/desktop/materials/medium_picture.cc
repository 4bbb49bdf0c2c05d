#include "desktop/materials/medium_picture.h"

#include <algorithm>
#include <cmath>

#include "felt/material/relief.h"
#include "felt/render/page_painter.h"
#include "felt/stroke/fit/width_map.h"
#include "felt/tools/medium_line.h"

namespace felt::desktop {
namespace {

constexpr double kMmPerPx = 25.4 / 96.0;  // a device-independent pixel is 1/96 inch
constexpr double kFullestShare = 0.86;    // largest share of the available height that a stroke
                                          // uses
constexpr double kWaveShare = 0.10;       // amplitude of the stroke's wave, as a share of that
                                          // height
constexpr double kLightest = 0.06, kHardest = 0.95;
constexpr int kSegments = 3, kKnots = 12;
constexpr double kMinContrast = 60.0;  // difference of brightness, in 255 levels of grey

Rgba rgba_of(const QColor& color) {
  return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
          static_cast<std::uint8_t>(color.blue()), 255};
}

/// Returns the line widths that the pencil tool uses with this medium.
WidthMapOptions widths_of(const Medium& medium) {
  InkFitOptions ink;
  ink.width_map.min_mm = medium.line.min_mm;
  ink.width_map.max_mm = medium.line.max_mm;
  ink.width_map.gamma = medium.line.gamma;
  return drawn_with(medium, ink).width_map;
}

/// Returns a gentle wave from left to right within `area`, drawn with a force that changes from
/// `from` to `to`.
Result<Stroke> stroke_in(const MediumPicture& picture, const Rect& area, double from, double to) {
  StrokeData data;
  data.medium = picture.medium.id;
  data.color = rgba_of(picture.ink);
  const WidthMapOptions widths = widths_of(picture.medium);
  const double fullest_mm = kFullestShare * area.height();
  for (int i = 0; i <= kKnots; ++i) {
    const double share = static_cast<double>(i) / kKnots, force = from + (to - from) * share;
    const double width_mm = width_of_pressure(widths, force);
    data.widths.push_back({.u = kSegments * share,
                           .width_mm = std::clamp(width_mm, kMinWidthMm, fullest_mm),
                           .tone = tone_of(widths, force, 0.0)});
  }
  const double first_mm = area.x0 + 0.5 * data.widths.front().width_mm + kMmPerPx;
  const double last_mm = area.x1 - 0.5 * data.widths.back().width_mm - kMmPerPx;
  const double middle_mm = 0.5 * (area.y0 + area.y1), swing_mm = kWaveShare * area.height();
  const double step_mm = (last_mm - first_mm) / kSegments;
  for (int i = 0; i <= 3 * kSegments; ++i) {
    // All joints lie on the middle line. Between them the curve swings smoothly up and down in
    // turn.
    const int in_segment = i % 3, turn = (i / 3) % 2 == 0 ? -1 : 1;
    const double y = in_segment == 0 ? 0.0 : swing_mm * turn;
    data.points.push_back({first_mm + step_mm * i / 3.0, middle_mm + y});
  }
  data.joints.assign(kSegments - 1, JointKind::kSmooth);
  return Stroke::create(std::move(data));
}

}  // namespace

Grain grain_for(const SurfaceMaterial& surface, const Materials& media) {
  return Grain(surface_grain(surface), media);
}

QImage draw_medium(const MediumPicture& picture) {
  const QSizeF size_mm = kMmPerPx * QSizeF(picture.size);
  const std::size_t lines = std::max<std::size_t>(picture.forces.size(), 1);
  const double line_mm = size_mm.height() / static_cast<double>(lines);
  std::vector<StrokePtr> strokes;
  for (std::size_t i = 0; i < lines; ++i) {
    const double top_mm = line_mm * static_cast<double>(i);
    const bool rises = picture.forces.empty();
    const Result<Stroke> stroke =
        stroke_in(picture, {0.0, top_mm, size_mm.width(), top_mm + line_mm},
                  rises ? kLightest : picture.forces[i], rises ? kHardest : picture.forces[i]);
    if (stroke) strokes.push_back(std::make_shared<const Stroke>(*stroke));
  }
  Materials media = Materials::built_in();
  if (!picture.grain) media.put(picture.medium);
  const Result<Image> drawn = render_page(
      strokes, {.dpi = 96.0 * picture.dpr,
                .area = Rect{0.0, 0.0, size_mm.width(), size_mm.height()},
                .paper = rgba_of(picture.paper),

                .grain = picture.grain ? *picture.grain : grain_for(picture.surface, media)});
  if (!drawn) return {};
  QImage image(drawn->bytes().data(), drawn->width(), drawn->height(),
               QImage::Format_RGBA8888_Premultiplied);
  image = image.convertToFormat(QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(picture.dpr);
  return image;
}

QColor readable_ink(const QColor& ink, const QColor& paper) {
  const auto grey = [](const QColor& c) { return qGray(c.rgb()); };
  if (std::abs(grey(ink) - grey(paper)) >= kMinContrast) return ink;
  return grey(paper) > 128 ? QColor(35, 38, 45) : QColor(0xf2, 0xf2, 0xee);
}

}  // namespace felt::desktop
