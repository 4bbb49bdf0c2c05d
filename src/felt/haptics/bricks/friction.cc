#include "felt/haptics/bricks/friction.h"

#include <algorithm>

#include "felt/haptics/pen_sample.h"

namespace felt {
namespace {

/// Returns v shortened to at most `limit`, in the same direction.
Vec shortened(Vec v, double limit) noexcept {
  const double length = norm(v);
  return length > limit ? v * (limit / length) : v;
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
  if (!(options_.viscosity_n_s_per_m > 0.0) || !(memory.normal_force_n > 0.0)) return {};
  const double share = std::min(1.0, memory.normal_force_n / kWholeViscosityN);
  const double n_s_per_mm = 1e-3 * share * options_.viscosity_n_s_per_m;
  const Vec drag = shortened(-n_s_per_mm * known_velocity(sample), kMaxViscousN);
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
