#pragma once

#include <vector>

#include "felt/document/document.h"
#include "felt/document/stroke_index.h"

namespace felt {

/// A point that two strokes share: an end of at least one of them lies on the other (R33).
/// Junctions connect strokes of different colour, medium or layer.
struct Junction {
  double u = 0.0;        ///< parameter on the stroke that was passed in
  StrokeId other;        ///< the stroke that shares the point
  double other_u = 0.0;  ///< parameter on the other stroke
  Point point;           ///< position of the end
  bool editable = true;  ///< false if the layer of the other stroke is locked
};

/// Two points closer than this count as one: larger than the rounding of files, too small to see.
inline constexpr double kSharedPointMm = 0.02;

/// Returns the points that a stroke of the document shares with other strokes on visible layers:
/// their ends on its curve, and its ends on their curves. On locked layers only the first kind is
/// found. Sorted by the other stroke and its u. Linear in the segments of the stroke and the ink
/// near them.
std::vector<Junction> junctions_of(const Document& document, const StrokeIndex& index, StrokeId id,
                                   const Stroke& stroke);

}  // namespace felt
