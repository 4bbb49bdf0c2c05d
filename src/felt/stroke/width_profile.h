#pragma once

#include <span>

#include "felt/stroke/stroke.h"

namespace felt {

/// Width in mm of the profile at u [Paper eq. 3]: between two knots
///   W = (1 - tw) W1 + tw W2,  tw = (u - u1) / (u2 - u1);
/// exact at the knots, held beyond the first and the last, 0 for an empty profile. O(log knots).
double width_at(std::span<const WidthKnot> profile, double u) noexcept;

}  // namespace felt
