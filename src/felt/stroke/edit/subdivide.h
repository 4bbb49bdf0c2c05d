#pragma once

#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// The same ink in more or in fewer segments. Pure; I1-I6 hold; what is not named stays bit for
/// bit; the width profile is carried along (a breakpoint is added wherever u is stretched).

/// The stroke with a smooth joint at each of `us` (ascending, in [0, n]). A place nearer than
/// kMinSegmentMm to a joint, or to another place, gets that joint instead of a sliver. `joints`,
/// when given, is filled with the number of the joint for each place.
/// Error: kInvalidArgument when us are not ascending or not in range.
Result<Stroke> subdivided(const Stroke& stroke, std::span<const double> us,
                          std::vector<int>* joints = nullptr);

/// The stroke with as few segments as found between the joints `first` and `last` (numbers of
/// joints; on a closed stroke last <= first means through the seam; a whole closed stroke is first
/// = last): runs of segments between corners are fitted anew by one cubic each, with the tangents
/// at their outer joints kept, so that both G1 and what lies outside stay as they are. Every point
/// of the old curve is within `tolerance_mm` of the new one, and the other way round. `keep`:
/// numbers of joints that must stay joints, in place. `through`: the number of a joint whose place
/// stays on the curve, to 1e-10 mm, whether it stays a joint or not.
Result<Stroke> with_fewer_segments(const Stroke& stroke, int first, int last, double tolerance_mm,
                                   std::span<const int> keep = {}, int through = -1);

}  // namespace felt
