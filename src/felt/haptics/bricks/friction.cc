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

Force Friction::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  const double factor = std::max(memory.friction_factor, 0.0);
  memory.friction_factor = 1.0;
  const double limit_n = options_.coefficient * factor * memory.normal_force_n;
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
  const Force plain = factor > 0.0 ? (1.0 / factor) * force : force;
  memory.terms.add("friction", factor == 1.0 ? force : plain);
  if (factor != 1.0) memory.terms.add("texture", force - plain);
  return force;
}

Slopes Friction::slopes() const noexcept {
  return {.friction_n_per_m = options_.stiffness_n_per_m};
}

}  // namespace felt
