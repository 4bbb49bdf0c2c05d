#include "felt/solid/surface_hit.h"

#include <algorithm>
#include <cmath>

#include "felt/geometry/triangle_tree.h"

namespace felt {

/// The intersection of Möller and Trumbore, "Fast, minimum storage ray/triangle intersection",
/// 1997, <https://doi.org/10.1080/10867651.1997.10487468>. Borders of triangles belong to both.
std::optional<SurfaceHit> first_hit(const SolidBody& body, const Vec3& from, const Vec3& direction,
                                    HitSide side) {
  constexpr double kBorder = 1e-9;
  std::optional<SurfaceHit> best;
  for (const auto& [a, b, c] : body.triangles) {
    const Vec3 ab = body.points[b] - body.points[a], ac = body.points[c] - body.points[a];
    const Vec3 normal = cross(ab, ac);
    const double facing = -dot(direction, normal);
    if (side == HitSide::kEnters ? facing <= 0.0 : facing >= 0.0) continue;
    const Vec3 to_start = from - body.points[a];
    const Vec3 moment = cross(to_start, direction);
    const double u = dot(ac, moment) / facing, v = -dot(ab, moment) / facing;
    if (u < -kBorder || v < -kBorder || u + v > 1.0 + kBorder) continue;
    const double t = dot(to_start, normal) / facing;
    if (t < 0.0 || (best && t >= best->distance)) continue;
    best = SurfaceHit{from + t * direction, (1.0 / norm(normal)) * normal, t};
  }
  return best;
}

std::optional<SurfaceHit> hit_from_eye(const SolidBody& body, const Vec3& at, const Vec3& view) {
  double nearest = 0.0;
  for (const Vec3& p : body.points) nearest = std::min(nearest, dot(view, p - at));
  return first_hit(body, at + (nearest - 1.0) * view, view, HitSide::kEnters);
}

}  // namespace felt
