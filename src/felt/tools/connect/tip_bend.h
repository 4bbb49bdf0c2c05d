#pragma once

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// The same ink with one end moved exactly to `target`, bent along the way: the point at arc length
/// s from the end moves by shift S(x) + turn L x (1 - x)^2, x = s/L, S(x) = 1 - 3x^2 + 2x^3,
/// L = reach_mm.
///
/// Unlike with_tip_at, which keeps the tangents of joints and is made for the 2 mm of a snap, the
/// handles move by the slope of this law as well: a tangent T becomes T plus the slope, on both
/// sides of a joint, so that it stays smooth, and the curve follows the law between the joints too,
/// without dents. Without a `turn` the end keeps its tangent (R45 measures that angle); with it,
/// the unit vector d in which the ink leaves the end becomes d - turn. What is farther than L stays
/// bit for bit, and the stroke is cut there.
///
/// Error: kInvalidArgument for a closed stroke, a target that is not finite, a reach that exceeds
/// the stroke, or a shift of more than half of the reach, not far from where the ink would fold
/// back on itself (two thirds); kInvalidData if a segment would become too short (I5).
Result<Stroke> with_tip_bent(const Stroke& stroke, StrokeTip tip, Point target, double reach_mm,
                             Vec turn = {});

}  // namespace felt
