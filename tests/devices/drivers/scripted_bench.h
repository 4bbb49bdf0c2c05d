#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// The ways in which a driver can be bad. The named suite must catch each.
enum class BadDriver {
  kNone,            ///< the reference: passes all suites
  kClampsNothing,   ///< limits: forwards any force
  kHandsOnNan,      ///< limits: forwards a force that is not a number
  kWrongForceSign,  ///< contract: pushes into the plane
  kMirrored,        ///< contract: x of positions and forces mirrored; scenarios: the ink, too
  kHangsOn,         ///< faults: after an error the last force holds, and stop() does not help
  kForgetsSamples,  ///< scenarios: occasionally returns an old sample instead of the new one
  kWrongUnits,      ///< scenarios: lengths are 1 % too short
  kSaysNan,         ///< contract: a position that is not a number
  kDiesOnce,        ///< faults: reports once that it is disconnected, and then continues
  kDiesOfHeat,      ///< faults: warm motors end the reading as well
  kKicks,           ///< faults: pushes without a request after it was reopened
  kBreaksRule,      ///< all: a call that the vendor forbids
  kAllocates,       ///< rt: memory in the tick
  kRemembers,       ///< scenarios: a second run gives different bytes
};

struct BadDriverName {
  BadDriver bad;
  std::string_view name;  ///< "clamps-nothing"
};
std::span<const BadDriverName> bad_drivers() noexcept;

/// Makes the reference bench: a DriverDevice directly over the world, with a frame of its own
/// (rotated by a quarter before a table that is inclined by 25 degrees, right-handed). It lets the
/// suites run without any real driver.
std::unique_ptr<DriverBench> make_scripted_bench(std::vector<FaultWindow> faults);
/// Makes a bench with a bad driver, which the suites must catch.
std::unique_ptr<DriverBench> make_bad_bench(BadDriver bad, std::vector<FaultWindow> faults);

}  // namespace felt
