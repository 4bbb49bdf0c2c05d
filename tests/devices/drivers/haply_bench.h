#pragma once

#include <memory>
#include <vector>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// Makes an Inverse3 with a fake of Haply's Inverse Service in the same process.
std::unique_ptr<DriverBench> make_haply_bench(std::vector<FaultWindow> faults);

}  // namespace felt
