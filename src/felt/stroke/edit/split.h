#pragma once

#include <utility>

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Cutting and turning strokes round. The parts trace the same curve with the same width: the
/// segments at a cut are divided by de Casteljau, the width profile gets breakpoints where the
/// stroke parameter is stretched, everything else is copied bit for bit.

/// The part of an open stroke with u in [u0, u1], clamped to the stroke.
/// On a closed stroke u0 >= u1 means: from u0 through the seam to u1; u0 = u1 opens it there.
/// Error: kInvalidArgument when u0 >= u1 on an open stroke or either is NaN; kInvalidData when a
/// divided segment would be shorter than kMinSegmentMm (I5), since there are no slivers (R40).
Result<Stroke> sub_stroke(const Stroke& stroke, double u0, double u1);

/// The parts before and after u of an open stroke. They share the cut point bit for bit, and the
/// width there is the same. Error: as `sub_stroke`; a closed stroke is opened by that instead.
Result<std::pair<Stroke, Stroke>> split(const Stroke& stroke, double u);

/// The same ink drawn from its end to its start.
Stroke reversed(const Stroke& stroke);

}  // namespace felt
