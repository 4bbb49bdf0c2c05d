#pragma once

#include <algorithm>
#include <limits>

#include "felt/geometry/point.h"

namespace felt {

/// An axis-parallel rectangle in mm, including its edges. A default-constructed rectangle is empty:
/// it contains nothing, and extending it by a point gives that point.
struct Rect {
  double x0 = std::numeric_limits<double>::infinity();
  double y0 = std::numeric_limits<double>::infinity();
  double x1 = -std::numeric_limits<double>::infinity();
  double y1 = -std::numeric_limits<double>::infinity();

  friend constexpr bool operator==(const Rect&, const Rect&) noexcept = default;

  /// Returns true if the rectangle contains no point.
  [[nodiscard]] constexpr bool empty() const noexcept { return !(x0 <= x1 && y0 <= y1); }
  /// Returns the width in mm; 0 if empty.
  [[nodiscard]] constexpr double width() const noexcept { return empty() ? 0.0 : x1 - x0; }
  /// Returns the height in mm; 0 if empty.
  [[nodiscard]] constexpr double height() const noexcept { return empty() ? 0.0 : y1 - y0; }
  /// Returns true if p is inside or on the edge.
  [[nodiscard]] constexpr bool contains(Point p) const noexcept {
    return p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1;
  }
  /// Returns true if the two rectangles have a common point.
  [[nodiscard]] constexpr bool intersects(const Rect& o) const noexcept {
    return x0 <= o.x1 && o.x0 <= x1 && y0 <= o.y1 && o.y0 <= y1;
  }
  /// Extends the rectangle to contain p.
  constexpr void extend(Point p) noexcept {
    x0 = std::min(x0, p.x);
    y0 = std::min(y0, p.y);
    x1 = std::max(x1, p.x);
    y1 = std::max(y1, p.y);
  }
  /// Extends the rectangle to contain o.
  constexpr void extend(const Rect& o) noexcept {
    x0 = std::min(x0, o.x0);
    y0 = std::min(y0, o.y0);
    x1 = std::max(x1, o.x1);
    y1 = std::max(y1, o.y1);
  }
  /// Returns the rectangle grown by `margin_mm` on each side; an empty one stays empty.
  [[nodiscard]] constexpr Rect inflated(double margin_mm) const noexcept {
    return empty() ? *this : Rect{x0 - margin_mm, y0 - margin_mm, x1 + margin_mm, y1 + margin_mm};
  }
};

/// Returns the squared distance in mm^2 from p to the rectangle; 0 inside, infinity if empty.
constexpr double distance_squared(const Rect& r, Point p) noexcept {
  if (r.empty()) return std::numeric_limits<double>::infinity();
  const double dx = std::max({r.x0 - p.x, 0.0, p.x - r.x1});
  const double dy = std::max({r.y0 - p.y, 0.0, p.y - r.y1});
  return dx * dx + dy * dy;
}

}  // namespace felt
