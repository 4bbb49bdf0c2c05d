#pragma once

#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/safety/safety_limits.h"

/// The stages of the safety chain that remember nothing: a force in, a force out. All of them are
/// total (huge and denormal numbers included; NaN never comes this far) and real-time safe.
namespace felt {

/// The force, shortened to max_n N if it is longer; its direction stays. max_n <= 0 gives none.
Force clamp_length(const Force& f, double max_n) noexcept;

/// The rise stage (architecture section 10): at most step_n N more than before.
///
/// Falling is free, turning and reversing are not: the force first goes to the point of the segment
/// from 0 to `previous` that is nearest to `wanted` (which only takes force away), and from there
/// at most step_n towards `wanted`. The result never leaves the triangle 0, previous, wanted; so it
/// is never longer than the longer of the two.
Force limit_rise(const Force& previous, const Force& wanted, double step_n) noexcept;

/// At most step_n N from `previous` to `wanted`, falling too.
Force step_towards(const Force& previous, const Force& wanted, double step_n) noexcept;

/// Damping in N s/m that the brake adds at a speed: 0 up to brake_from, growing linearly to
/// brake_n_s_per_m at cut and staying there; never more than the device bears.
double brake_damping(const SafetyLimits& limits, double speed_m_per_s) noexcept;

/// -damping velocity, clamped to max_n; velocity in mm/s, any finite size.
Force damping_force(double damping_n_s_per_m, const Vec3& velocity_mm_per_s, double max_n) noexcept;

/// Sum of slopes in N/m that one axis may have (R56; specification 5d): budget_fast up to 2 ms of
/// loop delay, budget_slow at 3 ms, beyond in proportion to 1/delay. Loop delay is the device's
/// delay and the period of the hold: (delay_ticks + 1) period.
double stiffness_budget_n_per_m(const SafetyLimits& limits) noexcept;

/// Scales that keep slopes to the budget (R56) and the plane to the device's stiffness (R55). In
/// the sheet friction gives way first, then the rest. Slopes that are no numbers get no share.
StiffnessScale share_budget(const SafetyLimits& limits, const Slopes& slopes) noexcept;

}  // namespace felt
