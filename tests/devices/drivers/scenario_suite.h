#pragma once

#include <string>
#include <vector>

#include "tests/devices/drivers/driver_bench.h"
#include "tests/scenarios/scenario.h"

namespace felt {

/// The result of a script on a driver, compared with the plain simulated device.
struct ScenarioVerdict {
  std::string broken{};        ///< empty if all rules were kept
  double difference_mm = 0.0;  ///< the largest difference of any kind
  int expected = 0;            ///< lines of the .expect file that the plain device meets unchanged
  int lines = 0;               ///< number of lines in the .expect file
};

/// The script for a hand. The hand aims at the positions of the script's pen, at half the speed and
/// after 0.7 s above the start, during which forces engage. The script is moved sideways, and made
/// smaller if necessary, to lie in the device's workspace. A script that already has a hand and
/// lies there is not changed.
struct HandScript {
  std::vector<Event> events;
  double scale = 1.0;
  Vec shift;  ///< position on the surface = scale * script + shift
};
HandScript hand_script(const Scenario& scenario, const Capabilities& page_capabilities);

/// Plays the script twice through the driver's real code, which must give the same bytes, and once
/// on the plain device. Both must give the same strokes within the bench's tolerance, the same undo
/// steps and every line of the .expect file that the plain device meets, without a fault or a
/// broken rule of the vendor.
ScenarioVerdict check_scenario(const Scenario& scenario, const BenchMaker& make);

}  // namespace felt
