#pragma once

#include <span>
#include <string>
#include <vector>

#include "felt/driver/diagnosis.h"

namespace felt {

/// Where the maker's set-up program keeps what it knows of devices: a file NAME.config each.
inline constexpr std::string_view kHdConfigVariable = "GTDD_HOME";
inline constexpr std::string_view kHdConfigHome = "/usr/share/3DSystems";
inline constexpr std::string_view kHdUdevRules = "/etc/udev/rules.d/70-feltline-3dsystems.rules";

/// Names of the devices that were set up on this machine, sorted.
std::vector<std::string> configured_devices(const SystemView& system);

/// Is a Touch on USB? (The makers' older ones are on FireWire or the printer port.)
bool touch_is_on_usb(const SystemView& system);

/// The library, what it needs, the maker's set-up, the device, the permission to use it. `refusal`:
/// why the driver did not take the library that loads (it lacks functions), or empty.
std::vector<Finding> diagnose_openhaptics(const SystemView& system,
                                          std::span<const std::string> libraries,
                                          const std::string& refusal = {});

}  // namespace felt
