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

/// Two points within this distance count as one. It is larger than the rounding of files and too
/// small to see.
inline constexpr double kSharedPointMm = 0.02;

/// Returns the points that a stroke of the document shares with other strokes on visible layers:
/// the ends of other strokes that lie on its curve, and its own ends that lie on the curves of
/// other strokes, which may be on locked layers. The result is sorted by `other`, then by
/// `other_u`. Takes time linear in the number of segments of the stroke and in the amount of ink
/// near them.
std::vector<Junction> junctions_of(const Document& document, const StrokeIndex& index, StrokeId id,
                                   const Stroke& stroke);

}  // namespace felt
