#include "felt/geometry/surface_proxy.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "felt/geometry/triangle_tree.h"

namespace felt {
namespace {

// Two planes whose normals have a smaller sine between them have no sure common edge.
constexpr double kSameplaneSine = 1e-6;
// A movement into a plane by less than this share of the pull counts as along it; the next sweep
// stops what is left of it.
constexpr double kAlongShare = 1e-9;

// The planes that have stopped a step; they all go through the proxy (within the gap).
struct Planes {
  std::array<Vec3, SurfaceProxy::kPlanes> normals{};
  std::size_t count = 0;
};

// The movement nearest to `pull` that enters none of the planes: none, one, two or all of them hold
// it (Zilles and Salisbury 1995, section 4). The nearest is among the movements along one plane and
// along the edge of two; staying is always allowed.
Vec3 free_part(const Vec3& pull, const Planes& planes) noexcept {
  Vec3 best{};
  double best_distance = norm(pull);
  const auto offer = [&](const Vec3& move) {
    for (std::size_t k = 0; k < planes.count; ++k) {
      if (dot(move, planes.normals[k]) < -kAlongShare * norm(pull)) return;
    }
    const double distance = norm(pull - move);
    if (distance >= best_distance) return;
    best = move;
    best_distance = distance;
  };
  offer(pull);
  for (std::size_t k = 0; k < planes.count; ++k) {
    const Vec3& normal = planes.normals[k];
    offer(pull - dot(pull, normal) * normal);
    for (std::size_t m = 0; m < k; ++m) {
      const Vec3 edge = cross(planes.normals[m], normal);
      if (norm(edge) >= kSameplaneSine) offer((dot(pull, edge) / norm_squared(edge)) * edge);
    }
  }
  return best;
}

// The goal that the planes and friction leave of the way from `place` to `pen`: inside the cone the
// proxy stays, outside it moves to the cone (Ruspini 1997, section 5). What the planes hold back is
// the depth, so that two planes act as one whose normal is their resultant.
Vec3 held_goal(const Vec3& place, const Vec3& pen, const Planes& planes, double friction) noexcept {
  const Vec3 pull = pen - place;
  const Vec3 slide = free_part(pull, planes);
  const double hold = friction * norm(pull - slide);
  const double length = norm(slide);
  if (length <= hold || length <= 0.0) return place;
  return place + (1.0 - hold / length) * slide;
}

// The direction in which the planes push the pen back: against the part of its pull that they hold.
Vec3 push_direction(const Vec3& place, const Vec3& pen, const Planes& planes) noexcept {
  const Vec3 pull = pen - place;
  const Vec3 held = free_part(pull, planes) - pull;
  const double length = norm(held);
  return length > 0.0 && is_finite(held) ? (1.0 / length) * held : Vec3{};
}

// The goal, or the point within reach on the way to it.
Vec3 within_reach(const Vec3& place, const Vec3& goal) {
  const double length = norm(goal - place);
  if (length <= SurfaceProxy::kReachMm) return goal;
  return place + (SurfaceProxy::kReachMm / length) * (goal - place);
}

}  // namespace

void SurfaceProxy::reset(const Vec3& pen) noexcept {
  place_ = pen;
  normal_ = {};
  touches_ = false;
}

Vec3 SurfaceProxy::step(const TriangleTree& body, const Vec3& pen, double friction) noexcept {
  if (!is_finite(pen)) return place_;
  touches_ = false;
  normal_ = {};
  Vec3 goal = within_reach(place_, pen);
  Planes planes;
  while (is_finite(goal)) {  // a pen may be so far away that its distance overflows
    const Vec3 move = goal - place_;
    const std::optional<SweepHit> hit = body.sweep(place_, goal);
    if (!hit) {
      place_ = goal;
      return place_;
    }
    touches_ = true;
    // Stop before the plane, on the part of the way that is known to be free.
    const double closing = -dot(move, hit->normal);
    const double stop = closing > 0.0 ? hit->t - kGapMm / closing : 0.0;
    place_ += std::max(0.0, stop) * move;
    if (planes.count == kPlanes) return place_;
    planes.normals[planes.count++] = hit->normal;
    normal_ = push_direction(place_, pen, planes);
    goal = within_reach(place_, held_goal(place_, pen, planes, friction));
  }
  return place_;
}

}  // namespace felt
