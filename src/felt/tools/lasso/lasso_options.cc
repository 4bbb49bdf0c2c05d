#include "felt/tools/lasso/lasso_options.h"

namespace felt {

LassoSettings lasso_settings(const OptionValues& values) {
  using Row = LassoOption::Row;
  return {.mode = static_cast<LassoMode>(values.choice(Row::kMode)),
          .take = static_cast<LassoTake>(values.choice(Row::kTake)),
          .combine = static_cast<LassoCombine>(values.choice(Row::kCombine)),
          .click_radius_mm = values.number(Row::kClickRadius),
          .strength = values.number(Row::kStrength)};
}

}  // namespace felt
