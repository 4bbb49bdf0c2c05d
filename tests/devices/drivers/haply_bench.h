#pragma once

#include <memory>
#include <vector>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// An Inverse3 behind a fake of Haply's Inverse Service, within the process.
std::unique_ptr<DriverBench> make_haply_bench(std::vector<FaultWindow> faults);

}  // namespace felt
