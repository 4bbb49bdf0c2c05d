#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "felt/driver/driver.h"

namespace felt {

/// Makes one driver of each kind in this build, in the order of display. This is cheap, because a
/// driver loads libraries and opens ports only when it needs them.
std::vector<std::unique_ptr<Driver>> make_drivers();

/// Returns the driver that a device id names ("haply:049D"), or null if there is no such driver.
Driver* driver_of(const std::vector<std::unique_ptr<Driver>>& drivers, std::string_view device_id);

}  // namespace felt
