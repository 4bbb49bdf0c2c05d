#pragma once

#include <cstdint>

#include "felt/haptics/safety/safety_limits.h"

namespace felt {

/// How late a tick came.
enum class Lateness : std::uint8_t {
  kOnTime,
  kLate,      ///< over late_s since the last one
  kVeryLate,  ///< over very_late_s; what the pen did meanwhile is not known
};

/// The time since the last tick, three ways. A doubt about time is settled against the force: what
/// lets a force grow is credited with little time, what takes it away is charged with much.
struct TickTime {
  double model_s = 0.001;    ///< for the models: clamped to 0.2..5 ms
  double credited_s = 0.0;   ///< rise, ramps: at most two periods or 5 ms, 0 when time stands still
  double charged_s = 0.001;  ///< watchdogs, falls, heat: at least 0.2 ms, without an upper bound
  Lateness lateness = Lateness::kOnTime;
};

/// Measures ticks (reliability 3.3). Time that stands still or runs backwards credits nothing;
/// running backwards is as late as it goes back. Real-time safe.
class TickClock {
 public:
  explicit TickClock(const SafetyLimits& limits) noexcept;

  /// The first tick counts as one period. Any two times, even the farthest apart.
  TickTime tick(std::int64_t now_ns) noexcept;

 private:
  double period_s_;
  double late_s_;
  double very_late_s_;
  std::int64_t last_ns_ = 0;
  bool has_last_ = false;
};

/// The edit side's signs of life (architecture section 10: edit side silent). Silence is counted in
/// ticks of the chain's own clock, so that a clock that stops or jumps cannot hide it; the same
/// heartbeat seen twice is one.
class HeartbeatWatch {
 public:
  /// A heartbeat with the time it was made at.
  void beat(std::int64_t made_ns) noexcept;
  /// Starts a new count, as when the user arms.
  void restart() noexcept;
  /// Counts a tick; returns the silence in s.
  double tick(std::int64_t now_ns, const TickTime& time) noexcept;

 private:
  double silence_s_ = 0.0;
  std::int64_t last_beat_ns_ = 0;
  bool has_beat_ = false;
  bool is_new_ = false;
};

}  // namespace felt
