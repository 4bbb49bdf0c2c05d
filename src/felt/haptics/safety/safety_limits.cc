#include "felt/haptics/safety/safety_limits.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

constexpr SafetyLimits kDefaults;

/// Returns true if value is in 0..largest; false for NaN.
constexpr bool within(double value, double largest) noexcept {
  return value >= 0.0 && value <= largest;
}
constexpr bool within_positive(double value, double largest) noexcept {
  return value > 0.0 && value <= largest;
}

bool forces_are_sound(const SafetyLimits& l) noexcept {
  return within(l.peak_force_n, kDefaults.peak_force_n) && within(l.continuous_force_n, 1e3) &&
         within_positive(l.rms_window_s, 3600.0) && within_positive(l.rms_fade_s, 60.0) &&
         within(l.max_damping_n_s_per_m, 1e3) && within(l.max_stiffness_n_per_m, 1e6) &&
         within_positive(l.rise_n_per_ms, kDefaults.rise_n_per_ms) &&
         within_positive(l.engage_rise_n_per_ms, l.rise_n_per_ms) &&
         within_positive(l.soft_fall_n_per_ms, 1e3) &&
         within_positive(l.engage_below_n, kDefaults.engage_below_n) && l.engage_ticks >= 1 &&
         l.engage_ticks <= 1'000'000 && within_positive(l.engage_s, 60.0);
}

bool motion_is_sound(const SafetyLimits& l) noexcept {
  return within_positive(l.brake_from_m_per_s, kDefaults.brake_from_m_per_s) &&
         within(l.brake_n_s_per_m, 20.0) && within_positive(l.cut_m_per_s, kDefaults.cut_m_per_s) &&
         l.cut_samples >= 1 && l.cut_samples <= kDefaults.cut_samples &&
         within_positive(l.cut_now_m_per_s, kDefaults.cut_now_m_per_s) &&
         within_positive(l.jump_mm_per_ms, kDefaults.jump_mm_per_ms) &&
         within(l.jump_hold_s, kDefaults.jump_hold_s);
}

bool times_are_sound(const SafetyLimits& l) noexcept {
  return within_positive(l.silent_damp_s, kDefaults.silent_damp_s) &&
         within_positive(l.silent_stop_s, kDefaults.silent_stop_s) &&
         l.silent_damp_s <= l.silent_stop_s && within(l.silent_damping_n_s_per_m, 20.0) &&
         within_positive(l.late_s, kDefaults.late_s) &&
         within_positive(l.very_late_s, kDefaults.very_late_s) && l.late_s <= l.very_late_s &&
         l.soft_faults >= 1 && l.soft_faults <= kDefaults.soft_faults &&
         within_positive(l.soft_fault_window_s, 3600.0) &&
         l.soft_fault_window_s >= kDefaults.soft_fault_window_s;
}

bool loop_is_sound(const SafetyLimits& l) noexcept {
  return within_positive(l.budget_fast_n_per_m, kDefaults.budget_fast_n_per_m) &&
         within_positive(l.budget_slow_n_per_m, kDefaults.budget_slow_n_per_m) &&
         l.period_ns >= kShortestPeriodNs && l.period_ns <= kLongestPeriodNs &&
         l.delay_ticks >= 0 && l.delay_ticks <= kMaxDelayTicks;
}

/// Converts bounds at the hand to bounds on the page. No bound becomes greater.
void hold_at_the_hand(SafetyLimits& limits, double scale) noexcept {
  if (!(scale >= kMinPageScale && scale <= kMaxPageScale)) {
    limits.peak_force_n = 0.0;
    return;
  }
  const double larger = std::max(1.0, scale), smaller = std::min(1.0, scale);
  limits.budget_fast_n_per_m /= larger;
  limits.budget_slow_n_per_m /= larger;
  limits.brake_n_s_per_m /= larger;
  limits.silent_damping_n_s_per_m /= larger;
  limits.brake_from_m_per_s *= smaller;
  limits.cut_m_per_s *= smaller;
  limits.cut_now_m_per_s *= smaller;
  limits.jump_mm_per_ms *= smaller;
}

}  // namespace

bool is_sound(const SafetyLimits& limits) noexcept {
  return forces_are_sound(limits) && motion_is_sound(limits) && times_are_sound(limits) &&
         loop_is_sound(limits);
}

SafetyLimits limits_for(const Capabilities& device, double user_limit_n) noexcept {
  SafetyLimits limits;
  limits.peak_force_n = device.has_force()
                            ? std::min({finite_positive(user_limit_n), limits.peak_force_n,
                                        0.9 * finite_positive(device.max_force_n)})
                            : 0.0;
  if (device.advised_force_n != 0.0) {
    limits.peak_force_n = std::min(limits.peak_force_n, finite_positive(device.advised_force_n));
  }
  limits.continuous_force_n = std::min(0.8 * finite_positive(device.continuous_force_n), 1e3);
  limits.max_damping_n_s_per_m = std::min(0.5 * finite_positive(device.max_damping_n_s_per_m), 1e3);
  limits.max_stiffness_n_per_m = std::min(0.9 * finite_positive(device.max_stiffness_n_per_m), 1e6);
  limits.period_ns = std::clamp(device.period_ns, kShortestPeriodNs, kLongestPeriodNs);
  limits.delay_ticks = std::clamp(device.delay_ticks, 0, kMaxDelayTicks);
  hold_at_the_hand(limits, device.page_scale);
  return limits;
}

Capabilities with_force_limit(const Capabilities& device, double user_limit_n) noexcept {
  Capabilities limited = device;
  if (user_limit_n > 0.0 && user_limit_n < limits_for(device).peak_force_n) {
    limited.advised_force_n = user_limit_n;
  }
  return limited;
}

}  // namespace felt
