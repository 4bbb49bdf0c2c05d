#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

/// Queries on polygons: closed polylines whose last point is joined to the first (which need not be
/// repeated). They may cross themselves, repeat points and have any orientation.

/// Which points a self-crossing polygon contains.
enum class FillRule : std::uint8_t {
  kEvenOdd,  ///< those that a ray leaves through an odd number of edges
  kNonZero,  ///< those that the boundary goes round, in whichever direction
};

/// True when p lies inside or on an edge. An edge is as wide as rounding makes it, 4 ulp of its
/// largest coordinate, so that a point computed on an edge is found there. A polygon of one point
/// contains that point, the empty one nothing, and none a point that is not finite.
bool contains(std::span<const Point> polygon, Point p, FillRule rule) noexcept;

/// Signed area in mm^2 by the shoelace formula about the first point; positive when the boundary
/// turns from +x to +y (clockwise as seen). Parts gone round twice count twice.
double area(std::span<const Point> polygon) noexcept;

/// Marks with 1 in `keep` the points of an open polyline that Douglas-Peucker keeps: every dropped
/// point lies within `tolerance_mm` of the line between its kept neighbours; the ends are kept.
/// `keep` needs as many places as `line`. Returns the number kept. No allocation, no recursion (the
/// marks are the stack); n log n as a rule, n^2 at worst. A closed outline is simplified as the
/// open polyline with its first point repeated.
/// Source: Douglas, Peucker, "Algorithms for the reduction of the number of points required to
/// represent a digitized line", 1973.
std::size_t mark_simplified(std::span<const Point> line, double tolerance_mm,
                            std::span<std::uint8_t> keep) noexcept;

/// The points that `mark_simplified` keeps. Allocates.
std::vector<Point> simplified(std::span<const Point> line, double tolerance_mm);

}  // namespace felt
