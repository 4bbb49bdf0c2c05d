#pragma once

#include <optional>

#include "felt/motion/similarity.h"
#include "felt/motion/stroke_matches.h"

namespace felt {

/// The strokes of a match as a blend needs them: cut to their parts, in the same direction, and
/// with corresponding seams.
struct OrientedPair {
  Stroke a, b;
};

/// Returns the strokes of a match that has both. Returns nullopt if a part is too short to cut off.
std::optional<OrientedPair> oriented_pair(const Stroke& from, const Stroke& to,
                                          const StrokeMatch& match, const Similarity& motion);

}  // namespace felt
