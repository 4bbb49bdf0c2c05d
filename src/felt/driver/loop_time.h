#pragma once

#include <algorithm>
#include <cstdint>

namespace felt {

/// Measures the time between the ticks of a loop, for limits that must hold in real time. However
/// late a tick is, all of the time counts. A clock that stands still or goes back counts as one
/// period per tick, because a limit must not wait for such a clock. Real-time safe.
class LoopTime {
 public:
  /// A longer time counts as this, so that sums of times cannot overflow. It is far above every
  /// limit.
  static constexpr std::int64_t kMaxNs = 3'600'000'000'000;

  explicit LoopTime(std::int64_t period_ns) noexcept : period_ns_(period_ns) {}

  /// Returns the time since the last tick, ns. Returns 0 for the first tick. Accepts any times.
  std::int64_t tick(std::int64_t now_ns) noexcept {
    const double ns = static_cast<double>(now_ns) - static_cast<double>(last_ns_);
    const bool is_forward = now_ns > last_ns_;
    const bool is_first = !has_ticked_;
    last_ns_ = now_ns;
    has_ticked_ = true;
    if (is_first) return 0;
    if (!is_forward) return period_ns_;
    return static_cast<std::int64_t>(std::min(ns, static_cast<double>(kMaxNs)));
  }
  /// Makes the next tick the first one, because the loop was stopped on purpose.
  void restart() noexcept { has_ticked_ = false; }

 private:
  std::int64_t period_ns_;
  std::int64_t last_ns_ = 0;
  bool has_ticked_ = false;
};

}  // namespace felt
