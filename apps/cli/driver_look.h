#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "felt/driver/driver.h"

namespace felt::cli {

/// What a driver sees.
struct DriverLook {
  std::string name, label;  ///< the driver's
  std::vector<DeviceDescriptor> devices;
  std::vector<Finding> findings;  ///< where asked for
};

enum class LookFor {
  kDevices,   ///< Driver::find
  kFindings,  ///< Driver::diagnose, too
};

/// Longer than any driver needs that does as Driver says.
inline constexpr std::chrono::milliseconds kLookTime{15'000};

/// Asks every driver, each in a process of its own: a vendor's library may crash, hang, end the
/// program or write over what we print, and none of that reaches us. What it then left to say is a
/// finding of its own, with the last that it wrote to stderr. Requires that no other thread runs.
std::vector<DriverLook> look_at_drivers(const std::vector<std::unique_ptr<Driver>>& drivers,
                                        const SystemView& system, LookFor what,
                                        std::chrono::milliseconds most = kLookTime);

}  // namespace felt::cli
