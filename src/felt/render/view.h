#pragma once

#include "felt/geometry/point.h"
#include "felt/geometry/rect.h"

namespace felt {

inline constexpr double kMmPerInch = 25.4;

/// The part of the page that a picture shows, its scale and its orientation.
struct View {
  Point origin_mm;         ///< the point at the top left corner of the top left pixel
  double px_per_mm = 1.0;  ///< zoom; > 0
  /// Direction of the page's x axis in the picture, as (cos, sin) of a clockwise angle.
  Vec turn{1.0, 0.0};
  /// Mirrors left and right, after the rotation.
  bool is_mirrored = false;

  friend constexpr bool operator==(const View&, const View&) noexcept = default;

  /// Returns the view of a picture with `dpi` dots per inch that begins at `origin_mm`.
  static constexpr View at_dpi(Point origin_mm, double dpi) noexcept {
    return {origin_mm, dpi / kMmPerInch};
  }
  /// Returns the pixel coordinates of a point.
  [[nodiscard]] constexpr Vec to_px(Point p) const noexcept {
    const Vec d = px_per_mm * (p - origin_mm);
    const double x = turn.x * d.x - turn.y * d.y;
    return {is_mirrored ? -x : x, turn.y * d.x + turn.x * d.y};
  }
  /// Returns the point at pixel coordinates.
  [[nodiscard]] constexpr Point to_mm(Vec px) const noexcept {
    const double x = is_mirrored ? -px.x : px.x;
    return origin_mm + Vec{turn.x * x + turn.y * px.y, turn.x * px.y - turn.y * x} / px_per_mm;
  }
  /// Returns the view of the same picture starting at another pixel.
  [[nodiscard]] constexpr View from(Vec px) const noexcept {
    return {to_mm(px), px_per_mm, turn, is_mirrored};
  }
  /// Returns the bounds of the area that the pixels from `from` to `to` show.
  [[nodiscard]] constexpr Rect area_mm(Vec from, Vec to) const noexcept {
    Rect area;
    area.extend(to_mm(from));
    area.extend(to_mm({to.x, from.y}));
    area.extend(to_mm(to));
    area.extend(to_mm({from.x, to.y}));
    return area;
  }
  /// Returns the bounds of an area of the page, in pixels.
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
