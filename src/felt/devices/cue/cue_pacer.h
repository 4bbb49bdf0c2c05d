#pragma once

#include <algorithm>
#include <cstdint>

namespace felt {

/// Limits the rate of cues to what a device can play: at most `at_once` cues in a burst, and
/// `per_second` cues a second on average.
///
/// The Slim Pen 2's firmware is known to stop the pen from writing when its motor is used heavily
/// (linux-surface issue 1066). More cues would be useless anyway, because the hand could not
/// distinguish them.
class CuePacer {
 public:
  explicit constexpr CuePacer(double at_once = 5.0, double per_second = 15.0) noexcept
      : max_(at_once), per_ns_(per_second * 1e-9), left_(at_once) {}

  /// Returns true if a cue may be played now. A clock that goes back counts as a clock that stands
  /// still.
  constexpr bool take(std::int64_t now_ns) noexcept {
    const double passed_ns =
        has_last_ ? static_cast<double>(now_ns) - static_cast<double>(last_ns_) : 0.0;
    has_last_ = true;
    last_ns_ = now_ns;
    left_ = std::min(max_, left_ + std::max(passed_ns, 0.0) * per_ns_);
    if (left_ < 1.0) return false;
    left_ -= 1.0;
    return true;
  }

 private:
  double max_, per_ns_, left_;
  std::int64_t last_ns_ = 0;
  bool has_last_ = false;
};

}  // namespace felt
