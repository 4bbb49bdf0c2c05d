#pragma once

#include <cstddef>

#include "felt/geometry/cubic.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Length of the handles that give_handles() adds.
inline constexpr double kStandingHandleMm = 1e-3;
/// Length of the handles of ink that is compressed below the length that I5 requires.
inline constexpr double kSliverHandleMm = 0.03;

/// Gives the handles of a segment that have no length at smooth joints the length
/// kStandingHandleMm, in the direction of the tangent, so that their directions do not depend on
/// other control points (docs/design/editing.md#smooth-joints). The curve moves by less than a
/// micrometre.
void give_handles(StrokeData& data, std::size_t segment);

/// Lengthens the handles of a segment of `data` that is shorter than I5 allows to at least
/// kSliverHandleMm, in their own direction, or in that of `before` if they have no length. Does
/// nothing if the segment is equal to `before`. Returns true if it changed something.
bool keep_length(StrokeData& data, std::size_t segment, const Cubic& before);

/// Makes both handles of a smooth joint collinear again, in the direction of the longer one, or of
/// `fallback` if both have no length. For joints that rounding or extreme compression has turned.
void keep_smooth(StrokeData& data, std::size_t joint, Vec fallback);

}  // namespace felt
