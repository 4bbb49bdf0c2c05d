#include "felt/tools/transform/transform_options.h"

namespace felt {

TransformSettings transform_settings(const OptionValues& values) {
  using Row = TransformOption::Row;
  return {.mode = static_cast<TransformMode>(values.choice(Row::kMode)),
          .constrain = values.is_on(Row::kConstrain),
          .duplicate = values.is_on(Row::kDuplicate),
          .about_centre = values.is_on(Row::kAboutCentre),
          .scale_widths = values.is_on(Row::kScaleWidths),
          .grab_radius_mm = values.number(Row::kGrabRadius),
          .strength = values.number(Row::kStrength)};
}

}  // namespace felt
