#pragma once

#include <cmath>
#include <cstdint>

#include "felt/base/constants.h"

namespace felt {

/// A random number generator: SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number
/// generators", OOPSLA 2014). It gives the same numbers on every machine. The standard library is
/// not used, because its distributions differ between implementations.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}

  /// Returns the next 64 bits.
  std::uint64_t bits() noexcept {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  /// Returns a uniform number in [low, high).
  double between(double low, double high) noexcept {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  /// Returns a normally distributed number with mean 0 and standard deviation 1 (Box, Muller, "A
  /// note on the generation of random normal deviates", Ann Math Stat 29, 1958). The machine's libm
  /// may differ in the last digits.
  double normal() noexcept {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - between(0.0, 1.0)));
    return radius * std::cos(between(0.0, kTau));
  }

 private:
  std::uint64_t state_;
};

}  // namespace felt
