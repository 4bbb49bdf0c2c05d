#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// How a driver can be bad; each must be caught by the suite that is named.
enum class BadDriver {
  kNone,            ///< the reference: passes all suites
  kClampsNothing,   ///< limits: hands any force on
  kHandsOnNan,      ///< limits: a force that is no number reaches the other side
  kWrongForceSign,  ///< contract: pushes into the plane
  kMirrored,        ///< contract: x of places and forces mirrored; scenarios: the ink, too
  kHangsOn,         ///< faults: after an error the last force holds, stop() does not help
  kForgetsSamples,  ///< scenarios: now and then an old sample in the place of the new one
  kWrongUnits,      ///< scenarios: a hundredth short of a millimetre a millimetre
  kSaysNan,         ///< contract: a place that is no number
  kDiesOnce,        ///< faults: says once that it is gone, and then lives on
  kDiesOfHeat,      ///< faults: warm motors end the reading, too
  kKicks,           ///< faults: opened anew it pushes without being asked
  kBreaksRule,      ///< all: a call that the vendor forbids
  kAllocates,       ///< rt: memory in the tick
  kRemembers,       ///< scenarios: not the same bytes again
};

struct BadDriverName {
  BadDriver bad;
  std::string_view name;  ///< "clamps-nothing"
};
std::span<const BadDriverName> bad_drivers() noexcept;

/// The reference bench: a DriverDevice directly over the world, with a frame of its own (turned by
/// a quarter before a table that leans by 25 degrees, right-handed). The suites run on it before
/// there is any driver.
std::unique_ptr<DriverBench> make_scripted_bench(std::vector<FaultWindow> faults);
/// Its driver made bad, to see it caught.
std::unique_ptr<DriverBench> make_bad_bench(BadDriver bad, std::vector<FaultWindow> faults);

}  // namespace felt
