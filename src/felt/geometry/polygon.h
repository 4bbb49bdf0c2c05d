#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

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
