#pragma once

#include "felt/stroke/stroke.h"

namespace felt {

/// The changes that mend_rounding() made to a stroke.
struct MendedStroke {
  int straightened = 0;  ///< joints made exactly smooth again
  int corners = 0;       ///< smooth joints that became corners
  int lengthened = 0;    ///< ends of strokes moved outwards, because a segment was too short
  int knots = 0;         ///< width breakpoints removed, because two had the same u

  [[nodiscard]] bool any() const noexcept {
    return straightened + corners + lengthened + knots > 0;
  }
};

/// Another program may write coordinates with fewer digits. As a result, smooth joints are no
/// longer exactly smooth, and `Stroke::create` rejects the stroke (I2). To repair it,
/// mend_rounding() moves handles by less than kMaxMendedMm, and an end of the stroke by less than
/// twice kMaxMendedMm.
inline constexpr double kMaxMendedMm = 0.001;
/// A joint that turns by at most this many degrees is assumed to have been smooth before rounding.
inline constexpr double kMaxMendedDeg = 1.0;

/// Looks at the joints of `data` that are declared smooth. A joint that turns by at most
/// kMaxMendedDeg becomes exactly smooth, if its handles move by less than kMaxMendedMm; any other
/// joint that is not exactly smooth becomes a corner. A first or last segment that is slightly too
/// short (I5) is lengthened at the end of the stroke. If two width breakpoints have the same u, one
/// is removed. All valid data stays the same bit for bit. Other errors are not repaired;
/// `Stroke::create` reports them.
MendedStroke mend_rounding(StrokeData& data);

}  // namespace felt
