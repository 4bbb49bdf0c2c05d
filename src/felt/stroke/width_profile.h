#pragma once

#include <span>

#include "felt/stroke/stroke.h"

namespace felt {

/// Returns the width in mm of the profile at u [Paper eq. 3]: between two knots
///   W = (1 - tw) W1 + tw W2, tw = (u - u1) / (u2 - u1);
/// The result is exact at the knots, constant before the first and after the last, and 0 for an
/// empty profile. Takes O(log knots) time.
double width_at(std::span<const WidthKnot> profile, double u) noexcept;

/// Returns the tone of the profile at u, interpolated like the width.
double tone_at(std::span<const WidthKnot> profile, double u) noexcept;

/// Returns a breakpoint at u with the width and tone that the profile has there, so that adding it
/// changes nothing. If both neighbours have exactly the default tone of their widths, the result
/// also has exactly the default tone of its width.
WidthKnot knot_at(std::span<const WidthKnot> profile, double u) noexcept;

/// Returns true if the tone of any breakpoint differs from tone_of_width() of its width. Files
/// store tones only for such profiles.
bool has_own_tone(std::span<const WidthKnot> profile) noexcept;

/// Sets the tone of every breakpoint to tone_of_width() of its width.
void take_tone_of_width(std::span<WidthKnot> profile) noexcept;

}  // namespace felt
