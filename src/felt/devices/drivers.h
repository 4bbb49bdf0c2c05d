#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "felt/driver/driver.h"

namespace felt {

/// Returns one driver of each kind in this build, in the order of display. This is cheap, see
/// Driver.
std::vector<std::unique_ptr<Driver>> make_drivers();

/// Returns the driver for a device id ("haply:049D"), or null.
Driver* driver_of(const std::vector<std::unique_ptr<Driver>>& drivers, std::string_view device_id);

}  // namespace felt
