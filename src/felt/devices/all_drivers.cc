// This is the only file that lists all drivers. A new driver needs an #include and one line in
// make_drivers().
#include "felt/devices/cue/cue_driver.h"
#include "felt/devices/drivers.h"
#include "felt/devices/evdev/evdev_driver.h"
#include "felt/devices/forcedimension/forcedimension.h"
#include "felt/devices/haply/haply_driver.h"
#include "felt/devices/hapticmaster/hapticmaster_driver.h"
#include "felt/devices/openhaptics/openhaptics_driver.h"
#include "felt/devices/pantograph/pantograph_driver.h"

namespace felt {

std::vector<std::unique_ptr<Driver>> make_drivers() {
  std::vector<std::unique_ptr<Driver>> drivers;
  drivers.push_back(make_openhaptics_driver());
  drivers.push_back(make_forcedimension_driver());
  drivers.push_back(make_haply_driver());
  drivers.push_back(make_pantograph_driver());
  drivers.push_back(make_hapticmaster_driver());
  drivers.push_back(make_evdev_driver());
  drivers.push_back(make_cue_driver());
  return drivers;
}

Driver* driver_of(const std::vector<std::unique_ptr<Driver>>& drivers, std::string_view device_id) {
  const std::string_view name = device_id.substr(0, device_id.find(':'));
  for (const auto& driver : drivers) {
    if (driver->name() == name) return driver.get();
  }
  return nullptr;
}

}  // namespace felt
