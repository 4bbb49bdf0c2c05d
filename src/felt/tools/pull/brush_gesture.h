#pragma once

#include <memory>

#include "felt/document/stroke_index.h"
#include "felt/tools/pull/brush_reach.h"
#include "felt/tools/pull/pull_gesture.h"
#include "felt/tools/pull/touch_offset.h"

namespace felt {

/// Pulls a stroke with a brush (BrushPull): a function of the stroke at the touch and of how far
/// the pen has come since, so going back undoes it and the rate of samples means nothing (R23).
/// Feels like EditSpring about the place of the touch.
///
/// `hit` is what scene.index found under the touch. The touch itself moves nothing; `offset` says
/// whether the curve then comes to the pen (curve_displacement). A shape that would break an
/// invariant is not shown, the last good one stays.
std::unique_ptr<PullGesture> make_brush(const PenSample& touch, const Scene& scene,
                                        const StrokeHit& hit, const BrushOptions& options,
                                        TouchOffset offset = TouchOffset::kBlendedOut);

}  // namespace felt
