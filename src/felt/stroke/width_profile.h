#pragma once

#include <span>

#include "felt/stroke/stroke.h"

namespace felt {

/// Width in mm of the profile at u [Paper eq. 3]: between two knots
///   W = (1 - tw) W1 + tw W2,  tw = (u - u1) / (u2 - u1);
/// exact at the knots, held beyond the first and the last, 0 for an empty profile. O(log knots).
double width_at(std::span<const WidthKnot> profile, double u) noexcept;

/// Tone of the profile at u, likewise.
double tone_at(std::span<const WidthKnot> profile, double u) noexcept;

/// The breakpoint that changes nothing at u: width and tone that the profile has there. Between two
/// of which the tone is exactly that of the width it is so too, not only to rounding.
WidthKnot knot_at(std::span<const WidthKnot> profile, double u) noexcept;

/// Whether any breakpoint has another tone than tone_of_width() of its width: files say the tones
/// of such profiles only.
bool has_own_tone(std::span<const WidthKnot> profile) noexcept;

/// Gives every breakpoint the tone of its width.
void take_tone_of_width(std::span<WidthKnot> profile) noexcept;

}  // namespace felt
