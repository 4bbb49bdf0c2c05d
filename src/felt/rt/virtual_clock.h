#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "felt/rt/servo.h"

namespace felt {

/// Steps a servo in virtual time: as fast as the processor can, and the same on each run. For
/// replay, tests and the demonstration; nothing here knows the real time.
///
/// With a lateness sequence tick k, due at k periods, happens lateness_ns[k mod n] later, and
/// periods that went by meanwhile are left out, as RealtimeThread does: recorded scheduler jitter
/// can be replayed (performance 4.1, target 4).
///
///   VirtualClock clock(servo);
///   for (...) { feed the device; const TickReport& report = clock.tick(); drain the rings; }
class VirtualClock {
 public:
  /// `lateness_ns` must outlive the clock; entries are never negative (those count as 0).
  explicit VirtualClock(Servo& servo, std::span<const std::int64_t> lateness_ns = {}) noexcept
      : servo_(servo), lateness_ns_(lateness_ns) {}

  /// When the next tick will happen: the time to which a simulated device will advance.
  [[nodiscard]] std::int64_t next_ns() const noexcept { return due_ns_ + next_lateness(); }
  /// When the last tick happened; -1 before the first.
  [[nodiscard]] std::int64_t now_ns() const noexcept { return now_ns_; }
  /// Whether tick() says "alive" for the edit side, which runs on this very thread (true). Tests of
  /// a silent edit side switch it off.
  void set_heartbeat(bool on) noexcept { heartbeat_ = on; }

  /// The next tick.
  const TickReport& tick() noexcept {
    now_ns_ = next_ns();
    if (heartbeat_) servo_.heartbeat(now_ns_);
    const std::int64_t period_ns = servo_.options().period_ns;
    due_ns_ += period_ns * (1 + (now_ns_ - due_ns_) / period_ns);
    if (!lateness_ns_.empty()) at_ = (at_ + 1) % lateness_ns_.size();
    return servo_.step(now_ns_);
  }
  /// All ticks up to and including `until_ns`; `each(report)` after each.
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
