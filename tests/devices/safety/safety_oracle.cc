#include "tests/devices/safety/safety_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace felt::safety {
namespace {

// The limits of the chain. They repeat its constants on purpose, because the oracle must not share
// code with the chain.
constexpr double kRiseNPerS = 300.0;
constexpr double kEngageNPerS = 10.0;
constexpr double kFallNPerS = 60.0;
constexpr double kCalmN = 0.2;
constexpr int kCalmTicks = 4;
constexpr double kRampS = 0.5;
constexpr double kLateS = 0.005;
constexpr double kVeryLateS = 0.020;
constexpr double kReachMmPerS = 3000.0;
constexpr double kHoldS = 0.002;
constexpr double kEps = 1e-9;

long double length3(double x, double y, double z) {
  const auto a = static_cast<long double>(x);
  const auto b = static_cast<long double>(y);
  const auto c = static_cast<long double>(z);
  return std::sqrt(a * a + b * b + c * c);
}
double length(const Force& f) {
  return static_cast<double>(length3(f.x, f.y, f.z));
}
double length(const Vec3& v) {
  return static_cast<double>(length3(v.x, v.y, v.z));
}
/// Returns the part of a force in a direction.
double along(const Force& f, const Vec3& direction) {
  return (f.x * direction.x + f.y * direction.y + f.z * direction.z) / length(direction);
}
bool all_finite(const PenSample& s) {
  const std::array numbers = {s.position.x,
                              s.position.y,
                              s.position.z,
                              s.velocity.x,
                              s.velocity.y,
                              s.velocity.z,
                              s.pressure ? *s.pressure : 0.0};
  return std::ranges::all_of(numbers, [](double v) { return v - v == 0.0; });
}
bool all_finite(const Force& f) {
  return f.x - f.x == 0.0 && f.y - f.y == 0.0 && f.z - f.z == 0.0;
}
bool is_none(const Force& f) {
  return f.x == 0.0 && f.y == 0.0 && f.z == 0.0;
}

/// Returns the distance of `next` from the line between zero force and `last`, in N.
double added(const Force& last, const Force& next) {
  const double ll = last.x * last.x + last.y * last.y + last.z * last.z;
  double t = 0.0;
  if (ll > 0.0) t = (last.x * next.x + last.y * next.y + last.z * next.z) / ll;
  t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
  return length(Force{next.x - t * last.x, next.y - t * last.y, next.z - t * last.z});
}

}  // namespace

SafetyOracle::SafetyOracle(const SafetyLimits& limits, bool regular)
    : limits_(limits), regular_(regular) {}

const char* SafetyOracle::check(const TickInput& in, const TickOutput& out) {
  take_orders(in, out.before.state);
  take_time(in.now_ns);
  const char* broken = check_numbers(out);
  if (!broken) broken = check_budget(in, out);
  if (!broken) broken = check_jump(in, out);
  if (!broken) broken = check_hard(in, out);
  if (!broken) {
    watch_soft(in, out);
    broken = check_rise(out);
  }
  if (!broken) broken = check_falling(out);
  if (!broken) {
    watch_engaging(in, out);
    broken = check_silence(out);
  }
  if (!broken) broken = check_brake(in, out);
  if (!broken) broken = check_push(in, out);
  if (!broken) broken = check_heat(out);
  // After a failed read or write, the device holds no force.
  last_ = in.write_fails || in.read_fails ? Force{} : out.sent;
  if (in.write_fails && armed_) hard_ = true;
  return broken;
}

void SafetyOracle::take_orders(const TickInput& in, SafetyState before) {
  if (in.disarm) {
    armed_ = false;
    last_ = {};
  }
  // The chain may have latched because of a fault that the oracle cannot be certain of. In that
  // case, too, arm() starts a new engagement.
  const bool was_off = !armed_ || hard_ || in.disarm || before == SafetyState::kOff ||
                       before == SafetyState::kLatched;
  if (in.arm) {
    armed_ = true;
    silence_s_ = 0.0;
    quiet_s_ = 0.0;
    if (was_off) {
      hard_ = false;
      has_place_ = held_ = falling_ = false;
      phase_ = Phase::kCalm;
      calm_ = full_run_ = fast_ticks_ = 0;
    }
    soft_at_s_.clear();
  }
  if (in.heartbeat_ns && (!has_beat_ || *in.heartbeat_ns != beat_ns_)) {
    // As long double, because the times may be any.
    const bool is_fresh =
        static_cast<long double>(*in.heartbeat_ns) > static_cast<long double>(in.now_ns) - 4e8L;
    if (silence_s_ > 0.55 && phase_ == Phase::kFree && is_fresh) {
      phase_ = Phase::kRamp;
      ramp_s_ = 0.0;
      ramp_from_n_ = length(last_);
    }
    has_beat_ = true;
    beat_ns_ = *in.heartbeat_ns;
    is_audible_ = true;
    quiet_s_ = 0.0;
  }
}

void SafetyOracle::take_time(std::int64_t now_ns) {
  dt_s_ = has_time_
              ? static_cast<double>(
                    (static_cast<long double>(now_ns) - static_cast<long double>(last_ns_)) * 1e-9L)
              : static_cast<double>(limits_.period_ns) * 1e-9;
  has_time_ = true;
  last_ns_ = now_ns;
  clock_s_ += std::max(dt_s_, 0.0);
  silence_s_ = is_audible_ ? 0.0 : silence_s_ + std::max(dt_s_, 0.0);
  is_audible_ = false;
  if (std::abs(dt_s_) > kVeryLateS) has_place_ = held_ = false;
}

const char* SafetyOracle::check_numbers(const TickOutput& out) const {
  if (!all_finite(out.sent)) return "the force is finite";
  if (length(out.sent) > limits_.peak_force_n * (1.0 + 1e-12)) return "the force is under the peak";
  if (out.model_dt_s < 0.0002 || out.model_dt_s > 0.005) return "dt is 0.2 to 5 ms";
  const SafetyState s = out.after.state;
  const bool says_none = s == SafetyState::kOff || s == SafetyState::kLatched;
  if (says_none && !is_none(out.sent)) return "no force when off or latched";
  if (!armed_ && !is_none(out.sent)) return "no force before arm() or after disarm()";
  return nullptr;
}

const char* SafetyOracle::check_budget(const TickInput& in, const TickOutput& out) const {
  if (in.read_fails) return nullptr;  // the model was not evaluated
  const StiffnessScale& s = out.scale;
  for (double share : {s.normal, s.friction, s.lateral}) {
    if (!(share >= 0.0 && share <= 1.0)) return "shares are 0 to 1";
  }
  const double delay_ms = (limits_.delay_ticks + 1) * static_cast<double>(limits_.period_ns) * 1e-6;
  const double budget = delay_ms <= 2.0 ? 900.0 : 1800.0 / delay_ms;
  const double surface =
      s.friction * in.slopes.friction_n_per_m + s.lateral * in.slopes.lateral_n_per_m;
  if (surface > budget * (1.0 + kEps)) return "slopes along the surface keep to the budget";
  const double plane = s.normal * in.slopes.normal_n_per_m;
  if (plane > budget * (1.0 + kEps)) return "the plane keeps to the budget";
  const double cap = limits_.max_stiffness_n_per_m;
  if (cap > 0.0 && plane > cap * (1.0 + kEps)) return "the plane keeps to the device's stiffness";
  if (s.lateral < 1.0 && s.friction * in.slopes.friction_n_per_m > kEps * budget) {
    return "friction gives way first";
  }
  return nullptr;
}

/// Checks how the chain handles positions that jumped. The oracle detects a jump from the positions
/// and times alone: the distance from the last accepted position is more than kReachMmPerS allows
/// for the time since the last new sample.
const char* SafetyOracle::check_jump(const TickInput& in, const TickOutput& out) {
  const SafetyState s = out.before.state;
  const bool chain_is_off = s == SafetyState::kOff || s == SafetyState::kLatched;
  if (in.read_fails || !armed_ || hard_ || (chain_is_off && !in.arm)) return nullptr;
  if (!all_finite(in.sample)) {
    hard_ = true;
    return out.admitted ? "numbers that are none are not believed" : nullptr;
  }
  const Vec3& p = in.sample.position;
  const double tick_s = std::clamp(dt_s_, 0.0002, 0.005);
  const bool says_nothing_new = has_place_ && !held_ && in.sample.time_ns == reported_ns_ &&
                                in.sample.velocity == reported_velocity_ && p == place_;
  reported_ns_ = in.sample.time_ns;
  reported_velocity_ = in.sample.velocity;
  if (says_nothing_new) {
    silent_s_ += tick_s;
    return nullptr;
  }
  const double reach = kReachMmPerS * std::min(silent_s_ + tick_s, 0.025);
  silent_s_ = 0.0;
  const double way =
      has_place_ ? length(Vec3{p.x - place_.x, p.y - place_.y, p.z - place_.z}) : 0.0;
  if (way <= reach) {
    held_ = false;
    has_place_ = true;
    place_ = p;
    return nullptr;
  }
  held_s_ = held_ ? held_s_ + std::max(dt_s_, 0.0002) : 0.0;
  held_ = true;
  // A chain that latched in this tick for another reason need not reject the position.
  if (out.after.state == SafetyState::kLatched) return nullptr;
  if (out.admitted) return "a position that jumped is not believed";
  if (added(last_, out.sent) > kEps) return "while in doubt no force is added";
  if (held_s_ + 1e-9 >= kHoldS) hard_ = true;
  return nullptr;
}

const char* SafetyOracle::check_hard(const TickInput& in, const TickOutput& out) {
  if (in.read_fails && armed_) hard_ = true;
  if (armed_ && out.admitted && !all_finite(out.asked)) {
    const SafetyState s = out.before.state;
    const bool was_off = s == SafetyState::kOff || s == SafetyState::kLatched;
    if (!was_off || in.arm) hard_ = true;
  }
  if (hard_ && !is_none(out.sent)) return "none in the tick of a hard fault and ever after";
  return nullptr;
}

/// Returns true if the pen is above the speed limits: 2 m/s, or 1 m/s for four ticks. The speed is
/// the reported one or the one from positions a full tick apart, whichever is larger.
bool SafetyOracle::is_too_fast(const TickInput& in, const TickOutput& out) {
  const double period_s = static_cast<double>(limits_.period_ns) * 1e-9;
  const bool is_full = out.admitted && !held_ && dt_s_ >= 0.95 * period_s && dt_s_ <= kLateS;
  full_run_ = is_full ? full_run_ + 1 : 0;
  const Vec3& p = in.sample.position;
  const Vec3& q = before_;
  const double per_s = 1e-3 / std::max(dt_s_, 0.0002);
  moved_m_per_s_ = {per_s * (p.x - q.x), per_s * (p.y - q.y), per_s * (p.z - q.z)};
  double speed = full_run_ >= 3 ? length(moved_m_per_s_) : 0.0;
  before_ = p;
  if (!out.admitted || held_) {
    fast_ticks_ = 0;
    return false;
  }
  speed = std::max(speed, length(in.sample.velocity) * 1e-3);
  fast_ticks_ = is_full && speed > 1.0 + 1e-6 ? fast_ticks_ + 1 : 0;
  return speed > 2.0 + 1e-6 || fast_ticks_ >= 4;
}

/// Counts the soft faults that the oracle is certain of. Three within 10 s are a hard fault.
void SafetyOracle::watch_soft(const TickInput& in, const TickOutput& out) {
  const bool too_fast = is_too_fast(in, out);
  const bool very_late = std::abs(dt_s_) > kVeryLateS;
  const bool late = std::abs(dt_s_) > kLateS;
  if (!too_fast && !late) return;
  const bool is_news = !is_none(last_) && out.before.state != SafetyState::kFalling;
  if (is_news && armed_ && !hard_) {
    soft_at_s_.push_back(clock_s_);
    while (clock_s_ - soft_at_s_.front() > 10.0) soft_at_s_.pop_front();
    if (soft_at_s_.size() >= 3) hard_ = true;
  }
  if (very_late) last_ = {};  // the whole next force counts as added
  falling_ = true;
}

const char* SafetyOracle::check_rise(const TickOutput& out) {
  if (hard_ && !is_none(out.sent)) return "three soft faults latch";
  const double credit_s = std::clamp(dt_s_, 0.0, 0.005);
  const double more = added(last_, out.sent);
  if (more > kRiseNPerS * credit_s + kEps) return "the force rises by 0.3 N/ms at most";
  if (phase_ == Phase::kCalm && !falling_ && !is_none(out.sent)) {
    return "no force before it was calm for four ticks";
  }
  // The chain may know of a fault that the oracle cannot be certain of. In that case the force must
  // not grow.
  const SafetyState state = out.after.state;
  if (state == SafetyState::kFalling && length(out.sent) > length(last_) + kEps) {
    return "a falling force does not grow";
  }
  const bool ramps = !falling_ && state != SafetyState::kFalling && state != SafetyState::kSilent;
  if (phase_ == Phase::kRamp && ramps) {
    if (more > kEngageNPerS * credit_s + kEps) return "while engaging it rises by 0.01 N/ms";
    const double largest = limits_.peak_force_n * (ramp_s_ + credit_s) / kRampS + ramp_from_n_;
    if (length(out.sent) > largest + kEps) return "the ramp takes half a second";
  }
  return nullptr;
}

const char* SafetyOracle::check_falling(const TickOutput& out) {
  if (!falling_) return nullptr;
  const double largest = std::max(0.0, length(last_) - kFallNPerS * std::max(dt_s_, 0.0002)) + kEps;
  if (length(out.sent) > largest) return "after a soft fault the force falls by 0.06 N/ms";
  if (is_none(out.sent)) {
    falling_ = false;
    phase_ = Phase::kCalm;
    calm_ = 0;
  }
  return nullptr;
}

void SafetyOracle::watch_engaging(const TickInput&, const TickOutput& out) {
  switch (phase_) {
    case Phase::kCalm: {
      const bool on_time = std::abs(dt_s_) <= kLateS;
      const bool calm = armed_ && out.admitted && on_time && length(out.asked) < kCalmN;
      calm_ = calm ? calm_ + 1 : 0;
      if (calm_ < kCalmTicks) break;
      phase_ = Phase::kRamp;
      ramp_s_ = 0.0;
      ramp_from_n_ = 0.0;
      break;
    }
    case Phase::kRamp:
      ramp_s_ += std::clamp(dt_s_, 0.0, 0.005);
      if (ramp_s_ >= kRampS) phase_ = Phase::kFree;
      break;
    case Phase::kFree:
      break;
  }
}

const char* SafetyOracle::check_silence(const TickOutput& out) {
  if (silence_s_ > 2.07) {
    if (!is_none(out.sent)) return "none when the edit side is silent for 2 s";
    phase_ = Phase::kCalm;
    calm_ = 0;
  }
  if (silence_s_ <= 0.5) {
    quiet_s_ = quiet_fastest_ = 0.0;
    return nullptr;
  }
  const double period_s = static_cast<double>(limits_.period_ns) * 1e-9;
  if (!out.admitted || std::abs(dt_s_) > 2.0 * period_s) {
    quiet_s_ = quiet_fastest_ = 0.0;
    return nullptr;
  }
  quiet_s_ += std::max(dt_s_, 0.0);
  quiet_fastest_ = std::max(quiet_fastest_, length(moved_m_per_s_));
  const bool brakes = (out.after.limited_by & kLimitedBySpeed) != 0;
  if (brakes) quiet_s_ = 0.0;
  if (quiet_s_ > 0.06 && length(out.sent) > 2.0 * quiet_fastest_ + 1e-6) {
    return "damping only when the edit side is silent for 500 ms";
  }
  return nullptr;
}

/// Checks that the chain brakes a pen that moves fast and steadily without another force.
const char* SafetyOracle::check_brake(const TickInput& in, const TickOutput& out) {
  const Vec3& v = in.sample.velocity;
  const double speed = length(v) * 1e-3;
  const bool steady = out.admitted && out.after.state == SafetyState::kActive && speed > 0.7 &&
                      speed < 0.99 && is_none(out.asked) && limits_.continuous_force_n == 0.0 &&
                      limits_.peak_force_n > 0.5 && limits_.max_damping_n_s_per_m == 0.0;
  // If the positions contradict the reported velocity, the pen may be braked less.
  const Vec3& m = moved_m_per_s_;
  const bool agrees = length(m) <= 1.001 * speed && dot(m, v) > 0.0;
  braked_ticks_ = steady && agrees ? braked_ticks_ + 1 : 0;
  if (braked_ticks_ < 60) return nullptr;
  return along(out.sent, v) > -0.2 ? "from 0.6 m/s the pen is braked" : nullptr;
}

/// Checks that nothing pushes a pen on that moves steadily, without another force, while its device
/// reports the opposite velocity.
const char* SafetyOracle::check_push(const TickInput& in, const TickOutput& out) {
  const Vec3& m = moved_m_per_s_;
  const bool steady = out.admitted && out.after.state == SafetyState::kActive &&
                      is_none(out.asked) && dot(m, in.sample.velocity) < 0.0 &&
                      dot(m, moved_before_) >= 0.0;
  moved_before_ = m;
  opposite_s_ = steady ? opposite_s_ + std::max(dt_s_, 0.0) : 0.0;
  return opposite_s_ > 0.1 && along(out.sent, m) > 0.02 ? "a brake never pushes" : nullptr;
}

const char* SafetyOracle::check_heat(const TickOutput&) {
  if (!regular_ || limits_.continuous_force_n <= 0.0) return nullptr;
  // The device held the last force for `dt_s_`.
  heat_.push_back({clock_s_, dt_s_ * (last_.x * last_.x + last_.y * last_.y + last_.z * last_.z)});
  heat_sum_ += heat_.back().joule_like;
  while (clock_s_ - heat_[heat_from_].at_s >= 10.0) heat_sum_ -= heat_[heat_from_++].joule_like;
  const double largest = limits_.continuous_force_n * limits_.continuous_force_n * 10.0;
  return heat_sum_ > largest * 1.001 + kEps ? "RMS over 10 s is under 80 % of the rating" : nullptr;
}

}  // namespace felt::safety
