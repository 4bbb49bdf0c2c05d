#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "felt/base/result.h"
#include "felt/solid/plane_mesh.h"

namespace felt {

/// The squares u of half of the thickness of an inflated body, in mm^2: a polynomial of degree 2 on
/// each triangle of a mesh.
struct SquaredHeights {
  std::vector<double> at_points;
  /// By triangle: in the middle of the edge from corner k to the next one.
  std::vector<std::array<double, 3>> at_middles;
};

/// Solves
///
///   -laplace u = 4 inside,   u = 0 on the border.
///
/// `on_border` marks the points of the border; an edge is on the border if it belongs to one
/// triangle and both its ends are marked. On the other edges that belong to one triangle (axes of a
/// mirror symmetry), the slope of u across the edge is zero. sqrt(u) makes a ball of a disc, and
/// of a long strip an ellipse that is sqrt(2) times as thick as wide
/// (docs/design/solids.md#heights). Quadratic finite elements: exact for strips and ellipses, and
/// smooth between the points. The system is solved directly (Eigen, SimplicialLDLT). Fails if no
/// point is on the border, or if the system cannot be solved.
Result<SquaredHeights> squared_heights(const PlaneMesh& mesh,
                                       const std::vector<std::uint8_t>& on_border);

}  // namespace felt
