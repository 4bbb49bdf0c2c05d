#pragma once

#include "felt/stroke/stroke.h"

namespace felt {

/// What mend_rounding() changed in a stroke.
struct MendedStroke {
  int straightened = 0;  ///< joints made exactly smooth again
  int corners = 0;       ///< smooth joints that became corners
  int lengthened = 0;    ///< ends of strokes moved outwards, because a segment was too short
  int knots = 0;         ///< width breakpoints left out, because two fell on one place

  [[nodiscard]] bool any() const noexcept {
    return straightened + corners + lengthened + knots > 0;
  }
};

/// Another program may write coordinates with fewer digits than they had; then no smooth joint is
/// exactly smooth any more, and `Stroke::create` refuses the stroke (I2). This moves control points
/// by at most this much, in mm, so that it is one again.
inline constexpr double kMaxMendedMm = 0.001;
/// A joint that turns by more than this was not smooth before, in degrees.
inline constexpr double kMaxMendedDeg = 1.0;

/// Makes the joints of `data` that are declared smooth exactly smooth, if they turn by at most
/// kMaxMendedDeg and the handles move by less than kMaxMendedMm; others become corners. A first
/// or last segment that is a hair shorter than a segment may be (I5) is lengthened at the end of
/// the stroke; of two width breakpoints at one place one is left out. What is right stays as it is,
/// bit for bit. Data that is no stroke for other reasons stays wrong; `Stroke::create` says why.
MendedStroke mend_rounding(StrokeData& data);

}  // namespace felt
