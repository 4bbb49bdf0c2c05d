#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "tests/devices/safety/tick_record.h"

namespace felt::safety {

/// Says whether what reached the device was allowed (docs/design/limits.md), from the inputs
/// alone. It shares no code with the chain and knows less than the chain does: it demands only what
/// is certain, so what it calls broken is broken. The chain's own word (its report) counts only
/// where it claims to send nothing.
class SafetyOracle {
 public:
  /// `regular`: the clock of this episode never stalls or jumps; the heat rule needs that.
  SafetyOracle(const SafetyLimits& limits, bool regular);

  /// Returns null, or the rule that this tick broke.
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
  const char* check_silence(const TickInput& in, const TickOutput& out);
  const char* check_brake(const TickInput& in, const TickOutput& out);
  const char* check_heat(const TickOutput& out);

  SafetyLimits limits_;
  bool regular_;

  bool armed_ = false;
  bool hard_ = false;  // since the last arm()
  bool has_time_ = false;
  std::int64_t last_ns_ = 0;
  double dt_s_ = 0.0;  // signed
  double clock_s_ = 0.0;
  Force last_;

  bool has_place_ = false;
  Vec3 place_;
  std::int64_t told_ns_ = 0;  // the last sample's own time
  Vec3 told_velocity_;        // and velocity
  double unheard_s_ = 0.0;    // since the last new sample
  bool held_ = false;
  double held_s_ = 0.0;
  Vec3 before_;  // position of the tick before
  int full_run_ = 0;
  int fast_ticks_ = 0;

  Phase phase_ = Phase::kCalm;
  int calm_ = 0;
  double ramp_s_ = 0.0;
  double ramp_from_n_ = 0.0;
  bool falling_ = false;
  std::deque<double> soft_at_s_;

  bool has_beat_ = false;
  bool is_heard_ = false;  // at this tick
  std::int64_t beat_ns_ = 0;
  double silence_s_ = 0.0;
  double quiet_fastest_ = 0.0;  // largest speed since the silence became certain
  double quiet_s_ = 0.0;        // credited time since then
  int braked_ticks_ = 0;

  struct Heat {
    double at_s, joule_like;
  };
  std::vector<Heat> heat_;
  std::size_t heat_from_ = 0;
  double heat_sum_ = 0.0;
};

}  // namespace felt::safety
