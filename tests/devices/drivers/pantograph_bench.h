#pragma once

#include <memory>
#include <vector>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// Makes a 2DIY with a fake of its board in the same process.
std::unique_ptr<DriverBench> make_pantograph_bench(std::vector<FaultWindow> faults);

}  // namespace felt
