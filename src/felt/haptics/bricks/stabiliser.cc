#include "felt/haptics/bricks/stabiliser.h"

#include <algorithm>

#include "felt/haptics/bricks/spring.h"
#include "felt/haptics/pen_sample.h"

namespace felt {
namespace {

/// Returns true while the nib is on the surface. When the pen lands, sets the nib under the pen.
bool nib_is_down(const PenSample& sample, Follower& nib) noexcept {
  if (!in_contact(sample)) {
    nib.is_set = false;
  } else if (!nib.is_set) {
    nib = {.position = on_page(sample.position),
           .velocity = in_plane(sample.velocity),
           .gesture = 0,
           .is_set = true};
  }
  return nib.is_set;
}

}  // namespace

Point towed_nib(const TowOptions& options, Point nib, Point pen, double dt_s) noexcept {
  const Vec rope = pen - nib;
  const double length = norm(rope);
  const double stretch = length - options.rope_mm;
  if (!(stretch > 0.0) || !(length > 0.0)) return nib;
  return nib + (stretch * dt_s / ((options.time_constant_s + dt_s) * length)) * rope;
}

Force Towed::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  Force force;
  if (nib_is_down(sample, memory.nib)) {
    const Point pen = on_page(sample.position);
    memory.nib.position = towed_nib(options_, memory.nib.position, pen, memory.dt_s);
    const Vec rope = pen - memory.nib.position;
    const double length = norm(rope);
    if (length > options_.rope_mm && length > 0.0) {
      const Vec along = rope / length;
      // Damps only along the rope, because a rope does not push sideways.
      const double speed = dot(known_velocity(sample), along);
      // The damping grows with the stretch. Otherwise its force would jump when the rope becomes
      // taut.
      const double stretch = length - options_.rope_mm;
      const double taut = std::min(1.0, stretch);
      force = pull_back(options_.law, stretch * along, taut * options_.damping_n_s_per_m,
                        speed * along, memory.scale.lateral);
      // A rope pulls and never pushes.
      if (dot({force.x, force.y}, along) > 0.0) force = {};
    }
  }
  memory.terms.add("stabiliser", force);
  return force;
}

Slopes Towed::slopes() const noexcept {
  return {.lateral_n_per_m = options_.law.max_slope_n_per_m()};
}

Vec move_mass(const InertiaOptions& options, Follower& mass, Point pen, Vec pen_velocity_mm_per_s,
              double dt_s) noexcept {
  // No conversion of units is needed until the end: kg mm/s^2 = mN and N/m mm = mN.
  const double k = options.stiffness_n_per_m;
  const double b = options.damping_n_s_per_m;
  const double c = options.drag_n_s_per_m;
  const double m = std::max(options.mass_kg, 1e-3);
  const Vec& u = mass.velocity;
  const Vec offset = pen - mass.position;
  // Solves the implicit equation in the header for the next velocity. If the pull is above the
  // limit, solves again with the limited pull as a constant.
  Vec next = (m * u + dt_s * (k * offset + b * pen_velocity_mm_per_s)) /
             (m + dt_s * (b + c) + dt_s * dt_s * k);
  Vec pull = k * (offset - dt_s * next) + b * (pen_velocity_mm_per_s - next);
  const double limit = 1e3 * options.max_force_n;
  const double size = norm(pull);
  if (size > limit) {
    pull = pull * (limit / size);
    next = (m * u + dt_s * pull) / (m + dt_s * c);
  }
  mass.velocity = next;
  mass.position += dt_s * next;
  return 1e-3 * pull;
}

Force Inertia::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  Force force;
  if (nib_is_down(sample, memory.nib)) {
    const Vec pull = move_mass(options_, memory.nib, on_page(sample.position),
                               in_plane(sample.velocity), memory.dt_s);
    force = -memory.scale.lateral * Force{pull.x, pull.y, 0.0};
  }
  memory.terms.add("stabiliser", force);
  return force;
}

Slopes Inertia::slopes() const noexcept {
  return {.lateral_n_per_m = options_.stiffness_n_per_m};
}

}  // namespace felt
