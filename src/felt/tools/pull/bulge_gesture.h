#pragma once

#include <memory>

#include "felt/tools/pull/pull_gesture.h"

namespace felt {

/// How a bulge gesture moves lines.
struct BulgeOptions {
  double radius_mm = 20.0;    ///< of the circle within which lines move
  bool pinches = false;       ///< draws lines to the centre instead of spreading them
  double tolerance_mm = 0.1;  ///< as BrushOptions
};

/// Returns the gain of the radial map (RadialMap) if the pen is at this distance from the centre:
/// limit d / (d + radius / 2) with d the distance beyond the first 0.5 mm, which is 0 in the middle
/// and approaches kMaxGain or kMinGain.
double bulge_gain(double distance_mm, const BulgeOptions& options) noexcept;

/// Makes a gesture that spreads all editable lines around the touch, or draws them together
/// (BulgePull). The result depends only on the document at the touch and on the distance of the pen
/// from the touch, so moving back undoes the change. Points that lines share move in the same way
/// with each of them. Lines of locked layers stay, also where a line that moves ends on them. The
/// force is EditSpring around the touch.
std::unique_ptr<PullGesture> make_bulge(const PenSample& touch, const Scene& scene,
                                        const BulgeOptions& options);

}  // namespace felt
