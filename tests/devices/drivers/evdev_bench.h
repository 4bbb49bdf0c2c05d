#pragma once

#include <memory>
#include <vector>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// Makes a joystick with force feedback (evdev/fake_stick.h) for the driver "evdev".
std::unique_ptr<DriverBench> make_evdev_bench(std::vector<FaultWindow> faults);

}  // namespace felt
