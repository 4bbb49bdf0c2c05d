#pragma once

#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// A cut of two strokes into the same number of segments that correspond to each other.
struct CommonPieces {
  /// The parameters of both strokes at the ends of the pieces: from 0 to the number of segments,
  /// never decreasing. All joints of both strokes are among them, so each piece is a part of one
  /// segment; in one of the strokes it may be a point.
  std::vector<double> a_u, b_u;
};

/// Cuts two strokes, which run in the same direction, by their arc lengths so that corners and
/// tight bends of one lie on those of the other (docs/design/motion.md#pieces). Neighbouring joints
/// of both strokes become one cut.
CommonPieces common_pieces(const Stroke& a, const Stroke& b);

}  // namespace felt
