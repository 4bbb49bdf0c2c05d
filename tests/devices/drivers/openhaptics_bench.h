#pragma once

#include <memory>
#include <vector>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// Makes the OpenHaptics driver with a fake libHD of our own. Its scheduler is before_tick().
std::unique_ptr<DriverBench> make_openhaptics_bench(std::vector<FaultWindow> faults);

}  // namespace felt
