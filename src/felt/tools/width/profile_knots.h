#pragma once

#include <span>
#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// A knot of a profile being built.
struct ProfileKnot {
  WidthKnot knot;
  bool stays = false;  ///< must be a knot of the result
};

/// Returns a profile that keeps some of the given knots, as few as a greedy search finds. No
/// omitted knot differs from the result by more than tolerance_mm in width or kFollowedTone in
/// tone. From each knot that is kept, the search goes on to the farthest knot such that a straight
/// line to it passes all knots in between within the tolerance. For this, the search stores the
/// interval of the slopes that pass all knots so far within the tolerance (as in WidthFitter); the
/// slope to the next knot must lie in that interval. The first and the last knot stay. Requires
/// strictly increasing u. Takes linear time, because the number of knots in between is bounded.
std::vector<WidthKnot> thinned(std::span<const ProfileKnot> knots, double tolerance_mm);

/// Returns the profile scaled by a factor, clamped to kMinWidthMm..max_width_mm; tones do not
/// change. If a knot was already broader than max_width_mm, its own width is its limit.
std::vector<WidthKnot> scaled(std::span<const WidthKnot> knots, double factor, double max_width_mm);

}  // namespace felt
