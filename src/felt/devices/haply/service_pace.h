#pragma once

#include <cstdint>

namespace felt::haply {

/// Judges how quickly the service answers, and how much of the force may go while it does not.
///
/// While states are late the last force holds, for kHoldNs at most; then it goes. An answer before
/// that changes nothing. (A ramp would not reach the device: nothing but a message without force
/// may follow one that is unanswered, RequestWindow.) If states come regularly but seldom
/// (kSlowPeriods from one to the next, on average), the force falls within kSlowRampNs: the
/// stiffness was chosen for a state in each tick. Once it is zero the pace is off, and stays so
/// until states have come in time for kTimelyNs: one fault, however long.
///
/// Haptic thread; real-time safe.
class ServicePace {
 public:
  static constexpr std::int64_t kHoldNs = 16'000'000;
  static constexpr std::int64_t kSlowRampNs = 100'000'000;
  static constexpr std::int64_t kTimelyNs = 1'000'000'000;
  static constexpr double kSlowPeriods = 1.7;
  static constexpr double kTimelyPeriods = 1.3;
  /// Longest time that one tick counts for: a loop of ours that stood still says nothing about the
  /// service.
  static constexpr std::int64_t kMaxTickNs = 5'000'000;

  explicit ServicePace(std::int64_t period_ns) noexcept;

  /// One tick of the loop, `ns` after the last one, with a new state or without.
  void tick(std::int64_t ns, bool has_state) noexcept;

  /// 0..1, of the force that is asked for.
  [[nodiscard]] double share() const noexcept { return share_; }
  /// No force, until the service has been prompt again for a while.
  [[nodiscard]] bool is_off() const noexcept { return is_off_; }
  /// Since the last state.
  [[nodiscard]] std::int64_t waited_ns() const noexcept { return waited_ns_; }
  /// Average time from state to state, ms.
  [[nodiscard]] double interval_ms() const noexcept { return 1e-6 * interval_ns_; }

 private:
  void follow_interval(bool has_state) noexcept;

  double period_ns_;
  double tick_ns_;      // average
  double interval_ns_;  // average
  double share_ = 1.0;
  bool is_off_ = false;
  bool is_slow_ = false;
  std::int64_t waited_ns_ = 0;
  std::int64_t timely_ns_ = 0;
};

}  // namespace felt::haply
