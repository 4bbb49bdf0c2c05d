#pragma once

#include <memory>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/drivers.h"
#include "felt/driver/device_profile.h"

namespace felt {

/// A device that was named on the command line, its driver, and the user's settings for it.
struct RealDevice {
  Driver* driver = nullptr;
  DeviceDescriptor found;
  /// The profile for this id. It may belong to another unit of the same model, because the serial
  /// number of a device is not known before the device is opened.
  DeviceProfile profile;
};

/// Finds a device by its id ("haply:049D"), or by its driver's name if that driver has one device.
/// Fails if no such device is found; the message lists the devices that were found and makes a
/// suggestion.
Result<RealDevice> find_real_device(const std::vector<std::unique_ptr<Driver>>& drivers,
                                    const std::string& id);

}  // namespace felt
