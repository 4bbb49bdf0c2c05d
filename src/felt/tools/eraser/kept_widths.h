#pragma once

#include <vector>

#include "felt/stroke/stroke.h"
#include "felt/tools/eraser/ink_narrowing.h"

namespace felt {

/// Returns the breakpoints of a stroke after its ink was narrowed, or none if it was not touched.
/// `drawn` is the stroke `original` with drawn_knots(). The drawn width is that of `narrowed`; away
/// from the touched parts, the breakpoints are those of the original, so the ink there is equal
/// both as it is drawn and by equation (3).
std::vector<WidthKnot> kept_widths(const Stroke& original, const Stroke& drawn,
                                   const InkNarrowing::Result& narrowed);

}  // namespace felt
