#pragma once

#include <memory>

#include "felt/tools/pull/pull_gesture.h"

namespace felt {

struct PushOptions {
  double radius_mm = 3.0;  ///< radius of the nib (docs/design/editing.md#push)
};

/// Makes a gesture that pushes strokes aside with a soft round nib and never pulls them (R27,
/// docs/design/editing.md#push; NibPush). After each sample, no editable stroke that the nib has
/// met is nearer to the pen than the radius of the nib, unless it shares a point with others and
/// cannot be joined to them there; strokes that the nib does not touch move only with such points.
/// The result depends on the path of the pen: moving back does not move pushed strokes back.
///
/// Call move() with the touch, too, because a nib that lands on a line pushes it aside. The force
/// is PushSpring.
std::unique_ptr<PullGesture> make_push(const PenSample& touch, const Scene& scene,
                                       const PushOptions& options);

}  // namespace felt
