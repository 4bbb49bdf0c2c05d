#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "felt/base/random.h"
#include "felt/geometry/point.h"

namespace felt::gestures {

/// Makes random choices. The same seed gives the same choices on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) noexcept : random_(seed) {}

  double between(double low, double high) noexcept { return random_.between(low, high); }
  /// Returns a number in low..high; 1..10 is as likely as 10..100. Requires 0 < low < high.
  double over_decades(double low, double high) noexcept {
    return low * std::exp(between(0.0, std::log(high / low)));
  }
  bool chance(double p) noexcept { return between(0.0, 1.0) < p; }
  /// Returns an index in 0 .. count - 1. Requires count > 0.
  std::size_t pick(std::size_t count) noexcept {
    return static_cast<std::size_t>(random_.bits() % count);
  }
  int pick(int low, int high) noexcept {
    return low + static_cast<int>(pick(static_cast<std::size_t>(high - low + 1)));
  }
  template <class List>
  const auto& any(const List& list) noexcept {
    return list[pick(list.size())];
  }
  Vec direction() noexcept {
    const double angle = between(0.0, 2.0 * std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
  }
  std::uint64_t seed() noexcept { return random_.bits(); }

 private:
  Random random_;
};

}  // namespace felt::gestures
