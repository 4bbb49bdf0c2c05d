#pragma once

#include <vector>

#include "felt/solid/solid.h"

namespace felt {

/// Divides a closed surface into its connected components, in the order of their first triangles.
/// Each gets the stroke and the colour of `body`, and its own number of holes.
std::vector<SolidBody> components_of(const SolidBody& body);

/// Returns points - edges + triangles: 2 for a ball, and 2 less for each hole through it.
int euler_number(const SolidBody& body) noexcept;

/// Returns the mean length of the edges in mm, or 0 without triangles.
double mean_edge_mm(const SolidBody& body) noexcept;

}  // namespace felt
