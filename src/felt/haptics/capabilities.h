#pragma once

#include <cmath>
#include <cstdint>

#include "felt/geometry/vec3.h"

namespace felt {

/// Bounds of Capabilities::page_scale.
inline constexpr double kMinPageScale = 0.5;
inline constexpr double kMaxPageScale = 2.0;

/// What a device can do, in the frame of the surface (R55). Trivially copyable, so that the haptic
/// thread, the code that makes force models, and the limiter all read the same numbers. A mouse or
/// a tablet has zero forces.
struct Capabilities {
  int sensed_axes = 3;
  int actuated_axes = 3;
  double max_force_n = 0.0;         ///< nominal peak force
  double continuous_force_n = 0.0;  ///< force that the motors can hold permanently
  /// The maximum force that we recommend for the device; 0 = no recommendation
  /// (docs/design/devices.md#advised-forces).
  double advised_force_n = 0.0;
  double max_stiffness_n_per_m = 0.0;  ///< of a virtual wall; from the maker or CHAI3D's table
  double max_damping_n_s_per_m = 0.0;  ///< of a virtual damper; from the same source
  Vec3 workspace_min{-80, -60, -35};   ///< mm
  Vec3 workspace_max{80, 60, 35};      ///< mm
  double position_step_mm = 0.0;       ///< resolution of the position; 0 = unknown
  /// What the hand feels of the device without any force: dry friction and moving mass at the tip,
  /// along the page; 0 = unknown.
  double friction_n = 0.0;
  double mass_kg = 0.0;
  std::int64_t period_ns = 1'000'000;  ///< period of the servo loop, 0.2..4 ms
  int delay_ticks = 1;                 ///< ticks from reading a position until its force acts
  bool senses_pressure = false;
  /// Largest push that a line of full width may need, N (firm_push_n). Not a fact of the device: a
  /// session sets it for old recordings, whose lines were drawn with another.
  double full_push_n = 1.2;
  /// Millimetres on the page for one millimetre of the hand, 0.5..2 (PlaneCalibration::scale). The
  /// lengths, stiffness, damping and mass in this struct are those on the page; forces are not
  /// scaled. limits_for() applies its bounds at the hand.
  double page_scale = 1.0;

  /// Returns true if the device can output any force.
  [[nodiscard]] constexpr bool has_force() const noexcept {
    return actuated_axes > 0 && max_force_n > 0.0;
  }
  friend constexpr bool operator==(const Capabilities&, const Capabilities&) noexcept = default;
};

/// Returns a value that a device reported, or 0 unless it is finite and positive.
inline double finite_positive(double value) noexcept {
  return std::isfinite(value) && value > 0.0 ? value : 0.0;
}

}  // namespace felt
