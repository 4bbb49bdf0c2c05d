#pragma once

#include <cstdint>
#include <vector>

#include "felt/geometry/point.h"

namespace felt::testing {

/// Returns the corner points joined by straight lines, with points about 1 mm apart.
std::vector<Point> joined(const std::vector<Point>& corners);
/// Returns a part of an ellipse: from the angle `from`, over `sweep` radians.
std::vector<Point> ellipse_part(Point center, double a, double b, double from, double sweep,
                                double angle = 0.0);
/// Returns a zigzag with `passes` passes, each `length_mm` long; neighbouring ends on the same side
/// are `advance_mm` apart. Starts at (0, 0) and runs along +x first.
std::vector<Point> zigzag(int passes, double length_mm, double advance_mm);
/// Returns the path with a smooth random deviation of about `rms_mm`.
std::vector<Point> unsteady(std::vector<Point> path, double rms_mm, std::uint64_t seed);
/// Returns the path turned about the origin, scaled, and then moved.
std::vector<Point> placed(std::vector<Point> path, double angle, double scale, Vec by);

}  // namespace felt::testing
