#pragma once

#include <cstdint>

#include "felt/haptics/capabilities.h"

namespace felt {

/// Loop periods that the chain accepts (R50), in ns, and the largest delay.
inline constexpr std::int64_t kShortestPeriodNs = 200'000;
inline constexpr std::int64_t kLongestPeriodNs = 4'000'000;
inline constexpr int kMaxDelayTicks = 100;

/// The numbers of the safety chain (docs/design/limits.md). No result of limits_for() allows more
/// than the defaults do. No tool can change these numbers.
struct SafetyLimits {
  double peak_force_n = 3.0;
  double continuous_force_n = 0.0;  ///< the RMS over any rms_window_s stays below it; 0 = no bound
  double rms_window_s = 10.0;
  double rms_fade_s = 1.0;
  double max_damping_n_s_per_m = 0.0;  ///< half of the device's maximum; 0 = no bound
  double max_stiffness_n_per_m = 0.0;  ///< 0.9 of the device's maximum (R55); 0 = no bound

  double rise_n_per_ms = 0.3;
  double engage_rise_n_per_ms = 0.01;
  double soft_fall_n_per_ms = 0.06;  ///< rate of the fall after a soft fault; after a hard fault,
                                     ///< the force is 0 in one tick

  double engage_below_n = 0.2;  ///< engaging may start if the commanded force is below this
  int engage_ticks = 4;         ///< number of ticks in a row for which the force must be below that
  double engage_s = 0.5;        ///< duration of the ramp that follows

  double brake_from_m_per_s = 0.6;  ///< additional damping grows from this speed
  double brake_n_s_per_m = 2.0;     ///< additional damping at cut_m_per_s
  double cut_m_per_s = 1.0;         ///< cut_samples samples in a row above this speed cut the force
  int cut_samples = 3;
  double cut_now_m_per_s = 2.0;  ///< a single sample above this speed cuts the force

  double jump_mm_per_ms = 3.0;  ///< a sample farther from the last accepted one is not accepted
  double jump_hold_s = 0.002;   ///< the last force is held this long; then a jump is a hard fault

  double silent_damp_s = 0.5;  ///< if the edit thread is silent for this time, only damping remains
  double silent_stop_s =
      2.0;  ///< if it is silent for this time, the force falls to zero (soft fault)
  double silent_damping_n_s_per_m = 2.0;

  double late_s = 0.005;  ///< after a tick that is later than this, the chain engages again, softly
  double very_late_s = 0.020;  ///< if a tick is later than this, the force is zero immediately
  int soft_faults = 3;  ///< this many soft faults within soft_fault_window_s are a hard fault
  double soft_fault_window_s = 10.0;

  double budget_fast_n_per_m = 900.0;  ///< R56: sum of slopes per axis up to 2 ms of delay
  double budget_slow_n_per_m = 600.0;  ///< R56: the budget at 3 ms; it is proportional to 1/delay

  std::int64_t period_ns = 1'000'000;
  int delay_ticks = 1;
};

/// Returns true if every number is valid and does not allow more than its default. The chain uses
/// it as a self-test and outputs no force if it fails.
bool is_sound(const SafetyLimits& limits) noexcept;

/// Returns the limits for a device: peak = min(user, advised, 0.9 nominal), continuous = 0.8 of the
/// rating (docs/design/limits.md#motors), damping = 0.5 and stiffness = 0.9 of the device's maxima
/// (docs/design/limits.md#stiffness-budget, R55). `user_limit_n` is clamped to 0..3 N. NaN and
/// negative numbers count as 0. A device that reports an invalid force or scale gets no force.
///
/// With a scale s (Capabilities::page_scale) the hand feels s times the stiffness and damping on
/// the page, and moves at 1/s of the speed on the page (driver/plane_calibration.h). So that no
/// bound is higher at the hand than it is with s = 1, budgets and brakes are divided by max(1, s),
/// and speeds and jumps are multiplied by min(1, s).
SafetyLimits limits_for(const Capabilities& device, double user_limit_n = 3.0) noexcept;

/// Returns a copy of `device` with advised_force_n lowered to the limit that the user set, so that
/// limits_for() of the copy equals limits_for(device, user_limit_n). Pass it to the session
/// (UseDevice), because the width of a line depends on the force that the device may output
/// (firm_push_n, R14); recordings then contain the limit, too. The copy equals `device` if
/// limits_for(device) is not above the user's limit anyway, and if the user's limit is 0 or less,
/// because forces are off in that case.
Capabilities with_force_limit(const Capabilities& device, double user_limit_n) noexcept;

}  // namespace felt
