#pragma once

#include <memory>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/drivers.h"
#include "felt/driver/device_profile.h"

namespace felt {

/// A device that was named on the command line, its driver, and what a person has set for it.
struct RealDevice {
  Driver* driver = nullptr;
  DeviceDescriptor found;
  DeviceProfile profile;  ///< of this id: perhaps of another unit, whose serial is known once open
};

/// Finds a device by its id ("haply:049D"), or by its driver's name where that has one device.
/// Error: there is none; says what there is instead, and what to try.
Result<RealDevice> find_real_device(const std::vector<std::unique_ptr<Driver>>& drivers,
                                    const std::string& id);

}  // namespace felt
