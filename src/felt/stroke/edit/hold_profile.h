#pragma once

#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// The drawn width (DrawnProfile) near a breakpoint depends on the next breakpoints on both sides.
/// These functions add breakpoints for tools that remove ink and must not change the rest.

/// Returns the breakpoints of a stroke, and more of them on the drawn profile. Straight lines
/// between them are within the tolerance of the drawn radius, and of the drawn tone within 0.02. So
/// a part of the profile can be replaced or cut off, and the rest looks the same.
std::vector<WidthKnot> drawn_knots(const Stroke& stroke, double tolerance_mm);

/// Returns the breakpoints of a stroke, and more of them on the straight lines of equation (3)
/// close to those at which these lines have a kink. With them, the drawn radius is within the
/// tolerance of equation (3).
std::vector<WidthKnot> held_knots(const Stroke& stroke, double tolerance_mm);

}  // namespace felt
