#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "felt/driver/driver.h"

namespace felt::cli {

/// The devices and findings of a driver.
struct DriverLook {
  std::string name, label;  ///< the driver's
  std::vector<DeviceDescriptor> devices;
  std::vector<Finding> findings;  ///< if requested
};

enum class LookFor {
  kDevices,   ///< Driver::find
  kFindings,  ///< Driver::diagnose as well
};

/// Longer than any driver needs that complies with the rules in Driver.
inline constexpr std::chrono::milliseconds kLookTime{15'000};

/// Asks every driver, each in its own process, because a vendor's library may crash, hang, end the
/// program or overwrite our output, and none of that may affect us. If a driver fails like that,
/// this is a finding of its own, with the last text that it wrote to stderr. Requires that no other
/// thread runs.
std::vector<DriverLook> look_at_drivers(const std::vector<std::unique_ptr<Driver>>& drivers,
                                        const SystemView& system, LookFor what,
                                        std::chrono::milliseconds most = kLookTime);

}  // namespace felt::cli
