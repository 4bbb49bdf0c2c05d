#pragma once

#include "felt/recognise/shape_guess.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Returns points, joints and `closed` of a shape. It starts where the drawn path started, or at
/// its first corner, and has the direction of that path. Widths, medium and colour are left to the
/// caller.
StrokeData shape_curve(const ShapeGuess& shape);

}  // namespace felt
