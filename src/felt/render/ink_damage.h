#pragma once

#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// The area of the page that must be repainted, in mm: small rectangles that may overlap.
using InkDamage = std::vector<Rect>;

/// Adds the area of all ink of a stroke, segment by segment.
void add_ink(const Stroke& stroke, InkDamage& damage);

/// Adds the area in which two shapes of a stroke differ: for example, if a line is pulled at one
/// point, the area around that point. Leaves out segments at the beginning and the end that are
/// equal bit for bit.
void add_difference(const Stroke& before, const Stroke& after, InkDamage& damage);

}  // namespace felt
