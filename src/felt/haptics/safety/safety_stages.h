#pragma once

#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/safety/safety_limits.h"

/// The stages of the safety chain that have no state: functions from force to force. All of them
/// accept any number, including huge and denormal ones (an earlier stage catches NaN), and are
/// real-time safe.
namespace felt {

/// Returns the force; if it is longer than max_n, shortens it to max_n N in the same direction. If
/// max_n <= 0, returns 0.
Force clamp_length(const Force& f, double max_n) noexcept;

/// Limits the rise (docs/design/limits.md#rise): at most step_n N more than before.
///
/// A fall is not limited, but turning and reversing are. The force first moves to the point of the
/// segment from 0 to `previous` that is nearest to `wanted`. This only removes force. From that
/// point it moves by at most step_n towards `wanted`. The result never leaves the triangle 0,
/// previous, wanted, so it is at most as long as the longer of `previous` and `wanted`.
Force limit_rise(const Force& previous, const Force& wanted, double step_n) noexcept;

/// Returns a force at most step_n N from `previous` towards `wanted`. Unlike limit_rise(), it also
/// limits a fall.
Force step_towards(const Force& previous, const Force& wanted, double step_n) noexcept;

/// Returns the damping in N s/m that the brake adds at a speed: 0 up to brake_from_m_per_s, then
/// linearly increasing to brake_n_s_per_m at cut_m_per_s, then constant. It is never more than the
/// device can render.
double brake_damping(const SafetyLimits& limits, double speed_m_per_s) noexcept;

/// Returns the damping force, -damping * velocity, with a magnitude of at most max_n. The velocity
/// is in mm/s and may have any finite size.
Force damping_force(double damping_n_s_per_m, const Vec3& velocity_mm_per_s, double max_n) noexcept;

/// Returns the largest sum of slopes that one axis may have, in N/m (R56;
/// docs/design/limits.md#stiffness-budget): budget_fast or budget_slow * 3 ms / loop delay,
/// whichever is less. At the default budgets, budget_fast applies up to 2 ms. The loop delay is the
/// device's delay plus the period for which a force is held: (delay_ticks + 1) * period.
double stiffness_budget_n_per_m(const SafetyLimits& limits) noexcept;

/// Returns scales that keep the slopes within the budget (R56) and the plane within the device's
/// stiffness (R55). Along the surface, `friction_n_per_m` is reduced first; `lateral_n_per_m` is
/// reduced only if it exceeds the budget without friction. If a slope is NaN or negative, its share
/// is 0.
StiffnessScale share_budget(const SafetyLimits& limits, const Slopes& slopes) noexcept;

}  // namespace felt
