#pragma once

#include <span>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// How a hand shakes, in the axes of its shaking.
struct AxisShake {
  double hz = 5.0;
  Vec swing_mm{0.7, 0.35};  ///< standard deviations along and across the axis
};

/// The shaking in a complete line.
struct LineShaking {
  std::vector<Vec> shaking_mm;  ///< of each sample, along and across the axis
  double jerk_mm_per_s3 = 0.0;  ///< of the intended motion, as in ShakeModel
};

/// Estimates the shaking in a complete line of samples, of which `steps_s` are the times since the
/// sample before (the first is ignored). The samples may be at any times.
///
/// The samples become nodes 7.5 ms apart, ShakeSmoother starts from kStarts, and the result is the
/// mean of what it finds, because no start is best for all lines
/// (docs/design/steady-hand.md, "At pen-up"). Starts whose shaking is much larger or smaller than
/// that of the hand weigh less. Takes linear time: a line of more than kMaxCareS has one start and
/// fewer passes, so that pen-up stays quick.
LineShaking find_line_shaking(std::span<const Vec> positions_mm, std::span<const double> steps_s,
                              const AxisShake& shake);

}  // namespace felt
