#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// The number of points by which shapes are compared.
inline constexpr std::size_t kShapePoints = 24;

/// What the correspondence compares of a stroke.
struct StrokeShape {
  /// Points at equal distances along the stroke, from end to end; of a closed stroke from its seam
  /// once around, without the seam at the end.
  std::array<Point, kShapePoints> points{};
  Point centre{};            ///< the mean of the points
  double length_mm = 0.0;    ///< > 0
  double turning_rad = 0.0;  ///< sum of the turns between the points, positive from +x to +y
  bool closed = false;
};

/// Returns the shape of a stroke.
StrokeShape shape_of(const Stroke& stroke);
/// Returns the shape of an open line through these points. Requires at least one point.
StrokeShape shape_of(std::span<const Point> line);
/// Returns points along a stroke, including all joints: straight lines between them are close to
/// it.
std::vector<Point> coarse_line(const Stroke& stroke);

/// How the points of one shape are paired with those of another.
struct ShapePairing {
  double distance_mm = 0.0;  ///< the mean distance of paired points
  bool reversed = false;     ///< the second shape runs the other way
  std::size_t shift = 0;     ///< of a closed shape: its point that is paired with the first one
};

/// Returns the best pairing of two shapes at their positions. Tries both directions, and if a shape
/// is closed, all starts on it. If every pairing is worse than `limit_mm`, returns any of them,
/// with a distance of at least the limit.
ShapePairing pair_shapes(const StrokeShape& a, const StrokeShape& b,
                         double limit_mm = 1e300) noexcept;

/// Returns point i of `b` in the order of a pairing.
Point paired_point(const StrokeShape& b, const ShapePairing& pairing, std::size_t i) noexcept;

}  // namespace felt
