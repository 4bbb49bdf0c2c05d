#include "felt/haptics/bricks/solid_surface.h"

#include <algorithm>
#include <optional>

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/sample_gap.h"

namespace felt {
namespace {

constexpr double kFastestAcrossMmPerS = 500.0;  // as of the plane
constexpr double kAboveMm = 1.0;

Vec3 shortened3(const Vec3& v, double limit) noexcept {
  const double length = norm(v);
  return length > limit ? (limit / length) * v : v;
}

// The part of a velocity that dampers may rely on (known_velocity).
Vec3 known_part(const Vec3& v) noexcept {
  const double speed = norm(v);
  return speed > kUnknownSpeedMmPerS ? ((speed - kUnknownSpeedMmPerS) / speed) * v : Vec3{};
}

Force force_of(const Vec3& n) noexcept {
  return {n.x, n.y, n.z};
}

}  // namespace

// Seen from the hand, nothing of the body covers the point.
bool SolidSurface::is_free_in_front(const Vec3& point) const noexcept {
  const double top = std::max(body_->high().z, point.z) + kAboveMm;
  return !body_->sweep({point.x, point.y, top}, point).has_value();
}

void SolidSurface::change_body(SolidTouch& touch) const noexcept {
  touch.number = options_.number;
  const Vec3 place = touch.proxy.place();
  if (!touch.is_outside || !touch.proxy.touches()) {
    touch.is_outside = false;
    return;
  }
  if (is_free_in_front(place)) return;
  const Vec3 top{place.x, place.y, std::max(body_->high().z, place.z) + kAboveMm};
  const std::optional<SweepHit> hit = body_->sweep(top, place);
  const double rise_mm =
      hit ? (1.0 - hit->t) * (top.z - place.z) + SurfaceProxy::kGapMm : 2.0 * kFollowMm;
  touch.is_outside = rise_mm <= kFollowMm;
  if (touch.is_outside) touch.proxy.reset(place + Vec3{0.0, 0.0, rise_mm});
}

bool SolidSurface::follow(const PenSample& sample, double friction,
                          ForceMemory& memory) const noexcept {
  SolidTouch& touch = memory.solid;
  const Vec3& pen = sample.position;
  if (!is_finite(pen)) return false;
  const bool is_fresh =
      is_next_sample(sample.time_ns, touch.time_ns) && norm(pen - touch.pen_mm) <= kLostMm;
  touch.is_outside = touch.is_outside && is_fresh;
  // The device repeats its sample until it has a new one.
  const bool is_repeated = is_fresh && sample.time_ns == touch.time_ns && pen == touch.pen_mm;
  touch.repeated_s = is_repeated ? touch.repeated_s + memory.dt_s : 0.0;
  const bool is_unknown = !is_fresh || touch.repeated_s > kMaxSampleGapS;
  if (is_unknown) touch.motion.reset();
  if (is_unknown || !is_repeated) {
    touch.motion.update(
        pen, is_fresh ? sample_gap_s(sample.time_ns, touch.time_ns, memory.dt_s) : memory.dt_s);
  }
  touch.pen_mm = pen;
  touch.time_ns = sample.time_ns;
  if (touch.number != options_.number) change_body(touch);
  if (!touch.is_outside) {
    if (!is_free_in_front(pen)) return false;
    touch.proxy.reset(pen);
    touch.is_outside = true;
  }
  touch.proxy.step(*body_, pen, friction);
  if (touch.proxy.touches()) return true;
  touch.is_outside = norm(pen - touch.proxy.place()) <= kLostMm;  // a pen that is too fast
  return false;
}

Force SolidSurface::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  const double cap_n_per_m = memory.material_cap_n_per_m;
  const auto capped = [&](double n_per_m) {
    return 1e-3 * (cap_n_per_m > 0.0 ? std::min(n_per_m, cap_n_per_m) : n_per_m);
  };
  const double both = std::min(memory.scale.normal, memory.scale.lateral);
  const double across = capped(options_.plane.stiffness_n_per_m * both);
  const double along =
      capped(options_.friction.stiffness_n_per_m * std::min(both, memory.scale.friction));
  SolidTouch& touch = memory.solid;
  // The cone whose edge is where k |t| = mu K depth.
  const double mu = options_.friction.coefficient * touch.friction_factor;
  const double cone = along > 0.0 ? mu * across / along : 0.0;
  touch.friction_factor = 1.0;
  Force force;
  if (follow(sample, cone, memory)) {
    force = across_and_along(sample, across, along, memory);
  } else {
    memory.terms.add("plane", {});
    memory.terms.add("friction", {});
  }
  return force;
}

Force SolidSurface::across_and_along(const PenSample& sample, double across_n_per_mm,
                                     double along_n_per_mm, ForceMemory& memory) const noexcept {
  SolidTouch& touch = memory.solid;
  const Vec3 normal = touch.proxy.normal();
  const Vec3 offset = touch.proxy.place() - sample.position;
  const double depth = std::max(0.0, dot(offset, normal));
  const auto at_most = [&](double n) {
    return options_.max_force_n > 0.0 ? std::min(n, options_.max_force_n) : n;
  };
  const Vec3 velocity = touch.motion.velocity();
  const double speed = dot(velocity, normal);
  const double brake = 1e-3 * options_.plane.damping_n_s_per_m *
                       std::clamp(speed, -kFastestAcrossMmPerS, kFastestAcrossMmPerS);
  memory.spring_force_n = at_most(across_n_per_mm * depth);
  memory.normal_force_n = depth > 0.0 ? at_most(std::max(0.0, memory.spring_force_n - brake)) : 0.0;

  PenSample on_surface = sample;
  on_surface.position = touch.proxy.place();
  on_surface.velocity = velocity;
  grain_(on_surface, memory);  // sets the factor of the friction
  const double limit_n = Friction::limit_n(options_.friction, memory);
  const double whole_n = options_.friction.coefficient * memory.normal_force_n;
  touch.friction_factor = whole_n > 0.0 ? limit_n / whole_n : 1.0;
  memory.friction_factor = 1.0;
  memory.friction_grain = 0.0;
  const Vec3 stretch = offset - dot(offset, normal) * normal;
  const Vec3 slip = known_part(velocity - speed * normal);
  // The share of the budget scales the damper with the bristle, as in Friction.
  const double share = options_.friction.stiffness_n_per_m > 0.0
                           ? 1e3 * along_n_per_mm / options_.friction.stiffness_n_per_m
                           : 0.0;
  const double damping = 1e-3 * options_.friction.damping_n_s_per_m * share;
  const Force across = force_of(memory.normal_force_n * normal);
  const Force along = force_of(shortened3(along_n_per_mm * stretch - damping * slip, limit_n));
  memory.terms.add("plane", across);
  memory.terms.add("friction", along);
  return across + along;
}

Slopes SolidSurface::slopes() const noexcept {
  const double across = options_.plane.stiffness_n_per_m;
  const double bristle = options_.friction.stiffness_n_per_m;
  const Slopes solid{.normal_n_per_m = std::max(across, bristle),
                     .friction_n_per_m = std::max(0.0, bristle - across),
                     .lateral_n_per_m = across};
  return solid + grain_.slopes();
}

SolidSurface make_solid_surface(const TriangleTree& body, const SurfaceMaterial& surface,
                                const Medium& tool, const Capabilities& device,
                                std::uint32_t number, const HeightField* grain) noexcept {
  return {body,
          {.plane = plane_for(surface, device),
           .friction = friction_for(tool, surface, device),
           .max_force_n = device.max_force_n,
           .number = number},
          Texture(grain, texture_for(tool, surface, device))};
}

}  // namespace felt
