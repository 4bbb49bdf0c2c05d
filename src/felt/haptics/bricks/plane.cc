#include "felt/haptics/bricks/plane.h"

#include <algorithm>

#include "felt/haptics/sample_gap.h"

namespace felt {
namespace {

constexpr double kFastestMmPerS = 500.0;

void follow_speed(const PenSample& sample, ForceMemory& memory) noexcept {
  const double z_mm = sample.position.z;
  const bool fresh = memory.has_last_z && is_next_sample(sample.time_ns, memory.last_z_time_ns);
  // The device repeats its sample until it has a new one.
  const bool is_repeated =
      fresh && sample.time_ns == memory.last_z_time_ns && z_mm == memory.last_z_mm;
  memory.z_repeated_s = is_repeated ? memory.z_repeated_s + memory.dt_s : 0.0;
  if (is_repeated) {
    if (memory.z_repeated_s > kMaxSampleGapS) memory.normal_speed_mm_per_s = 0.0;
    return;
  }
  // Uses backward Euler, as VelocityFilter does. It does not divide by dt, so that the jitter of a
  // short tick does not appear as speed.
  const double way_mm = z_mm - memory.last_z_mm;
  memory.normal_speed_mm_per_s =
      fresh ? (Plane::kSpeedFilterS * memory.normal_speed_mm_per_s + way_mm) /
                  (Plane::kSpeedFilterS +
                   sample_gap_s(sample.time_ns, memory.last_z_time_ns, memory.dt_s))
            : 0.0;
  memory.last_z_mm = z_mm;
  memory.last_z_time_ns = sample.time_ns;
  memory.has_last_z = true;
}

}  // namespace

Force Plane::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  follow_speed(sample, memory);
  // Applies the share of the stiffness budget first and then the cap. In the other order the cap
  // would be applied twice if the safety chain has already included it in the budget.
  double stiffness = options_.stiffness_n_per_m * memory.scale.normal;
  if (memory.material_cap_n_per_m > 0.0) {
    stiffness = std::min(stiffness, memory.material_cap_n_per_m);
  }
  const double depth = depth_mm(sample);
  const double speed = std::clamp(memory.normal_speed_mm_per_s, -kFastestMmPerS, kFastestMmPerS);

  memory.spring_force_n = 1e-3 * stiffness * depth;
  memory.normal_force_n =
      depth > 0.0 ? std::max(0.0, memory.spring_force_n - 1e-3 * options_.damping_n_s_per_m * speed)
                  : 0.0;
  const Force force{0.0, 0.0, memory.normal_force_n};
  memory.terms.add("plane", force);
  return force;
}

Slopes Plane::slopes() const noexcept {
  return {.normal_n_per_m = options_.stiffness_n_per_m};
}

}  // namespace felt
