#pragma once

#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/solid/solid.h"

namespace felt {

/// Extrudes a part of a body as Teddy does (Igarashi, Matsuoka, Tanaka 1999,
/// <https://doi.org/10.1145/311535.311602>, section 5.3). `path` is a closed stroke that is
/// projected on the body along `view` (from the eye to the body): the base ring. `profile` is the
/// silhouette of the new part, from one side of the ring over its tip to the other side, seen in
/// the plane through the middle of the ring that contains the normal of the ring and the ends of
/// the profile. It is moved and scaled so that it begins and ends at the ring.
///
/// Copies of the ring are placed between the two sides of the profile, each scaled to the width
/// there, and the closed tube through them is united with the body. Teddy moves two pointers along
/// the sides; here, both sides are divided at equal shares of their lengths.
///
/// Positions are in the frame of the body, in mm. The result is one closed body (check_body()) with
/// as many holes as before. Fails if the ring is not wholly on the body, crosses itself or bends
/// around the body, if the profile has no height or leads into the body, if the tube crosses
/// itself, or if it touches the body elsewhere.
Result<SolidBody> extrude_body(const SolidBody& body, std::span<const Vec3> path,
                               std::span<const Vec3> profile, const Vec3& view);

/// The base of an extrusion: points and unit normal in the frame of the body, in mm.
struct ExtrusionRing {
  std::vector<Vec3> points;  ///< on the surface, counter-clockwise from outside
  Vec3 middle;
  Vec3 normal;  ///< outwards
};

/// Projects a closed stroke on a body. Fails like extrude_body().
Result<ExtrusionRing> ring_on_body(const SolidBody& body, std::span<const Vec3> path,
                                   const Vec3& view);

}  // namespace felt
