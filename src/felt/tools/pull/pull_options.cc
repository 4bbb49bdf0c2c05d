#include "felt/tools/pull/pull_options.h"

namespace felt {

PullSettings pull_settings(const OptionValues& values) {
  using Row = PullOption::Row;
  PullSettings s;
  s.mode = static_cast<PullMode>(values.choice(Row::kMode));
  s.brush.radius_mm = values.number(Row::kRadius);
  s.brush.free_ends = values.is_on(Row::kFreeEnds);
  s.brush.tolerance_mm = values.number(Row::kTolerance);
  s.grab.weights = static_cast<WeightKind>(values.choice(Row::kWeights));
  s.grab.pins_joints = !s.brush.free_ends;
  s.grab.affected_mm = values.number(Row::kAffected);
  s.push.radius_mm = values.number(Row::kNibRadius);
  s.sweep.weights = s.grab.weights;
  s.sweep.time_constant_s = values.number(Row::kSweepTime);
  s.bulge = {.radius_mm = s.brush.radius_mm,
             .pinches = s.mode == PullMode::kPinch,
             .tolerance_mm = s.brush.tolerance_mm};
  s.offset = values.is_on(Row::kKeepOffset) ? TouchOffset::kKept : TouchOffset::kBlendedOut;
  s.grab_radius_mm = values.number(Row::kGrabRadius);
  s.yield_s = values.number(Row::kYield);
  s.strength = values.number(Row::kStrength);
  return s;
}

}  // namespace felt
