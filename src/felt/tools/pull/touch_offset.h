#pragma once

#include <algorithm>
#include <cstdint>

#include "felt/geometry/point.h"

namespace felt {

/// What becomes of the distance between the pen and the curve at the touch.
enum class TouchOffset : std::uint8_t {
  kBlendedOut,  ///< the curve comes to the pen (paper, eq. 6)
  kKept,        ///< the curve keeps its distance from the pen
};

/// The distance of the pen from the touch over which an offset is blended out, mm. At least the
/// offset itself, so that the curve never moves more than 2.5 times as fast as the pen.
inline double blend_length_mm(Vec offset) noexcept {
  constexpr double kShortestMm = 3.0;
  return std::max(kShortestMm, norm(offset));
}

/// How far the curve has gone when the pen is displaced by `pen` since the touch.
///
///   V = D + S(|D|/L) o,   S(x) = 3x^2 - 2x^3, 1 from x = 1 on
///
/// with D the displacement of the pen, o the offset from the curve to the pen at the touch and L
/// its blend length. Nothing jumps at the touch, the curve is at the pen from |D| = L on, and V
/// depends on D alone, so that going back undoes a pull exactly (R21, R23).
inline Vec curve_displacement(Vec pen, Vec offset, TouchOffset mode) noexcept {
  if (mode == TouchOffset::kKept) return pen;
  const double x = std::min(norm(pen) / blend_length_mm(offset), 1.0);
  return pen + x * x * (3.0 - 2.0 * x) * offset;
}

}  // namespace felt
