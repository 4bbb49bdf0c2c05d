#pragma once

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Returns the stroke with one end moved exactly to `target` and the ink bent along its length: the
/// point at arc length s from the end moves by d S(x) + turn L x (1 - x)^2, with d the vector from
/// the end to the target, x = s/L, S(x) = 1 - 3x^2 + 2x^3, L = reach_mm.
///
/// with_tip_at() keeps the tangents of joints and is meant for the short distance of a snap (2 mm).
/// This function also turns the handles: it adds the derivative of the displacement by arc length
/// to the unit tangent, on both sides of a joint. So smooth joints stay smooth, and the curve
/// between the joints follows the same displacement, without dents. If `turn` is zero, the end
/// keeps its tangent (R45 measures the angle at the joint). Otherwise the unit tangent v at the
/// end, which points out of the stroke, becomes v minus `turn`. The stroke is cut at the arc length
/// L, and ink beyond the cut stays bit for bit.
///
/// Fails with kInvalidArgument if the stroke is closed, the target is not finite, the reach is more
/// than the stroke's length, or the end moves by more than half of the reach (at two thirds the ink
/// would fold back on itself); with kInvalidData if a segment would become too short (I5).
Result<Stroke> with_tip_bent(const Stroke& stroke, StrokeTip tip, Point target, double reach_mm,
                             Vec turn = {});

}  // namespace felt
