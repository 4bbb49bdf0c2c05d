#pragma once

#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Divides a stroke into more or fewer segments with the same ink. All functions are pure. The
/// results satisfy the invariants I1-I7, and the rest of the stroke stays the same bit for bit. The
/// widths are kept; where u is stretched, a breakpoint is added.

/// Returns the stroke with a smooth joint at each parameter u in `us`. If an element of `us` is
/// nearer than kMinSegmentMm to an existing joint or to a joint just added, that joint is used
/// instead, so that no slivers are made. At a cusp the joint is a corner. If `joints` is not null,
/// stores for each element of `us` the number of its joint in the result; joint 0 is the start.
/// Fails with kInvalidArgument if `us` are not ascending or not in [0, n].
Result<Stroke> subdivided(const Stroke& stroke, std::span<const double> us,
                          std::vector<int>* joints = nullptr);

/// Merges segments between the joints with the numbers `first` and `last`. On a closed stroke, the
/// part between them contains the seam if last < first, and is the whole stroke if they are equal.
/// Each run, that is, consecutive segments without a corner between them, is replaced by one cubic
/// if there is a cubic within the tolerance. The tangents at the outer joints of a run are kept, so
/// that G1 and the rest of the stroke do not change. Every point of the old curve is within
/// `tolerance_mm` of the new one, and vice versa. The joints numbered in `keep` remain joints at
/// the same position. Even if joint `through` is removed, the curve still passes within 1e-10 mm of
/// its position. Fails with kInvalidArgument if `first` or `last` is not on the stroke or the
/// tolerance is negative.
Result<Stroke> with_fewer_segments(const Stroke& stroke, int first, int last, double tolerance_mm,
                                   std::span<const int> keep = {}, int through = -1);

}  // namespace felt
