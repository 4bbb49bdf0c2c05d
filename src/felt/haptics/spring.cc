#include "felt/haptics/spring.h"

#include "felt/haptics/known_velocity.h"

namespace felt {

Force pull_back(const ForceLaw& law, Vec displacement_mm, double damping_n_s_per_m,
                Vec velocity_mm_per_s, double gain) noexcept {
  const double distance = norm(displacement_mm);
  // phi(d)/d is at most Kcap, but 0/0 and subnormal distances are not to be divided by.
  const double per_mm = distance > 1e-12 ? law.force_n(distance) / distance : 0.0;
  const Vec pull =
      -gain * (per_mm * displacement_mm + 1e-3 * damping_n_s_per_m * velocity_mm_per_s);
  return {pull.x, pull.y, 0.0};
}

Force EditSpring::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  const Force force =
      pull_back(options_.law, on_sheet(sample.position) - origin_, options_.damping_n_s_per_m,
                known_velocity(sample), memory.scale.lateral);
  memory.terms.add("edit", force);
  return force;
}

Slopes EditSpring::slopes() const noexcept {
  return {.lateral_n_per_m = options_.law.max_slope_n_per_m()};
}

Force SweepSpring::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  const Point pen = on_sheet(sample.position);
  Follower& curve = memory.swept;
  if (!curve.is_set || curve.gesture != gesture_) {
    curve = {.position = pen, .velocity = {}, .gesture = gesture_, .is_set = true};
  }
  const Vec lag = (time_constant_s_ / (time_constant_s_ + memory.dt_s)) * (pen - curve.position);
  curve.position = pen - lag;
  const Force force = pull_back(options_.law, lag, options_.damping_n_s_per_m,
                                known_velocity(sample), memory.scale.lateral);
  memory.terms.add("edit", force);
  return force;
}

Slopes SweepSpring::slopes() const noexcept {
  return {.lateral_n_per_m = options_.law.max_slope_n_per_m()};
}

}  // namespace felt
