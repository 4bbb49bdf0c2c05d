#pragma once

#include <cmath>
#include <cstdint>

#include "felt/geometry/vec3.h"

namespace felt {

/// Bounds of Capabilities::sheet_scale.
inline constexpr double kSmallestSheetScale = 0.5;
inline constexpr double kLargestSheetScale = 2.0;

/// What a device can do, in the units of the sheet frame (R55). Trivially copyable, so that the
/// haptic thread, the force models' makers and the limiter all read the same numbers. Zero forces
/// describe a mouse or a tablet.
struct Capabilities {
  int sensed_axes = 3;
  int actuated_axes = 3;
  double max_force_n = 0.0;         ///< nominal peak
  double continuous_force_n = 0.0;  ///< what the motors stand for good
  /// What we ask of it at most; 0 = no such advice (devices.md 10.2, "F clamp").
  double advised_force_n = 0.0;
  double max_stiffness_n_per_m = 0.0;  ///< of a wall, by the maker or by CHAI3D's table
  double max_damping_n_s_per_m = 0.0;  ///< likewise
  Vec3 workspace_min{-80, -60, -35};   ///< mm
  Vec3 workspace_max{80, 60, 35};      ///< mm
  double position_step_mm = 0.0;       ///< resolution of the position; 0 = not known
  std::int64_t period_ns = 1'000'000;  ///< of its servo loop, 0.2..4 ms
  int delay_ticks = 1;                 ///< ticks from reading a position to its force
  bool senses_pressure = false;
  /// Millimetres of the sheet for one of the hand, 0.5..2 (PlaneCalibration::scale). All lengths,
  /// stiffness and damping above are the sheet's; a newton is a newton. limits_for() holds what it
  /// holds where the hand is.
  double sheet_scale = 1.0;

  /// True when it pushes back at all.
  [[nodiscard]] constexpr bool has_force() const noexcept {
    return actuated_axes > 0 && max_force_n > 0.0;
  }
  friend constexpr bool operator==(const Capabilities&, const Capabilities&) noexcept = default;
};

/// Returns a number of a device, or 0 if it is not finite and positive.
inline double finite_positive(double value) noexcept {
  return std::isfinite(value) && value > 0.0 ? value : 0.0;
}

}  // namespace felt
