#pragma once

#include <memory>
#include <vector>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// A 2DIY behind a fake of its board, within the process.
std::unique_ptr<DriverBench> make_pantograph_bench(std::vector<FaultWindow> faults);

}  // namespace felt
