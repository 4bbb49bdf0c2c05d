#pragma once

#include "felt/geometry/point.h"
#include "felt/geometry/rect.h"

namespace felt {

inline constexpr double kMmPerInch = 25.4;

/// Which place of the sheet a picture shows, how large, and how it lies.
struct View {
  Point origin_mm;         ///< what lies at the top left corner of the top left pixel
  double px_per_mm = 1.0;  ///< more is closer; > 0
  /// Where the sheet's x axis points in the picture, clockwise, (cos, sin): of length 1.
  Vec turn{1.0, 0.0};
  /// Left and right change places, after the turn.
  bool is_mirrored = false;

  friend constexpr bool operator==(const View&, const View&) noexcept = default;

  /// A picture of `dpi` dots per inch that begins at `origin_mm`.
  static constexpr View at_dpi(Point origin_mm, double dpi) noexcept {
    return {origin_mm, dpi / kMmPerInch};
  }
  /// Pixel coordinates of a place.
  [[nodiscard]] constexpr Vec to_px(Point p) const noexcept {
    const Vec d = px_per_mm * (p - origin_mm);
    const double x = turn.x * d.x - turn.y * d.y;
    return {is_mirrored ? -x : x, turn.y * d.x + turn.x * d.y};
  }
  /// The place at pixel coordinates.
  [[nodiscard]] constexpr Point to_mm(Vec px) const noexcept {
    const double x = is_mirrored ? -px.x : px.x;
    return origin_mm + Vec{turn.x * x + turn.y * px.y, turn.x * px.y - turn.y * x} / px_per_mm;
  }
  /// The same picture from another pixel on.
  [[nodiscard]] constexpr View from(Vec px) const noexcept {
    return {to_mm(px), px_per_mm, turn, is_mirrored};
  }
  /// Around what the pixels from `from` to `to` show.
  [[nodiscard]] constexpr Rect area_mm(Vec from, Vec to) const noexcept {
    Rect area;
    area.extend(to_mm(from));
    area.extend(to_mm({to.x, from.y}));
    area.extend(to_mm(to));
    area.extend(to_mm({from.x, to.y}));
    return area;
  }
  /// Around a part of the sheet, in pixels.
  [[nodiscard]] constexpr Rect area_px(const Rect& mm) const noexcept {
    Rect area;
    for (const Point corner :
         {Point{mm.x0, mm.y0}, Point{mm.x1, mm.y0}, Point{mm.x1, mm.y1}, Point{mm.x0, mm.y1}}) {
      const Vec px = to_px(corner);
      area.extend(Point{px.x, px.y});
    }
    return area;
  }
};

}  // namespace felt
