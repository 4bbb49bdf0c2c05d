#include "felt/tools/pencil/pencil_options.h"

#include <algorithm>

namespace felt {

PencilSettings pencil_settings(const OptionValues& values) {
  using Row = PencilOption::Row;
  PencilSettings s;
  s.medium = values.open_choice(Row::kMedium);
  s.refine = values.is_on(Row::kRefine);
  s.keep_separate = values.is_on(Row::kKeepSeparate);
  s.retrace_n = values.number(Row::kRetrace);
  s.width_steps = values.is_on(Row::kWidthSteps);
  s.strength = values.number(Row::kStrength);

  WidthMapOptions& widths = s.ink.width_map;
  widths.min_mm = values.number(Row::kMinWidth);
  widths.max_mm = std::max(widths.min_mm, values.number(Row::kMaxWidth));
  widths.gamma = values.number(Row::kGamma);
  widths.absent_pressure = values.number(Row::kMousePressure);
  widths.absent_tilt_deg = values.number(Row::kMouseTilt);
  s.ink.width.min_mm = widths.min_mm;
  s.ink.width.max_mm = widths.max_mm;
  s.ink.curve.tolerance_mm = values.number(Row::kTolerance);
  s.ink.filter_artefacts = true;

  s.snap.mode = static_cast<SnapMode>(values.choice(Row::kSnap));
  s.snap.reach_mm = values.number(Row::kReach);
  s.snap.radius_mm = values.number(Row::kSnapRadius);
  s.snap.force_n = values.number(Row::kAttraction);

  s.stabiliser.kind = static_cast<StabiliserKind>(values.choice(Row::kStabiliser));
  s.stabiliser.mass_g = values.number(Row::kStabiliserMass);
  s.stabiliser.length_mm = values.number(Row::kStabiliserLength);

  if (values.is_on(Row::kSteady)) {
    s.steady = Shake{values.number(Row::kSteadyHz), values.number(Row::kSteadyAmplitude),
                     values.number(Row::kSteadyAxis)};
  }
  s.gestures.scratch_out = values.is_on(Row::kScratchOut);
  s.gestures.double_loop = values.is_on(Row::kDoubleLoop);
  s.gestures.shapes = values.is_on(Row::kShapes);
  return s;
}

}  // namespace felt
