#pragma once

#include <memory>

#include "felt/document/stroke_index.h"
#include "felt/tools/pull/pull_gesture.h"

namespace felt {

struct SweepOptions {
  /// The stroke gives way to the pen with this time constant, s (specification 5c: 50 ms).
  double time_constant_s = 0.050;
};

/// Draws a stroke over again along the pen's way (specification 5c, "Sweep"): what is nearest to
/// the pen relaxes towards it, and what is nearest wanders along with the pen. Not undone by moving
/// back: it remembers its path. Feels like SweepSpring about the curve as it is now.
///
/// `hit` is what scene.index found under the touch. The rate of samples means nothing: the pen's
/// way is walked in steps of 1 ms from the touch on, whatever samples it comes in.
std::unique_ptr<PullGesture> make_sweep(const PenSample& touch, const Scene& scene,
                                        const StrokeHit& hit, const SweepOptions& options);

}  // namespace felt
