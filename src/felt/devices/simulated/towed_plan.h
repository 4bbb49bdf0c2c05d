#pragma once

#include "felt/devices/simulated/scripted_hand.h"
#include "felt/haptics/bricks/stabiliser.h"

namespace felt {

/// Returns the movement of the pen with which a towed nib makes the movement `nib`: the pen is
/// ahead along the path by the length of the rope, because a nib that is pulled along the tangent
/// of its path stays on the path (the tractrix). First the pen pulls the rope taut. Requires
/// points 1 ms apart, as those of plan_movement().
RecordedPath ahead_by_rope(const RecordedPath& nib, const TowOptions& rope);

}  // namespace felt
