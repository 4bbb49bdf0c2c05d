#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "felt/driver/driver.h"

namespace felt::cli {

/// The devices and findings of a driver.
struct DriverReport {
  std::string name, label;  ///< of the driver
  std::vector<DeviceDescriptor> devices;
  std::vector<Finding> findings;  ///< empty unless requested
};

enum class DriverQuery {
  kDevices,   ///< calls Driver::find
  kFindings,  ///< calls Driver::find and Driver::diagnose
};

/// Time limit for a driver. A driver that follows the rules of the class Driver needs less time.
inline constexpr std::chrono::milliseconds kDriverTime{15'000};

/// Asks every driver for its devices. Each driver runs in its own process, because a vendor's
/// library may crash, hang, end the program or overwrite our output. If a driver's process fails in
/// one of these ways, the driver's report contains a finding that describes the failure and quotes
/// the last text that the process wrote to stderr. Requires that no other thread runs.
std::vector<DriverReport> query_drivers(const std::vector<std::unique_ptr<Driver>>& drivers,
                                        const SystemView& system, DriverQuery what,
                                        std::chrono::milliseconds time_limit = kDriverTime);

}  // namespace felt::cli
