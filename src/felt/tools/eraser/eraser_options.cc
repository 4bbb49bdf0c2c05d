#include "felt/tools/eraser/eraser_options.h"

namespace felt {

EraserSettings eraser_settings(const OptionValues& values) {
  return {.mode = static_cast<EraserMode>(values.choice(EraserOption::kMode)),
          .radius_mm = values.number(EraserOption::kRadius),
          .include_width = values.is_on(EraserOption::kIncludeWidth),
          .press_through = values.is_on(EraserOption::kPressThrough),
          .strength = values.number(EraserOption::kStrength),
          .guard_n = values.number(EraserOption::kGuard)};
}

}  // namespace felt
