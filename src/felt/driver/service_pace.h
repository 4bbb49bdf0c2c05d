#pragma once

#include <cstdint>

namespace felt {

/// Measures how quickly the service or controller behind a device answers, and limits the force
/// while it is slow.
///
/// While states are late, the last force holds for at most kHoldNs; then it is set to zero. If a
/// state comes within kHoldNs, the force is not reduced at all. (The force is not reduced gradually
/// meanwhile, because no message with a smaller force could be sent: only a message without force
/// may follow an unanswered one, as in haply/request_window.h.) If states come regularly but too
/// rarely (on average more than kSlowPeriods apart), the force falls to zero within kSlowRampNs,
/// because the stiffness was chosen for one state per tick. Once the force is zero, forces are off
/// (is_off()): they stay zero until states have come in time for kTimelyNs. Each period in which
/// forces are off counts as one fault, however long it lasts.
///
/// Limits that take a force away count all of the time, however late the ticks are. In averages and
/// in times that allow a force, a tick counts as at most kMaxTickNs, because a pause of our own
/// loop says nothing about the service.
///
/// Used on the haptic thread; real-time safe.
class ServicePace {
 public:
  static constexpr std::int64_t kHoldNs = 16'000'000;
  static constexpr std::int64_t kSlowRampNs = 100'000'000;
  static constexpr std::int64_t kTimelyNs = 1'000'000'000;
  static constexpr double kSlowPeriods = 1.7;
  static constexpr double kTimelyPeriods = 1.3;
  /// In averages, and in times that allow a force, a longer tick counts as a tick of this length.
  static constexpr std::int64_t kMaxTickNs = 5'000'000;

  explicit ServicePace(std::int64_t period_ns) noexcept;

  /// Handles one tick of the loop, `ns` after the last one (LoopTime). `has_state` is true if a new
  /// state came.
  void tick(std::int64_t ns, bool has_state) noexcept;

  /// Returns the factor, 0..1, by which the requested force must be multiplied.
  [[nodiscard]] double share() const noexcept { return share_; }
  /// Returns true while forces are off, that is, from the moment when a slow service caused zero
  /// force until it has answered in time for kTimelyNs.
  [[nodiscard]] bool is_off() const noexcept { return is_off_; }
  /// Returns the time since the last state.
  [[nodiscard]] std::int64_t waited_ns() const noexcept { return waited_ns_; }
  /// Returns the same, but of each tick at most kMaxTickNs. For decisions that a pause of our own
  /// loop must not cause.
  [[nodiscard]] std::int64_t counted_ns() const noexcept { return counted_ns_; }
  /// Returns the average time between states, ms.
  [[nodiscard]] double interval_ms() const noexcept { return 1e-6 * interval_ns_; }

 private:
  void follow_interval(bool has_state) noexcept;

  double period_ns_;
  double tick_ns_;      // average
  double interval_ns_;  // average
  double share_ = 1.0;
  bool is_off_ = false;
  bool is_slow_ = false;
  std::int64_t waited_ns_ = 0;   // since the last state
  std::int64_t counted_ns_ = 0;  // the same, but of each tick at most kMaxTickNs
  std::int64_t timely_ns_ = 0;
};

}  // namespace felt
