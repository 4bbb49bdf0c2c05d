#include "felt/haptics/safety/safety_stages.h"

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"

namespace felt {
namespace {

/// Returns the length without overflow, because a force may be as large as a double.
double length(const Force& f) noexcept {
  const double largest = std::max({std::abs(f.x), std::abs(f.y), std::abs(f.z)});
  if (largest < 1e100) return norm(f);
  return largest * norm((1.0 / largest) * f);  // may be infinite, which is longer than any bound
}

/// Returns the fraction of `wanted` that fits into `room`; both in N/m.
double share_of(double wanted, double room) noexcept {
  if (!(wanted >= 0.0)) return 0.0;  // negative or NaN: invalid
  if (wanted <= room) return 1.0;
  return std::max(room, 0.0) / wanted;
}

}  // namespace

Force clamp_length(const Force& f, double max_n) noexcept {
  if (!(max_n > 0.0)) return {};
  const double largest = std::max({std::abs(f.x), std::abs(f.y), std::abs(f.z)});
  if (largest < 1e100) {
    const double n = norm(f);
    return n <= max_n ? f : (max_n / n) * f;
  }
  const Force unit = (1.0 / largest) * f;
  return (max_n / norm(unit)) * unit;
}

Force limit_rise(const Force& previous, const Force& wanted, double step_n) noexcept {
  const double length_squared = dot(previous, previous);
  Force from;
  if (length_squared > 0.0) {
    from = std::clamp(dot(previous, wanted) / length_squared, 0.0, 1.0) * previous;
  }
  return step_towards(from, wanted, step_n);
}

Force step_towards(const Force& previous, const Force& wanted, double step_n) noexcept {
  const Force way = wanted - previous;
  if (length(way) <= step_n) return wanted;
  return previous + clamp_length(way, step_n);
}

double brake_damping(const SafetyLimits& limits, double speed_m_per_s) noexcept {
  const double range = limits.cut_m_per_s - limits.brake_from_m_per_s;
  const double over = speed_m_per_s - limits.brake_from_m_per_s;
  if (!(over > 0.0)) return 0.0;
  const double damping = limits.brake_n_s_per_m * (range > 0.0 ? std::min(over / range, 1.0) : 1.0);
  if (limits.max_damping_n_s_per_m <= 0.0) return damping;
  return std::min(damping, limits.max_damping_n_s_per_m);
}

Force damping_force(double damping_n_s_per_m, const Vec3& velocity_mm_per_s,
                    double max_n) noexcept {
  const double c = -damping_n_s_per_m * kMPerMm;
  return clamp_length({c * velocity_mm_per_s.x, c * velocity_mm_per_s.y, c * velocity_mm_per_s.z},
                      max_n);
}

double stiffness_budget_n_per_m(const SafetyLimits& limits) noexcept {
  constexpr double kSlowDelayS = 0.003;
  const double delay_s =
      static_cast<double>(limits.delay_ticks + 1) * static_cast<double>(limits.period_ns) * 1e-9;
  return std::min(limits.budget_fast_n_per_m, limits.budget_slow_n_per_m * kSlowDelayS / delay_s);
}

StiffnessScale share_budget(const SafetyLimits& limits, const Slopes& slopes) noexcept {
  const double budget = stiffness_budget_n_per_m(limits);
  const double plane =
      limits.max_stiffness_n_per_m > 0.0 ? std::min(budget, limits.max_stiffness_n_per_m) : budget;
  StiffnessScale scale;
  scale.normal = share_of(slopes.normal_n_per_m, plane);
  scale.lateral = share_of(slopes.lateral_n_per_m, budget);
  const double lateral = scale.lateral > 0.0 ? scale.lateral * slopes.lateral_n_per_m : 0.0;
  scale.friction = share_of(slopes.friction_n_per_m, budget - lateral);
  return scale;
}

}  // namespace felt
