#pragma once

#include <span>

#include "felt/geometry/cubic.h"

namespace felt {

/// Returns the area in mm^2 between the curve and the straight lines from its ends to `origin`, by
/// Green's theorem; exact up to rounding. The sum over a closed loop is its signed area, positive
/// if it turns from +x to +y.
double area_under(const Cubic& c, Point origin) noexcept;

/// Returns the signed area in mm^2 of a closed loop.
double loop_area(std::span<const Cubic> loop) noexcept;

/// Returns how often the curve crosses the ray from p in the direction of +x, modulo 2. An end on
/// the line of the ray belongs to the side of smaller y, so that the sum over a closed loop is odd
/// exactly if p is inside.
int ray_parity(const Cubic& c, Point p) noexcept;

/// Returns true if p is inside the loop of 3n + 1 control points by the even-odd rule.
bool is_inside(std::span<const Point> loop, Point p) noexcept;

}  // namespace felt
