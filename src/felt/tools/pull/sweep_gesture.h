#pragma once

#include <memory>

#include "felt/document/stroke_index.h"
#include "felt/tools/pull/edit_weights.h"
#include "felt/tools/pull/pull_gesture.h"

namespace felt {

struct SweepOptions {
  /// The stroke yields to the pen with this time constant, s (docs/design/editing.md#sweep: 50 ms).
  double time_constant_s = 0.050;
  WeightKind weights = WeightKind::kSoft;
};

/// Makes a gesture that redraws a stroke along the path of the pen (docs/design/editing.md#sweep):
/// the point nearest to the pen moves towards the pen with a time constant, and this point changes
/// as the pen moves along the stroke. The result depends on the path of the pen, so moving back
/// does not undo the change. The force is SweepSpring around the curve as it is now.
///
/// `hit` is the point of a stroke that scene.index found at the touch. The sample rate has no
/// effect, because the path of the pen is processed in steps of 1 ms from the touch on.
std::unique_ptr<PullGesture> make_sweep(const PenSample& touch, const Scene& scene,
                                        const StrokeHit& hit, const SweepOptions& options);

}  // namespace felt
