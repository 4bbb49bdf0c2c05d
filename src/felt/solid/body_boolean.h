#pragma once

#include <cstdint>

#include "felt/base/result.h"
#include "felt/solid/solid.h"

namespace felt {

/// A set operation on the insides of two bodies.
enum class BodyBoolean : std::uint8_t {
  kDifference,  ///< inside the first but not the second
  kUnion,       ///< inside at least one
};

/// Computes a set operation of two closed surfaces. The result has points and triangles only; it
/// can consist of several components, or of none. The points of the intersection are those of exact
/// arithmetic, rounded to double; then edges and triangles that are too thin for files are removed
/// (remove_slivers()). The implementation is the corefinement of CGAL
/// (<https://doc.cgal.org/5.5/Polygon_mesh_processing/>). The same bodies give the same bytes.
///
/// Requires closed surfaces (check_body()). Fails if a surface crosses itself near the other, or if
/// the result is not a manifold.
Result<SolidBody> combine(const SolidBody& a, const SolidBody& b, BodyBoolean operation);

/// Returns true if two triangles of a surface meet elsewhere than in a common edge or corner.
bool crosses_itself(const SolidBody& body);

/// Removes edges that are shorter than 1/1000 of the mean edge, and triangles that are lower than
/// 1/1000 of their longest edge, as long as the surface stays a closed manifold.
void remove_slivers(SolidBody& body);

}  // namespace felt
