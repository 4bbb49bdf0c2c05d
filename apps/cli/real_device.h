#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/drivers.h"
#include "felt/driver/device_profile.h"

namespace felt::cli {

/// A device that was named on the command line, its driver, and what a person has set for it.
struct RealDevice {
  Driver* driver = nullptr;
  DeviceDescriptor found;
  DeviceProfile profile;
};

/// Finds a device by its id ("haply:049D"), or by its driver's name where that has one device.
/// Error: there is none; says what there is instead, and what to try.
Result<RealDevice> find_real_device(const std::vector<std::unique_ptr<Driver>>& drivers,
                                    const std::string& id);

/// The plane that a person has shown, where the profile is of this very device.
std::optional<PlaneCalibration> shown_plane(const RealDevice& device);

}  // namespace felt::cli
