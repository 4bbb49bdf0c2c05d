#pragma once

#include "felt/stroke/stroke.h"
#include "felt/tools/pull/strand.h"

namespace felt {

/// The shape that segments should have after an edit (docs/design/editing.md#release).
struct SegmentShape {
  double min_handle = 0.04;  ///< at smooth joints, fraction of the arc length
  double max_handle = 1.0;   ///< fraction of the arc length
  double max_winding = 1.9;  ///< arc length divided by the chord
};

/// How far the refit may move the ink, mm. This is less than the pen and the eye can resolve.
inline constexpr double kRefitToleranceMm = 0.02;

/// Returns true if segment i of the stroke has the required shape. A zero-length handle at an end
/// or a corner is allowed.
bool is_well_shaped(const Stroke& stroke, int i, const SegmentShape& shape = {}) noexcept;

/// Returns the stroke of a strand, with its changed segments in the required shape: first,
/// consecutive segments are replaced by fewer segments if these suffice; then segments that wind or
/// have a long handle are divided, and segments with a short handle get new handle lengths. Each
/// step moves the curve by at most kRefitToleranceMm; a segment that cannot be improved within this
/// tolerance stays as it is. Unchanged segments stay bit for bit. Fails if the strand breaks an
/// invariant.
Result<Stroke> with_good_shapes(const Strand& strand);

}  // namespace felt
