#pragma once

#include <vector>

#include "felt/document/document.h"
#include "felt/document/drawing_guide.h"
#include "tests/drawing/gestures/dice.h"

namespace felt::gestures {

/// Returns a random guide of any kind on or near `document`; it keeps check_drawing_guide() and
/// traces only strokes that exist.
DrawingGuide random_guide(Dice& dice, const Document& document);

/// Returns a path of the pen along a guide, or across it: of `count` + 1 points, up to 2 mm beside
/// it. The pen keeps to the line or circle through the point where it begins, if the guide has
/// many.
std::vector<Point> path_along(Dice& dice, const DrawingGuide& guide, int count);

}  // namespace felt::gestures
