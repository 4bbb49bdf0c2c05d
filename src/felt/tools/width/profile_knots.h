#pragma once

#include <span>
#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// A knot of a profile in work.
struct ProfileKnot {
  WidthKnot knot;
  bool stays = false;  ///< must be a knot of the result
};

/// The profile with as few knots as a greedy search finds, each one of the given ones, such that
/// none of those left out is farther than tolerance_mm, or kFollowedTone in its tone, from it. From
/// each knot the farthest one is taken that can be reached: the slopes that pass within the
/// tolerance of all knots so far are an interval (as in WidthFitter), and the straight line to a
/// knot must have a slope in it. The first and the last knot stay. Requires u strictly increasing.
/// Time: linear, for runs of bounded length.
std::vector<WidthKnot> thinned(std::span<const ProfileKnot> knots, double tolerance_mm);

/// The whole profile times a factor, from kMinWidthMm to max_width_mm, tones as they are; a knot
/// that was broader already keeps that as its limit.
std::vector<WidthKnot> scaled(std::span<const WidthKnot> knots, double factor, double max_width_mm);

}  // namespace felt
