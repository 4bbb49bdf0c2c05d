#pragma once

#include <cstdint>
#include <string>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

struct LimitsVerdict {
  std::string broken{};  ///< empty: all rules were kept
  std::uint64_t calls = 0;
  double largest_n = 0.0;  ///< that the other side was asked for
  std::uint64_t digest = 0;
};

/// A random sequence of calls of a driver, without any safety chain before it, in a world where
/// random things go wrong: reads and writes in and out of turn, any force (huge, NaN, infinite,
/// denormal, steps, a constant one for long), stops, home searches, closing and opening, clocks
/// that stand still, jump or run backwards. Whatever comes: the other side is never asked for more
/// than the model's row allows, nor for what is no number; no rule of the vendor is broken; what
/// reads well is finite; kDisconnected is for ever; after stop() the motors hold nothing.
LimitsVerdict fuzz_limits(const BenchMaker& make, std::uint64_t seed);

}  // namespace felt
