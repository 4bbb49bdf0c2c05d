#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/point.h"

namespace felt {

/// A triangle mesh in the plane. Triangles turn from +x to +y.
struct PlaneMesh {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// The given edges, possibly divided.
  std::vector<std::array<std::uint32_t, 2>> edges;
};

/// Fills the area inside the edges (by the even-odd rule) with triangles: a constrained Delaunay
/// triangulation, refined until no angle is below 20.7 degrees (except at sharp corners of the
/// input) and no side is longer than `edge_mm`. Source: Shewchuk, "Delaunay refinement algorithms
/// for triangular mesh generation", Computational Geometry 22, 2002,
/// <https://doi.org/10.1016/S0925-7721(01)00047-5>; the implementation is CGAL's.
///
/// Requires that the edges meet only at their ends. Fails with kLimitExceeded if more than
/// `max_points` points are needed.
Result<PlaneMesh> fill_plane(const std::vector<Point>& points,
                             const std::vector<std::array<std::size_t, 2>>& edges, double edge_mm,
                             std::size_t max_points);

/// Divides the inside of a simple polygon into triangles whose corners are those of the polygon.
/// They turn from +x to +y. Fails if the polygon crosses itself or has no area.
Result<std::vector<std::array<std::uint32_t, 3>>> triangulate_ring(const std::vector<Point>& ring);

}  // namespace felt
