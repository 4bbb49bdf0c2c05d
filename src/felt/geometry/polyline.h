#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// Queries on polylines: points joined by straight lines, such as raw pen samples. Repeated points
/// are allowed everywhere; each function says what it returns for an empty polyline.

/// The nearest point of the straight line segment a + t (b - a).
struct LineNearest {
  double t = 0.0;  ///< 0..1
  double distance_squared = 0.0;
  Point point;
};

/// Returns the point of the straight segment from a to b that is nearest to p; t = 0 if a == b.
LineNearest nearest_on_line(Point a, Point b, Point p) noexcept;

/// The nearest point of a polyline: on the line from point `index` to the next one.
struct PolylineNearest {
  std::size_t index = 0;
  double t = 0.0;  ///< 0..1 on that line
  double distance_squared = 0.0;
  Point point;
};

/// Returns the point nearest to p. If several points have the same distance, returns the first.
/// Linear in the number of points. An empty polyline is infinitely far; a single point is a line of
/// length zero.
PolylineNearest nearest_on_polyline(std::span<const Point> line, Point p) noexcept;

/// Returns the length in mm; 0 for fewer than two points.
double polyline_length(std::span<const Point> line) noexcept;

/// Returns the point at arc length `length_mm` from the first point, clamped to the ends; (0, 0) if
/// the polyline is empty.
Point point_at_length(std::span<const Point> line, double length_mm) noexcept;

/// Fills `out` with points at equal distances along the line, including both ends exactly. If `out`
/// has a single element, it gets the first point; for an empty line all elements become (0, 0).
/// Linear in the sizes of `line` and `out`.
void resample(std::span<const Point> line, std::span<Point> out) noexcept;

/// Queries on polygons: closed polylines whose last point is joined to the first. The first point
/// may, but need not, be repeated at the end. Polygons may cross themselves, repeat points and have
/// any orientation.

/// The rule that decides which points are inside a self-crossing polygon.
enum class FillRule : std::uint8_t {
  kEvenOdd,  ///< points from which a ray crosses an odd number of edges
  kNonZero,  ///< points with a winding number other than zero
};

/// Returns true if p is inside or on an edge. An edge has a width of 4 ulp of its largest
/// coordinate, so that a point that was computed to lie on an edge counts as on the edge despite
/// rounding. A polygon of one point contains that point; an empty one contains nothing. False if p
/// is not finite.
bool contains(std::span<const Point> polygon, Point p, FillRule rule) noexcept;

/// Returns the signed area in mm^2 by the shoelace formula about the first point; positive if the
/// boundary turns from +x to +y (clockwise as the user sees it). Parts enclosed twice count twice.
double area(std::span<const Point> polygon) noexcept;

/// Simplifies an open polyline with the Douglas-Peucker algorithm: sets `keep` to 1 for the points
/// that are kept and to 0 for the others. Every dropped point lies within `tolerance_mm` of the
/// line between its kept neighbours; the ends are kept. Requires `keep` and `line` to have the same
/// size. Returns the number of kept points. Does not allocate or recurse, because the marks serve
/// as the stack. Usually takes n log n time, in the worst case n^2. To simplify a closed outline,
/// pass it as an open polyline with its first point repeated. Source: Douglas, Peucker, "Algorithms
/// for the reduction of the number of points required to represent a digitized line", 1973.
std::size_t mark_simplified(std::span<const Point> line, double tolerance_mm,
                            std::span<std::uint8_t> keep) noexcept;

/// Returns the points that `mark_simplified` keeps. Allocates.
std::vector<Point> simplified(std::span<const Point> line, double tolerance_mm);

}  // namespace felt
