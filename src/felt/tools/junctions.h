#pragma once

#include <vector>

#include "felt/document/document.h"
#include "felt/document/stroke_index.h"

namespace felt {

/// A point that two strokes share: an end of at least one of them lies on the other (R33). This is
/// what makes strokes of different colour, medium or layer connected.
struct Junction {
  double u = 0.0;        ///< on the stroke that was asked for
  StrokeId other;        ///< the stroke that shares the point
  double other_u = 0.0;  ///< on that one
  Point point;           ///< of the end
  bool editable = true;  ///< false if the layer of the other stroke is locked
};

/// Two points this near to each other are one: what files round, and less than anyone sees.
inline constexpr double kSharedPointMm = 0.02;

/// The points that a stroke of the document shares with others on visible layers: their ends on its
/// curve, and its ends on their curves. On locked layers only ends are found. In the order of the
/// other stroke and its u. Costs the segments of the stroke, and what lies around them.
std::vector<Junction> junctions_of(const Document& document, const StrokeIndex& index, StrokeId id,
                                   const Stroke& stroke);

}  // namespace felt
