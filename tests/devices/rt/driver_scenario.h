#pragma once

#include <memory>
#include <string_view>

#include "tests/devices/drivers/driver_bench.h"
#include "tests/devices/rt/scenarios.h"

namespace felt::rt_test {

/// Returns a session that runs the driver's own read(), write() and stop() in the tick. The driver
/// talks to its fake (tests/devices/drivers), and a simulated hand scribbles. If `with_faults`, the
/// fake simulates all its faults, one after the other. A disconnected device is reopened and armed.
std::unique_ptr<Session> make_driver_session(std::string_view bench, bool with_faults);
/// Same as above, for a bench that `make` creates.
std::unique_ptr<Session> make_driver_session(const BenchMaker& make, bool with_faults);

}  // namespace felt::rt_test
