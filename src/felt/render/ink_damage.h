#pragma once

#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// What of the sheet is to be painted again, in mm: small rectangles that may overlap.
using InkDamage = std::vector<Rect>;

/// Everything that a stroke inks, segment by segment.
void add_ink(const Stroke& stroke, InkDamage& damage);

/// Where two shapes of a stroke differ: of a line that is pulled in one place, that place. What
/// both begin and end with alike is left out, to the bit.
void add_difference(const Stroke& before, const Stroke& after, InkDamage& damage);

}  // namespace felt
