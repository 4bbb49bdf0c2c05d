#pragma once

#include <algorithm>
#include <cstdint>

#include "felt/geometry/point.h"

namespace felt {

/// Says what happens to the distance between pen and curve at the touch.
enum class TouchOffset : std::uint8_t {
  kBlendedOut,  ///< the curve moves to the pen gradually (paper, eq. 6)
  kKept,        ///< the curve keeps its distance from the pen
};

/// Returns the distance in mm that the pen must have from the point of the touch so that the offset
/// is completely blended out. This distance is at least the length of the offset, so that the curve
/// never moves more than 2.5 times as fast as the pen.
inline double blend_length_mm(Vec offset) noexcept {
  constexpr double kShortestMm = 3.0;
  return std::max(kShortestMm, norm(offset));
}

/// Returns the displacement of the curve if the pen has moved by `pen` since the touch.
///
///   V = D + S(|D|/L) o,   S(x) = 3x^2 - 2x^3, 1 for x >= 1
///
/// with D the displacement of the pen, o the offset from the curve to the pen at the touch and L
/// its blend length. The curve does not jump at the touch, and it is at the pen if |D| >= L. V
/// depends on D alone, so moving back undoes a pull exactly (R21, R23).
inline Vec curve_displacement(Vec pen, Vec offset, TouchOffset mode) noexcept {
  if (mode == TouchOffset::kKept) return pen;
  const double x = std::min(norm(pen) / blend_length_mm(offset), 1.0);
  return pen + x * x * (3.0 - 2.0 * x) * offset;
}

}  // namespace felt
