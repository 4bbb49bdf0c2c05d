#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/geometry/rect.h"

namespace felt {

/// Returns `count` points at equal distances along a path, both ends included. Leaves out points
/// that are not in range (is_in_range) and points within `still_mm` of the previous kept one,
/// because a resting pen would otherwise add length. Returns an empty path if fewer than two points
/// remain, or if `count` is less than two.
std::vector<Point> even_path(std::span<const Point> path, std::size_t count, double still_mm = 0.2);

/// Returns the box of the points.
Rect bounds_of(std::span<const Point> path) noexcept;

/// Returns the diagonal of the box of the points, in mm.
double diagonal_mm(std::span<const Point> path) noexcept;

}  // namespace felt
