#pragma once

#include <memory>

#include "felt/tools/pull/pull_gesture.h"

namespace felt {

struct PushOptions {
  double radius_mm = 3.0;  ///< of the nib, specification 5c
};

/// A round nib of felt that pushes strokes out of its way from outside and never pulls (R27,
/// specification 5c, "Push"; NibPush): after each sample no stroke that may be edited, and that
/// the nib has met, is nearer to the pen than its radius; what it does not touch does not move. It
/// remembers its path: going back leaves what was pushed where it is.
///
/// Give move() the touch too: a nib that lands on a line parts it. Feels like PushSpring.
std::unique_ptr<PullGesture> make_push(const PenSample& touch, const Scene& scene,
                                       const PushOptions& options);

}  // namespace felt
