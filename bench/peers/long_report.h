#pragma once

#include <cstdint>
#include <string>

namespace felt::bench {

/// Fits one stroke of `samples` generated samples with our fitter. Prints the cost of single calls
/// and whether the result is correct. `only` is a part of the fitter's name.
void print_long_report(std::int64_t samples, double tolerance, int repeats, unsigned seed,
                       const std::string& only);

}  // namespace felt::bench
