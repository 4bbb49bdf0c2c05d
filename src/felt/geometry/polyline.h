#pragma once

#include <cstddef>
#include <span>

#include "felt/geometry/point.h"

namespace felt {

/// Queries on polylines: points joined by straight lines, such as raw pen samples. Repeated points
/// are allowed everywhere; an empty polyline has the answer stated with each function.

/// Nearest point of the straight line segment a + t (b - a).
struct LineNearest {
  double t = 0.0;  ///< 0..1
  double distance_squared = 0.0;
  Point point;
};

/// Nearest point to p of the straight segment from a to b; t = 0 when a == b.
LineNearest nearest_on_line(Point a, Point b, Point p) noexcept;

/// Nearest point of a polyline: on the line from point `index` to the next one.
struct PolylineNearest {
  std::size_t index = 0;
  double t = 0.0;  ///< 0..1 on that line
  double distance_squared = 0.0;
  Point point;
};

/// Nearest point to p; of equal distances the first. Linear in the number of points. An empty
/// polyline is infinitely far; a single point is a line of length zero.
PolylineNearest nearest_on_polyline(std::span<const Point> line, Point p) noexcept;

/// Length in mm; 0 for fewer than two points.
double polyline_length(std::span<const Point> line) noexcept;

/// The point at `length_mm` from the first, clamped to the ends; (0, 0) when empty.
Point point_at_length(std::span<const Point> line, double length_mm) noexcept;

/// Fills `out` with points at equal distances along the line, both ends included exactly. A single
/// place in `out` gets the first point; an empty line gives (0, 0) everywhere. Linear in both.
void resample(std::span<const Point> line, std::span<Point> out) noexcept;

}  // namespace felt
