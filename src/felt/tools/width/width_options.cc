#include "felt/tools/width/width_options.h"

#include <algorithm>

namespace felt {

WidthSettings width_settings(const OptionValues& values) {
  using Row = WidthOption::Row;
  WidthSettings s;
  s.mode = static_cast<WidthMode>(values.choice(Row::kMode));
  s.direction = static_cast<WidthDirection>(values.choice(Row::kDirection));
  s.rate_mm_per_s = values.number(Row::kRate);
  s.reach_mm = values.number(Row::kReach);
  s.map.max_mm = values.number(Row::kMaxWidth);
  s.map.min_mm = std::min(values.number(Row::kMinWidth), s.map.max_mm);
  s.map.gamma = values.number(Row::kGamma);
  s.map.absent_pressure = values.number(Row::kMousePressure);
  s.strength = values.number(Row::kStrength);
  return s;
}

}  // namespace felt
