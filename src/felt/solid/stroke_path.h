#pragma once

#include <optional>
#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/geometry/vec3.h"

namespace felt {

/// Returns the length of a polyline, in mm.
double path_length(std::span<const Point> path) noexcept;

/// Returns points on a polyline at equal distances of about `step_mm`, with both ends. Requires a
/// point and a step above 0.
std::vector<Point> resampled(std::span<const Point> path, double step_mm);

/// Returns `count` points on a closed polyline at equal distances, the first at its first point.
/// The last point is joined to the first. Requires 3 points and a length above 0.
std::vector<Point> resampled_ring(std::span<const Point> ring, int count);

/// Returns the index of a point at which a polyline crosses itself, or nullopt. Neighbouring
/// segments that fold back count. `is_closed` joins the last point to the first.
enum class PathEnds { kOpen, kClosed };
std::optional<std::size_t> self_crossing(std::span<const Point> path, PathEnds ends);

/// Returns the area inside a closed polyline in mm^2: positive if it turns from +x to +y.
double ring_area(std::span<const Point> ring) noexcept;

}  // namespace felt
