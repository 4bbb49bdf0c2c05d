#pragma once

#include <cstdint>

namespace felt::bench {

/// Feeds one stroke of `samples` generated samples to our fitter and prints what single calls
/// cost, and whether the result is right.
void print_long_report(std::int64_t samples, double tolerance, int repeats, unsigned seed);

}  // namespace felt::bench
