#pragma once

namespace felt {

/// Returns the strength of a brush at a distance from its centre: 1 - 3x^2 + 2x^3 if x < 1, else 0.
/// `x` is the distance divided by the reach of the brush. Requires x >= 0.
constexpr double bump(double x) noexcept {
  return x < 1.0 ? 1.0 - x * x * (3.0 - 2.0 * x) : 0.0;
}

}  // namespace felt
