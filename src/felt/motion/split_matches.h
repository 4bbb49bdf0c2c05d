#pragma once

#include <span>
#include <vector>

#include "felt/motion/match_costs.h"
#include "felt/motion/stroke_matches.h"

namespace felt {

/// The strokes of one key drawing, as the search for split strokes needs them. For the first
/// drawing, all members are at their positions after the motion of the drawing.
struct SplitSide {
  std::span<const StrokeShape> shapes;
  std::vector<std::vector<Point>> lines;  ///< coarse_line() of each stroke
};

/// Looks for strokes of one drawing that are two strokes in the other, and replaces their matches.
/// `limit` is the cost of a stroke of each drawing without partner. Given matches stay.
void match_split_strokes(const SplitSide& from, const SplitSide& to, const MatchScale& scale,
                         double limit, std::vector<StrokeMatch>& matches);

}  // namespace felt
