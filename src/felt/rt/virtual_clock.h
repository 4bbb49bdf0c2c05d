#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "felt/rt/servo.h"

namespace felt {

/// Steps a servo in virtual time: as fast as the processor can, and identically on each run. The
/// clock never reads the real time. Replay, tests and the demonstration use it.
///
/// If a sequence of n delays (`lateness_ns`) is given, tick k happens lateness_ns[k mod n] after it
/// is due. Periods that pass during the delay are skipped, as in RealtimeThread. This can replay
/// recorded scheduler jitter (docs/design/loop.md#what-is-proven).
///
///   VirtualClock clock(servo);
///   for (...) { feed the device; const TickReport& report = clock.tick(); drain the rings; }
class VirtualClock {
 public:
  /// Makes a clock. `lateness_ns` must outlive it; negative entries count as 0.
  explicit VirtualClock(Servo& servo, std::span<const std::int64_t> lateness_ns = {}) noexcept
      : servo_(servo), lateness_ns_(lateness_ns) {}

  /// Returns the time of the next tick. A simulated device advances to this time.
  [[nodiscard]] std::int64_t next_ns() const noexcept { return due_ns_ + next_lateness(); }
  /// Returns the time of the last tick; -1 before the first tick.
  [[nodiscard]] std::int64_t now_ns() const noexcept { return now_ns_; }
  /// Sets whether tick() sends the heartbeat of the edit thread (default true). With a virtual
  /// clock, edit thread and haptic thread are the same. Tests of a silent edit thread switch the
  /// heartbeat off.
  void set_heartbeat(bool on) noexcept { heartbeat_ = on; }

  /// Runs the next tick.
  const TickReport& tick() noexcept {
    now_ns_ = next_ns();
    if (heartbeat_) servo_.heartbeat(now_ns_);
    const std::int64_t period_ns = servo_.options().period_ns;
    due_ns_ += period_ns * (1 + (now_ns_ - due_ns_) / period_ns);
    if (!lateness_ns_.empty()) at_ = (at_ + 1) % lateness_ns_.size();
    return servo_.step(now_ns_);
  }
  /// Runs all ticks up to and including `until_ns` and calls `each(report)` after each.
  template <class Each>
  void run(std::int64_t until_ns, Each&& each) {
    while (next_ns() <= until_ns) each(tick());
  }
  void run(std::int64_t until_ns) noexcept {
    while (next_ns() <= until_ns) tick();
  }

 private:
  [[nodiscard]] std::int64_t next_lateness() const noexcept {
    return lateness_ns_.empty() ? 0 : std::max<std::int64_t>(lateness_ns_[at_], 0);
  }

  Servo& servo_;
  std::span<const std::int64_t> lateness_ns_;
  std::size_t at_ = 0;
  std::int64_t due_ns_ = 0;
  std::int64_t now_ns_ = -1;
  bool heartbeat_ = true;
};

}  // namespace felt
