#pragma once

#include <array>

#include "felt/geometry/point.h"
#include "felt/geometry/rect.h"

namespace felt {

/// One cubic Bezier segment, control points B1..B4 of the paper [Paper eq. 1]:
///   f(t) = (1-t)^3 B1 + 3t(1-t)^2 B2 + 3t^2(1-t) B3 + t^3 B4
/// A value; any control points are allowed, coincident ones included. All functions on it are
/// total and noexcept: degenerate input has the documented answer.
struct Cubic {
  std::array<Point, 4> p;

  friend constexpr bool operator==(const Cubic&, const Cubic&) noexcept = default;
};

}  // namespace felt
