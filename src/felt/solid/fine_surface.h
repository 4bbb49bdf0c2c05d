#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "felt/solid/heights.h"

namespace felt {

/// How fine the surface of a body is.
struct SurfaceSpec {
  double max_turn_rad = 0.1;  ///< how far the normal turns along an edge
  double min_edge_mm = 0.1;   ///< edges that are shorter than twice this are not divided
  /// If the surface would have more triangles, the normal may turn farther.
  std::size_t max_triangles = std::numeric_limits<std::size_t>::max();
};

/// A triangle mesh with the half of the thickness at each point.
struct FineSurface {
  PlaneMesh mesh;  ///< without edges
  std::vector<std::uint8_t> on_border;
  std::vector<double> heights;  ///< in mm
};

/// Divides the triangles of a mesh until the normals of the body's surface at both ends of each
/// edge are nearly parallel. Near the border, where the surface is steep, triangles become long and
/// narrow; the edges of the border stay whole. The heights of new points are those of the
/// polynomials, so the result is as smooth as the solution, and costs no larger system. Inner
/// points get a height of at least a hundredth of their shortest edge, so that the two sides never
/// meet.
FineSurface fine_surface(const PlaneMesh& mesh, const std::vector<std::uint8_t>& on_border,
                         const SquaredHeights& squares, const SurfaceSpec& spec);

}  // namespace felt
