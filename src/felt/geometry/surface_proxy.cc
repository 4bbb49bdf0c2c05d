#include "felt/geometry/surface_proxy.h"

#include <algorithm>
#include <optional>

namespace felt {
namespace {

// Two planes whose normals have a smaller sine between them count as one: their common edge has no
// sure direction.
constexpr double kSameplaneSine = 1e-6;

// The goal that friction leaves of `goal` on the plane through `place`: inside the cone the proxy
// stays, outside it moves to the cone (Ruspini 1997, section 5).
Vec3 goal_in_plane(const Vec3& place, const Vec3& goal, const Vec3& normal, double friction) {
  const Vec3 pull = goal - place;
  const double depth = std::max(0.0, -dot(pull, normal));
  const Vec3 slide = pull - dot(pull, normal) * normal;
  const double length = norm(slide);
  if (length <= friction * depth || length <= 0.0) return place;
  return place + (1.0 - friction * depth / length) * slide;
}

// The goal, or the point within reach on the way to it.
Vec3 within_reach(const Vec3& place, const Vec3& goal) {
  const double length = norm(goal - place);
  if (length <= SurfaceProxy::kReach_mm) return goal;
  return place + (SurfaceProxy::kReach_mm / length) * (goal - place);
}

}  // namespace

void SurfaceProxy::reset(const Vec3& pen) noexcept {
  place_ = pen;
  touches_ = false;
}

Vec3 SurfaceProxy::step(const TriangleTree& body, const Vec3& pen, double friction) noexcept {
  if (!is_finite(pen)) return place_;
  touches_ = false;
  Vec3 goal = within_reach(place_, pen);
  Vec3 last_normal{};
  for (int i = 0; i < kSweeps; ++i) {
    if (!is_finite(goal)) return place_;  // a pen so far away that its distance overflows
    const Vec3 move = goal - place_;
    const std::optional<SweepHit> hit = body.sweep(place_, goal);
    if (!hit) {
      place_ = goal;
      return place_;
    }
    touches_ = true;
    // Stop before the plane, on the part of the way that is known to be free.
    const double closing = -dot(move, hit->normal);
    const double stop = closing > 0.0 ? hit->t - kGap_mm / closing : 0.0;
    place_ += std::max(0.0, stop) * move;
    const Vec3 edge = cross(last_normal, hit->normal);
    if (i == 0 || norm(edge) < kSameplaneSine) {
      goal = goal_in_plane(place_, i == 0 ? pen : goal, hit->normal, i == 0 ? friction : 0.0);
    } else {
      goal = place_ + (dot(goal - place_, edge) / norm_squared(edge)) * edge;
    }
    goal = within_reach(place_, goal);
    last_normal = hit->normal;
  }
  return place_;
}

}  // namespace felt
