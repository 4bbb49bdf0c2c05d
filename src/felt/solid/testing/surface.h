#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "felt/geometry/vec3.h"
#include "felt/solid/solid.h"

namespace felt::testing {

/// A triangle mesh as a file has it: corners as floats.
struct Surface {
  using Corner = std::array<float, 3>;
  std::vector<Corner> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// Returns a body with its coordinates rounded to float.
Surface surface_of(const SolidBody& body);

/// Returns the surface with equal points made one, as readers of STL do.
Surface welded(const Surface& surface);

/// The topology and size of a surface.
struct SurfaceReport {
  /// The first fault, or empty: an edge without exactly one triangle in each direction, a
  /// degenerate triangle, a number that is not finite, a point without a triangle, or a point where
  /// the surface touches itself.
  std::string fault;
  std::size_t components = 0;
  int euler = 0;  ///< points - edges + triangles
  double volume_mm3 = 0.0;
};

/// Examines a surface. Shares no code with check_body().
SurfaceReport examine(const Surface& surface);

}  // namespace felt::testing
