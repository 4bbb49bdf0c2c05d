#pragma once

#include <memory>
#include <string_view>

#include "tests/devices/drivers/driver_bench.h"
#include "tests/devices/rt/scenarios.h"

namespace felt::rt_test {

/// Runs a driver's own read(), write() and stop() in the tick, with its fake
/// (tests/devices/drivers) and a hand that scribbles: without faults, or with one fault after the
/// other that the fake simulates. A device that is gone is reopened and armed.
std::unique_ptr<Session> make_driver_session(std::string_view bench, bool with_faults);
/// The same for any bench.
std::unique_ptr<Session> make_driver_session(const BenchMaker& make, bool with_faults);

}  // namespace felt::rt_test
