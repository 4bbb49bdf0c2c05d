#pragma once

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Moving the ends of strokes onto each other and making one stroke of them (specification 5g,
/// architecture section 10; R43, R45). Pure: strokes in, strokes out, I1-I6 hold.

/// Length over which the shift of an end fades, at most.
inline constexpr double kTipFadeMm = 25.0;
/// Two ends whose ink turns by less than this become a smooth joint, else a corner.
inline constexpr double kSmoothJoinBelowDeg = 30.0;

/// The same ink with one end moved exactly to `target`. With L = min(fade_mm, half the stroke), a
/// place at arc length s from the end moves by shift * S(s/L), S(x) = 1 - 3x^2 + 2x^3, evaluated at
/// the joints, whose handles go along; what is farther than L stays bit for bit, for which the
/// stroke is cut at L. Tangents at the joints stay (where a handle stands for them), widths too.
/// Error: kInvalidArgument for a closed stroke, a target that is not finite, or a shift of more
/// than L/1.5, over which the ink would fold back on itself; kInvalidData when a segment would
/// become too short (I5).
Result<Stroke> with_tip_at(const Stroke& stroke, StrokeTip tip, Point target,
                           double fade_mm = kTipFadeMm);

/// One stroke, `first` and then `second`, which starts where first ends, bit for bit. Their colour
/// and material are those of first. Where the ink turns by less than `smooth_below_deg` both
/// tangents become their average direction and the joint is smooth; else it is a corner. Widths are
/// carried: where they differ the profile steps within one unit in the last place of u.
/// Error: kInvalidArgument when one is closed or they do not meet.
Result<Stroke> joined(const Stroke& first, const Stroke& second,
                      double smooth_below_deg = kSmoothJoinBelowDeg);

/// A closed stroke from one that ends where it starts, bit for bit; the joint as in `joined`.
/// Error: kInvalidArgument when it is closed already or its ends do not meet.
Result<Stroke> closed(const Stroke& stroke, double smooth_below_deg = kSmoothJoinBelowDeg);

}  // namespace felt
