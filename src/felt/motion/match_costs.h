#pragma once

#include <cstddef>

#include "felt/motion/stroke_shape.h"

namespace felt {

/// Compares strokes for match_strokes(). The weights are in docs/design/motion.md#correspondence.
struct MatchScale {
  double reach_mm = 1.0;  ///< the distance that costs 1
};

/// The cost of a pair, and how the strokes run.
struct MatchCost {
  double cost = 0.0;
  ShapePairing pairing;
};

/// Returns the cost of a pair. `a` must be where the motion of the drawing has moved it.
/// `rank_difference` is the difference of the positions in drawing order, 0..1. If the distance
/// alone costs more than `limit`, the cost may be too small, but it is at least the limit.
MatchCost match_cost(const StrokeShape& a, const StrokeShape& b, const MatchScale& scale,
                     double rank_difference, double limit) noexcept;

}  // namespace felt
