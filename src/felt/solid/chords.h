#pragma once

#include <cstdint>
#include <vector>

#include "felt/solid/plane_mesh.h"

namespace felt {

/// Returns the mesh with a new point in the middle of each edge that joins two points of the
/// border, but is not on the border itself. Otherwise the front and the back of the body would both
/// have this edge, and four triangles would meet there. `on_border` gets a value for each new
/// point: 0. Edges of the border are those of `mesh.edges` for which `is_axis` is 0.
PlaneMesh without_chords(PlaneMesh mesh, const std::vector<std::uint8_t>& is_axis,
                         std::vector<std::uint8_t>& on_border);

}  // namespace felt
