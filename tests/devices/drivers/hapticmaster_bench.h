#pragma once

#include <memory>
#include <vector>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// Makes a HapticMASTER with a fake of its controller in the same process.
std::unique_ptr<DriverBench> make_hapticmaster_bench(std::vector<FaultWindow> faults);

}  // namespace felt
