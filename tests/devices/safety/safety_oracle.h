#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "tests/devices/safety/tick_record.h"

namespace felt::safety {

/// Checks whether the forces that reached the device were allowed (docs/design/limits.md). The
/// oracle shares no code with the chain and knows only the inputs and outputs of each tick. It
/// checks only rules that certainly apply. Therefore a rule that it reports as broken is really
/// broken. It uses the chain's report only to decide which rules apply to a tick.
class SafetyOracle {
 public:
  /// `regular`: true if the clock of this episode never stalls or jumps. The heat rule is checked
  /// only then.
  SafetyOracle(const SafetyLimits& limits, bool regular);

  /// Checks one tick. Returns the rule that it broke, or null.
  const char* check(const TickInput& in, const TickOutput& out);

 private:
  enum class Phase : std::uint8_t { kCalm, kRamp, kFree };

  void take_orders(const TickInput& in, SafetyState before);
  void take_time(std::int64_t now_ns);
  const char* check_numbers(const TickOutput& out) const;
  const char* check_budget(const TickInput& in, const TickOutput& out) const;
  const char* check_hard(const TickInput& in, const TickOutput& out);
  const char* check_jump(const TickInput& in, const TickOutput& out);
  void watch_soft(const TickInput& in, const TickOutput& out);
  bool is_too_fast(const TickInput& in, const TickOutput& out);
  const char* check_rise(const TickOutput& out);
  const char* check_falling(const TickOutput& out);
  void watch_engaging(const TickInput& in, const TickOutput& out);
  const char* check_silence(const TickOutput& out);
  const char* check_brake(const TickInput& in, const TickOutput& out);
  const char* check_push(const TickInput& in, const TickOutput& out);
  const char* check_heat(const TickOutput& out);

  SafetyLimits limits_;
  bool regular_;

  bool armed_ = false;
  bool hard_ = false;  // a hard fault happened since the last arm()
  bool has_time_ = false;
  std::int64_t last_ns_ = 0;
  double dt_s_ = 0.0;  // since the tick before; negative if the clock ran backwards
  double clock_s_ = 0.0;
  Force last_;

  bool has_place_ = false;
  Vec3 place_;
  std::int64_t reported_ns_ = 0;  // time stamp of the last sample
  Vec3 reported_velocity_;        // velocity of the last sample
  double silent_s_ = 0.0;         // time since the last new sample
  bool held_ = false;
  double held_s_ = 0.0;
  Vec3 before_;         // position of the tick before
  Vec3 moved_m_per_s_;  // since the tick before, from the positions
  int full_run_ = 0;
  int fast_ticks_ = 0;

  Phase phase_ = Phase::kCalm;
  int calm_ = 0;
  double ramp_s_ = 0.0;
  double ramp_from_n_ = 0.0;
  bool falling_ = false;
  std::deque<double> soft_at_s_;

  bool has_beat_ = false;
  bool is_audible_ = false;  // a heartbeat came at this tick
  std::int64_t beat_ns_ = 0;
  double silence_s_ = 0.0;
  double quiet_fastest_ = 0.0;  // largest speed since the silence became certain, m/s
  double quiet_s_ = 0.0;        // time since the silence became certain
  int braked_ticks_ = 0;
  double opposite_s_ = 0.0;  // for how long the device has reported the opposite velocity
  Vec3 moved_before_;        // moved_m_per_s_ of the tick before

  struct Heat {
    double at_s, joule_like;
  };
  std::vector<Heat> heat_;
  std::size_t heat_from_ = 0;
  double heat_sum_ = 0.0;
};

}  // namespace felt::safety
