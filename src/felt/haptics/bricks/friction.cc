#include "felt/haptics/bricks/friction.h"

#include <algorithm>

#include "felt/haptics/pen_sample.h"
#include "felt/haptics/sample_gap.h"

namespace felt {
namespace {

/// Returns v shortened to at most `limit`, in the same direction.
Vec shortened(Vec v, double limit) noexcept {
  const double length = norm(v);
  return length > limit ? v * (limit / length) : v;
}

/// Time constant of the filtered motion of the positions, s: longer than the time between two steps
/// of a coarse sensor (0.06 mm at 5 mm/s).
constexpr double kMotionS = 0.012;

void follow(const PenSample& sample, ForceMemory& memory) noexcept {
  PageMotion& motion = memory.page_motion;
  const Point pen = on_page(sample.position);
  if (!motion.is_set || !is_next_sample(sample.time_ns, motion.time_ns)) {
    motion = {.pen = pen, .time_ns = sample.time_ns, .is_set = true};
    return;
  }
  // Backward Euler, as in Plane. A repeated sample is a pen at rest.
  const double dt_s = sample_gap_s(sample.time_ns, motion.time_ns, memory.dt_s);
  motion.velocity = (1.0 / (kMotionS + dt_s)) * (kMotionS * motion.velocity + (pen - motion.pen));
  motion.pen = pen;
  motion.time_ns = sample.time_ns;
}

/// Returns the part of a reported velocity that the positions bear out: nothing if they move the
/// other way or rest, and at most twice their speed.
Vec believed(Vec reported, Vec of_positions) noexcept {
  const double squared = norm_squared(reported);
  if (!(squared > 0.0)) return {};
  return std::clamp(2.0 * dot(reported, of_positions) / squared, 0.0, 1.0) * reported;
}

}  // namespace

double Friction::limit_n(const FrictionOptions& options, const ForceMemory& memory) noexcept {
  const double whole_n = options.coefficient * memory.normal_force_n;
  const double own_n =
      std::min(options.own_friction_n, options.own_coefficient * memory.normal_force_n);
  return std::max({0.0, memory.friction_factor * whole_n - own_n, memory.friction_grain * whole_n});
}

Force Friction::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  const double dry_limit_n = limit_n(options_, memory);
  memory.friction_factor = 1.0;
  memory.friction_grain = 0.0;
  const Force dry = dry_n(sample, dry_limit_n, memory);
  return dry + viscous_n(sample, memory);
}

Force Friction::viscous_n(const PenSample& sample, ForceMemory& memory) const noexcept {
  if (!(options_.viscosity_n_s_per_m > 0.0)) return {};
  follow(sample, memory);
  if (!(memory.normal_force_n > 0.0)) return {};
  const double share = std::min(1.0, memory.normal_force_n / kWholeViscosityN);
  const double n_s_per_mm = 1e-3 * share * options_.viscosity_n_s_per_m;
  const Vec v = believed(known_velocity(sample), memory.page_motion.velocity);
  const Vec drag = shortened(-n_s_per_mm * v, kMaxViscousN);
  const Force force{drag.x, drag.y, 0.0};
  memory.terms.add("viscosity", force);
  return force;
}

Force Friction::dry_n(const PenSample& sample, double limit_n, ForceMemory& memory) const noexcept {
  const double stiffness = 1e-3 * options_.stiffness_n_per_m * memory.scale.friction;
  if (!(limit_n > 0.0) || !(stiffness > 0.0)) {
    memory.bristle_is_set = false;
    memory.terms.add("friction", {});
    return {};
  }
  const Point pen = on_page(sample.position);
  if (!memory.bristle_is_set) memory.bristle = pen;
  memory.bristle_is_set = true;

  const Vec stretch = shortened(pen - memory.bristle, limit_n / stiffness);
  memory.bristle = pen - stretch;
  const double damping = 1e-3 * options_.damping_n_s_per_m * memory.scale.friction;
  const Vec pull = shortened(-stiffness * stretch - damping * known_velocity(sample), limit_n);

  const Force force{pull.x, pull.y, 0.0};
  const double plain_n = Friction::limit_n(options_, memory);  // without texture
  const Force plain = (plain_n / limit_n) * force;
  memory.terms.add("friction", plain_n == limit_n ? force : plain);
  if (plain_n != limit_n) memory.terms.add("texture", force - plain);
  return force;
}

Slopes Friction::slopes() const noexcept {
  return {.friction_n_per_m = options_.stiffness_n_per_m};
}

}  // namespace felt
