#pragma once

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Moves the ends of strokes onto each other and joins strokes (docs/design/editing.md#joining;
/// R43, R45). These are pure functions. The strokes that they return satisfy the invariants I1-I7.

/// The longest distance along the stroke over which the shift of an end fades out.
inline constexpr double kTipFadeMm = 25.0;
/// If the direction changes by less than this angle, two ends become a smooth joint; otherwise a
/// corner.
inline constexpr double kSmoothJoinBelowDeg = 30.0;

/// Returns the stroke with one end moved exactly to `target`. With L = min(fade_mm, half the length
/// of the stroke), a joint at arc length s from the end moves by shift * S(s/L), where S(x) = 1 -
/// 3x^2 + 2x^3, and its handles move with it. The stroke is cut at L, so that everything beyond
/// stays the same bit for bit. The widths stay the same, and so do the tangents at joints with
/// handles. Fails with kInvalidArgument for a closed stroke, a target that is not finite, or a
/// shift of more than L/1.5, because the ink would then fold back on itself; with kInvalidData if a
/// segment would become too short (I5).
Result<Stroke> with_tip_at(const Stroke& stroke, StrokeTip tip, Point target,
                           double fade_mm = kTipFadeMm);

/// Joins two strokes. The start of `second` must equal the end of `first`, bit for bit. The result
/// has the colour and medium of `first`. If the direction changes by less than `smooth_below_deg`,
/// both tangents become their average and the joint is smooth; otherwise it is a corner. The widths
/// are kept. If they differ at the joint, the profile gets two breakpoints there, whose u differ by
/// one unit in the last place. Fails with kInvalidArgument if a stroke is closed or the two do not
/// meet.
Result<Stroke> joined(const Stroke& first, const Stroke& second,
                      double smooth_below_deg = kSmoothJoinBelowDeg);

/// Closes a stroke whose end equals its start, bit for bit. The joint is made as in `joined`. Fails
/// with kInvalidArgument if it is already closed or its ends do not meet.
Result<Stroke> closed(const Stroke& stroke, double smooth_below_deg = kSmoothJoinBelowDeg);

}  // namespace felt
