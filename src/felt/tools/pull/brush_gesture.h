#pragma once

#include <memory>

#include "felt/document/stroke_index.h"
#include "felt/tools/brush_reach.h"
#include "felt/tools/pull/pull_gesture.h"
#include "felt/tools/pull/touch_offset.h"

namespace felt {

/// Makes a gesture that pulls a stroke with a brush (BrushPull). The result depends only on the
/// stroke at the touch and on the displacement of the pen since the touch, so moving back undoes
/// the change and the sample rate has no effect (R23). The force is EditSpring around the point of
/// the touch.
///
/// `hit` is the point of a stroke that scene.index found at the touch. The touch itself moves
/// nothing. `offset` says whether the curve moves to the pen after the touch (curve_displacement).
/// If a shape would break an invariant, the last valid shape is kept.
std::unique_ptr<PullGesture> make_brush(const PenSample& touch, const Scene& scene,
                                        const StrokeHit& hit, const BrushOptions& options,
                                        TouchOffset offset = TouchOffset::kBlendedOut);

}  // namespace felt
