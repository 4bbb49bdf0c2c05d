#pragma once

#include <string>
#include <vector>

#include "tests/devices/drivers/driver_bench.h"
#include "tests/scenarios/scenario.h"

namespace felt {

/// What came of a script on a driver, compared with the plain simulated device.
struct ScenarioVerdict {
  std::string broken{};        ///< empty: all is as it must be
  double difference_mm = 0.0;  ///< the largest, of whatever kind
  int expected = 0;            ///< lines of the .expect file that the plain device meets as it is
  int lines = 0;               ///< that there are
};

/// The script for a hand. What a pen was led to a hand aims at, at half the speed and after 0.7 s
/// above the start, in which forces engage. Sideways it is moved, and made smaller if need be, to
/// lie in the device's workspace. Nothing is changed in a script with a hand that lies there.
struct HandScript {
  std::vector<Event> events;
  double scale = 1.0;
  Vec shift;  ///< sheet = scale * script + shift
};
HandScript hand_script(const Scenario& scenario, const Capabilities& in_the_sheet);

/// Plays it through the driver's real code, twice, which must give the same bytes, and on the plain
/// device: the same strokes within the bench's tolerance, the same steps of undo, every line of the
/// .expect file that the plain device meets, no fault, no vendor's rule broken.
ScenarioVerdict check_scenario(const Scenario& scenario, const BenchMaker& make);

}  // namespace felt
