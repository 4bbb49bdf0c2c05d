#pragma once

#include <vector>

#include "felt/document/fill.h"
#include "felt/io/svg/svg_frame.h"
#include "felt/io/svg/svg_path_builder.h"

namespace felt {

/// Cuts a fill at the edges of a frame. The result may have no loop. A loop that is cut loses its
/// references to strokes.
void clip_fill(Fill& fill, const SvgFrame& frame);

/// Returns the parts of a line inside a frame, in order. A closed contour that lies completely
/// inside stays closed.
std::vector<SvgContour> clip_line(const SvgContour& contour, const SvgFrame& frame);

}  // namespace felt
