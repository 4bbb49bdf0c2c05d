#pragma once

#include "felt/stroke/stroke.h"
#include "felt/tools/pull/strand.h"

namespace felt {

/// What a segment should look like when an edit leaves it (specification 5c, "Release").
struct SegmentShape {
  double least_handle = 0.04;  ///< at smooth joints, part of the arc length
  double most_handle = 1.0;    ///< part of the arc length
  double most_winding = 1.9;   ///< arc length over chord
};

/// How far the refit may move the ink, mm: below what pen and eye resolve.
inline constexpr double kRefitToleranceMm = 0.02;

/// True when segment i of the stroke is as asked. A standing handle at an end or a corner is fine.
bool is_well_shaped(const Stroke& stroke, int i, const SegmentShape& shape = {}) noexcept;

/// What a strand has become, with what changed in good shape: runs of segments that need fewer get
/// fewer; then those that wind or have a long handle are divided, and those with a short handle get
/// other handle lengths. Each step moves the curve by kRefitToleranceMm at most; what cannot be
/// mended within it stays as it is, and what did not change stays bit for bit.
/// Error: the strand breaks an invariant.
Result<Stroke> with_good_shapes(const Strand& strand);

}  // namespace felt
