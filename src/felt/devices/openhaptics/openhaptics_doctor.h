#pragma once

#include <span>
#include <string>
#include <vector>

#include "felt/driver/diagnosis.h"

namespace felt {

/// The maker's set-up program stores one file, NAME.config, for each device. The environment
/// variable kHdConfigVariable names the folder of these files; if it is not set, the folder is
/// kHdConfigHome.
inline constexpr std::string_view kHdConfigVariable = "GTDD_HOME";
inline constexpr std::string_view kHdConfigHome = "/usr/share/3DSystems";
inline constexpr std::string_view kHdUdevRules = "/etc/udev/rules.d/70-feltline-3dsystems.rules";

/// Returns the names of the devices that were set up on this machine, sorted.
std::vector<std::string> configured_devices(const SystemView& system);

/// Returns true if a Touch is connected by USB. (Older models use FireWire or the printer port.)
bool touch_is_on_usb(const SystemView& system);

/// Checks the library, its dependencies, the maker's set-up, the device, and the permission to use
/// it. `refusal` says why the driver rejected a library that can be loaded (functions are missing).
/// It is empty if the driver rejected none.
std::vector<Finding> diagnose_openhaptics(const SystemView& system,
                                          std::span<const std::string> libraries,
                                          const std::string& refusal = {});

}  // namespace felt
