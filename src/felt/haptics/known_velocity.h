#pragma once

#include "felt/geometry/vec.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// Speeds below this are not damped.
inline constexpr double kUnknownSpeedMmPerS = 6.0;

/// The velocity in the sheet that dampers may trust: shortened by 6 mm/s, zero below.
///
/// One step of a position sensor (0.03 mm) shows in a velocity low-passed at 100 Hz as 12 mm/s at
/// 1 kHz and 17 mm/s at 5 kHz, whether the pen made a step or crept over an edge. At rest, dampers
/// of 3 N s/m in sum turn that into kicks that keep a frictionless pen dancing between two steps:
/// 0.031 N above 30 Hz at 1 kHz and 0.038 N at 5 kHz beside stiffnesses of 900 N/m, and with this
/// 0.018 and 0.023 N (spring_test.cc holds the bound). What is left undamped is smaller than 0.05
/// mm at 20 Hz. Shortening keeps the direction, so a damper still only takes energy.
inline Vec known_velocity(const PenSample& sample) noexcept {
  const Vec v = in_plane(sample.velocity);
  const double speed = norm(v);
  return speed > kUnknownSpeedMmPerS ? ((speed - kUnknownSpeedMmPerS) / speed) * v : Vec{};
}

}  // namespace felt
