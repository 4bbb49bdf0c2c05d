#include "felt/tools/connect/connect_options.h"

namespace felt {

ConnectSettings connect_settings(const OptionValues& values) {
  using Row = ConnectOption::Row;
  ConnectSettings s;
  s.snap.mode = static_cast<SnapMode>(values.choice(Row::kSnap));
  s.snap.reach_mm = values.number(Row::kReach);
  s.snap.radius_mm = values.number(Row::kSnapRadius);
  s.snap.force_n = values.number(Row::kAttraction);
  s.grab_radius_mm = values.number(Row::kGrabRadius);
  s.extend = values.is_on(Row::kExtend);
  s.keep_separate = values.is_on(Row::kKeepSeparate);
  s.strength = values.number(Row::kStrength);
  return s;
}

}  // namespace felt
