#pragma once

#include <optional>

#include "felt/solid/solid.h"

namespace felt {

/// Where a ray meets a body.
struct SurfaceHit {
  Vec3 point;           ///< mm, in the frame of the body
  Vec3 normal;          ///< unit normal of the triangle, outwards
  double distance = 0;  ///< from the start of the ray, in mm
};

/// Returns the first point at which a ray from `from` along the unit vector `direction` meets a
/// triangle whose front faces it (enters), or whose back does (leaves), if there is one. Takes time
/// in proportion to the number of triangles.
enum class HitSide { kEnters, kLeaves };
std::optional<SurfaceHit> first_hit(const SolidBody& body, const Vec3& from, const Vec3& direction,
                                    HitSide side);

/// Returns the first point of the surface below the eye: on the line through `at` along the unit
/// vector `view`, seen from outside of the body.
std::optional<SurfaceHit> hit_from_eye(const SolidBody& body, const Vec3& at, const Vec3& view);

}  // namespace felt
