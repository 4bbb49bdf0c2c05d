#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "felt/driver/driver.h"

namespace felt {

/// One of each driver that this build has, in the order in which people are shown them. Costs
/// nothing: see Driver.
std::vector<std::unique_ptr<Driver>> make_drivers();

/// The driver whose devices' ids begin like this one ("haply:049D"), or null.
Driver* driver_of(const std::vector<std::unique_ptr<Driver>>& drivers, std::string_view device_id);

}  // namespace felt
