#pragma once

#include <cstdint>
#include <string>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

struct LimitsVerdict {
  std::string broken{};  ///< empty: all rules were kept
  std::uint64_t calls = 0;
  double largest_n = 0.0;  ///< largest force that the fake received
  std::uint64_t digest = 0;
};

/// Makes a random sequence of calls to a driver, without a safety chain before it, in a world with
/// random faults: reads and writes in any order, any force (huge, NaN, infinite, denormal, steps, a
/// long constant force), stops, homing, closing and opening, clocks that stand still, jump or run
/// backwards. In every case, the fake never receives a force above the limit of the model's row or
/// one that is not a number; no rule of the vendor is broken; values that are read are finite;
/// kDisconnected is permanent; after stop() the motors hold no force.
LimitsVerdict fuzz_limits(const BenchMaker& make, std::uint64_t seed);

}  // namespace felt
