#pragma once

#include <cstdint>
#include <vector>

#include "felt/base/result.h"
#include "felt/solid/plane_mesh.h"

namespace felt {

/// Returns half of the thickness of an inflated body at each point of a mesh, in mm: sqrt(u), where
/// u solves
///
///   -laplace u = 4 inside,   u = 0 at the points of the border.
///
/// On edges that belong to one triangle and are not on the border (axes of a mirror symmetry), the
/// slope of u across the edge is zero. A disc becomes a ball, and a long strip an ellipse that is
/// sqrt(2) times as thick as wide (docs/design/solids.md#heights). Linear finite elements; the
/// system is solved directly (Eigen, SimplicialLDLT).
///
/// Inner points get a height of at least a hundredth of their shortest edge, so that the two sides
/// never meet there. Fails if no point is on the border, or the system cannot be solved.
Result<std::vector<double>> inflated_heights(const PlaneMesh& mesh,
                                             const std::vector<std::uint8_t>& on_border);

}  // namespace felt
