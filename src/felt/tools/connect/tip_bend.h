#pragma once

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Returns the stroke with one end moved exactly to `target` and the ink bent along its length: the
/// point at arc length s from the end moves by shift S(x) + turn L x (1 - x)^2, x = s/L, S(x) = 1 -
/// 3x^2 + 2x^3, L = reach_mm.
///
/// Unlike with_tip_at, which keeps the tangents of joints and is made for the 2 mm of a snap, this
/// also applies the slope of the law to the handles: a tangent T becomes T plus the slope, on both
/// sides of a joint, so that it stays smooth and the curve follows the law between the joints, too,
/// without dents. Without a `turn` the end keeps its tangent (R45 measures that angle); with one,
/// the unit vector d in which the ink leaves the end becomes d - turn. The stroke is cut at L, and
/// ink beyond it stays bit for bit.
///
/// Fails with kInvalidArgument if the stroke is closed, the target is not finite, the reach exceeds
/// the stroke, or the shift is more than half of the reach (at two thirds the ink would fold back
/// on itself); with kInvalidData if a segment would become too short (I5).
Result<Stroke> with_tip_bent(const Stroke& stroke, StrokeTip tip, Point target, double reach_mm,
                             Vec turn = {});

}  // namespace felt
