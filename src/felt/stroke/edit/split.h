#pragma once

#include <utility>

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Cuts and reverses strokes. The parts trace the same curve with the same width: the segments at a
/// cut are divided by de Casteljau, the width profile gets breakpoints where the stroke parameter
/// is stretched, and everything else is copied bit for bit.

/// Returns the part of a stroke with u in [u0, u1], clamped to the stroke. On a closed stroke, u0
/// >= u1 selects the part from u0 through the seam to u1. If u0 = u1, this is the whole stroke,
/// opened at u0. Fails with kInvalidArgument if u0 >= u1 on an open stroke, or if u0 or u1 is NaN;
/// with kInvalidData if a divided segment would be shorter than kMinSegmentMm (I5), because slivers
/// are not allowed (R40).
Result<Stroke> sub_stroke(const Stroke& stroke, double u0, double u1);

/// Returns the parts before and after u of an open stroke. They share the cut point bit for bit,
/// and the width there is the same. Fails like `sub_stroke`. To open a closed stroke, use
/// `sub_stroke`.
Result<std::pair<Stroke, Stroke>> split(const Stroke& stroke, double u);

/// Returns the same stroke in the opposite direction.
Stroke reversed(const Stroke& stroke);

}  // namespace felt
