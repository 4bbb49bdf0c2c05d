#include "felt/haptics/bricks/damping.h"

namespace felt {

Force Damping::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  const bool touches = depth_mm(sample) > 0.0;
  const bool acts = options_.where == DampingWhere::kEverywhere ||
                    (options_.where == DampingWhere::kOnSurface) == touches;
  Force force;
  if (acts) {
    const Vec3& v = sample.velocity;
    force = -1e-3 * options_.damping_n_s_per_m * Force{v.x, v.y, touches ? 0.0 : v.z};
    const double size = norm(force);
    if (size > options_.max_force_n) force = (options_.max_force_n / size) * force;
  }
  memory.terms.add("damping", force);
  return force;
}

}  // namespace felt
