#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// A polygon near a closed path.
struct PolygonFit {
  std::vector<Point> corners;  ///< in the order of the path
  double rms_mm = 0.0;         ///< of the distances of the points from the polygon
  /// Share of all turning of the path that is near the corners, 0..1: near 1 for straight sides,
  /// and no more than the share of the path that counts as near for a circle.
  double corner_share = 0.0;
};

/// The most corners of a polygon that is fitted.
inline constexpr std::size_t kMaxCorners = 6;

/// Returns the polygon with `count` corners that fits a closed path best. `path` has points at
/// equal distances, without the first one repeated. The path is cut at the sharpest turn, and then
/// into sides with the least sum of squared distances from straight lines, by dynamic programming
/// (Perez, Vidal, "Optimum polygonal approximation of digitized curves",
/// DOI 10.1016/0167-8655(94)90002-7). The corners are where the lines of neighbouring sides meet.
/// Returns nullopt if `count` is not 3..kMaxCorners or the path has fewer than 4 points for each
/// side.
std::optional<PolygonFit> fit_polygon(std::span<const Point> path, std::size_t count);

/// Returns the rectangle nearest to a polygon with four corners, or nullopt if a corner differs
/// from a right angle by more than `max_deg`. Its sides are parallel to the mean direction of the
/// polygon's sides, and as far from its middle as their middles.
std::optional<std::vector<Point>> squared(std::span<const Point> corners, double max_deg);

/// Returns the root mean square of the distances of points from a closed polygon.
double rms_to_polygon(std::span<const Point> points, std::span<const Point> corners);

}  // namespace felt
