#pragma once

#include <cstdint>
#include <string>

namespace felt::bench {

/// Feeds one stroke of `samples` generated samples to our fitter and prints what single calls
/// cost, and whether the result is right. `only` is a part of the fitter's name.
void print_long_report(std::int64_t samples, double tolerance, int repeats, unsigned seed,
                       const std::string& only);

}  // namespace felt::bench
