#include "felt/haptics/safety/safety_chain.h"

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"
#include "felt/haptics/safety/safety_stages.h"

namespace felt {
SafetyChain::SafetyChain(const SafetyLimits& limits) noexcept
    : limits_(is_sound(limits) ? limits : SafetyLimits{.peak_force_n = 0.0}),
      clock_(limits_),
      jumps_(limits_),
      speed_(limits_),
      motors_(limits_) {
  if (!is_sound(limits)) hard_fault(SafetyFault::kSelfTest);
}

// --- calls of the user and the edit thread ------------------------------------------------------

void SafetyChain::arm() noexcept {
  if (is_armed() || !(limits_.peak_force_n > 0.0)) return;
  report_.fault = SafetyFault::kNone;
  recent_soft_faults_ = 0;
  heartbeats_.restart();
  silence_s_ = 0.0;
  forget_motion();
  go_to(SafetyState::kWaiting);
}

void SafetyChain::disarm() noexcept {
  if (!is_armed()) return;
  go_to(SafetyState::kOff);
}

void SafetyChain::heartbeat(std::int64_t made_ns) noexcept {
  heartbeats_.beat(made_ns);
}

// --- states and faults --------------------------------------------------------------------------

bool SafetyChain::is_armed() const noexcept {
  return report_.state != SafetyState::kOff && report_.state != SafetyState::kLatched;
}

bool SafetyChain::carries_force() const noexcept {
  return is_armed() && report_.state != SafetyState::kWaiting;
}

void SafetyChain::go_to(SafetyState state) noexcept {
  report_.state = state;
  calm_ticks_ = 0;
  ramp_ = 0.0;
  if (!carries_force()) sent_ = {};
}

void SafetyChain::forget_motion() noexcept {
  jumps_.reset();
  speed_.reset();
  passivity_.reset();
}

void SafetyChain::soft_fault(SafetyFault fault, SafetyState next) noexcept {
  ++report_.soft_faults;
  report_.fault = fault;
  // Drops faults that are older than the window.
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < recent_soft_faults_; ++i) {
    if (credited_s_ - soft_fault_at_s_[i] > limits_.soft_fault_window_s) continue;
    soft_fault_at_s_[kept++] = soft_fault_at_s_[i];
  }
  soft_fault_at_s_[kept++] = credited_s_;
  recent_soft_faults_ = kept;
  if (kept >= static_cast<std::uint32_t>(limits_.soft_faults)) {
    hard_fault(SafetyFault::kTooManyFaults);
  } else {
    go_to(next);
  }
}

void SafetyChain::hard_fault(SafetyFault fault) noexcept {
  ++report_.hard_faults;
  report_.fault = fault;
  go_to(SafetyState::kLatched);
}

// --- a tick -------------------------------------------------------------------------------------

double SafetyChain::begin(std::int64_t now_ns) noexcept {
  time_ = clock_.tick(now_ns);
  credited_s_ += time_.credited_s;
  call_ = Call::kBegun;
  report_.limited_by = 0;
  motors_.heat(norm(sent_), time_.charged_s);
  silence_s_ = heartbeats_.tick(now_ns, time_);
  watch_lateness();
  watch_silence();
  return time_.model_s;
}

void SafetyChain::watch_lateness() noexcept {
  if (time_.lateness == Lateness::kOnTime) return;
  calm_ticks_ = 0;
  if (time_.lateness == Lateness::kVeryLate) {
    forget_motion();
    if (carries_force()) soft_fault(SafetyFault::kVeryLateTick, SafetyState::kWaiting);
  } else if (carries_force() && report_.state != SafetyState::kFalling) {
    soft_fault(SafetyFault::kLateTick, SafetyState::kFalling);
  }
}

void SafetyChain::watch_silence() noexcept {
  switch (report_.state) {
    case SafetyState::kEngaging:
    case SafetyState::kActive:
      if (silence_s_ >= limits_.silent_damp_s) go_to(SafetyState::kSilent);
      break;
    case SafetyState::kSilent:
      if (silence_s_ >= limits_.silent_stop_s) {
        soft_fault(SafetyFault::kEditSilent, SafetyState::kFalling);
      } else if (silence_s_ < limits_.silent_damp_s) {
        go_to(SafetyState::kEngaging);
      }
      break;
    default:
      break;
  }
}

void SafetyChain::device_failed() noexcept {
  if (is_armed()) hard_fault(SafetyFault::kDeviceError);
}

bool SafetyChain::admit(const PenSample& sample) noexcept {
  call_ = Call::kHeld;
  if (!is_finite(sample)) {
    if (is_armed()) hard_fault(SafetyFault::kNotFinite);
    return false;
  }
  const bool is_repeated = has_seen_ && repeats(seen_, sample);
  seen_ = sample;
  has_seen_ = true;
  if (!is_armed()) {
    call_ = Call::kBelieved;
    return true;
  }
  if (is_repeated && jumps_.may_wait()) {
    jumps_.wait(time_);
    speed_.wait(time_);
    call_ = Call::kBelieved;
    return true;
  }
  switch (jumps_.judge(sample.position, time_)) {
    case PositionVerdict::kFault:
      hard_fault(SafetyFault::kPositionJump);
      return false;
    case PositionVerdict::kHeld:
      calm_ticks_ = 0;
      return false;
    case PositionVerdict::kBelieved:
      break;
  }
  call_ = Call::kBelieved;
  speed_.update(sample, time_);
  report_.energy_mj = passivity_.update(sample, sent_);
  if (speed_.must_cut()) {
    calm_ticks_ = 0;
    if (carries_force() && report_.state != SafetyState::kFalling) {
      soft_fault(SafetyFault::kTooFast, SafetyState::kFalling);
    }
  }
  return true;
}

StiffnessScale SafetyChain::budget(const Slopes& slopes) noexcept {
  const StiffnessScale scale = share_budget(limits_, slopes);
  if (scale != StiffnessScale{}) report_.limited_by |= kLimitedByBudget;
  return scale;
}

// --- the stages ---------------------------------------------------------------------------------

// After a rejected sample, sends the last force again or the next step of a fall. While waiting,
// sends no force. Otherwise applies the stages that depend on the present only (wanted()), then the
// ramps of the state.
Force SafetyChain::limit(const Force& asked, const PenSample& sample) noexcept {
  const Call call = call_;
  call_ = Call::kNone;
  report_.rms_force_n = motors_.rms_n();
  if (!is_armed()) return send({});
  if (call != Call::kBelieved && call != Call::kHeld) {
    hard_fault(SafetyFault::kSelfTest);
    return send({});
  }
  if (call == Call::kHeld) {
    if (report_.state == SafetyState::kFalling) return send(fall(sent_));
    return send(clamp(sent_, motors_.allowed_n(), kLimitedByContinuous));
  }
  if (!is_finite(asked) || !is_finite(sample)) {
    hard_fault(SafetyFault::kNotFinite);
    return send({});
  }
  if (report_.state == SafetyState::kWaiting) {
    wait(asked);
    return send({});
  }
  return send(by_state(wanted(wants_damping_only() ? damping(speed_.measured_mm_per_s()) : asked)));
}

Force SafetyChain::damping(const Vec3& velocity_mm_per_s) const noexcept {
  double largest = limits_.silent_damping_n_s_per_m;
  if (limits_.max_damping_n_s_per_m > 0.0)
    largest = std::min(largest, limits_.max_damping_n_s_per_m);
  return damping_force(largest, velocity_mm_per_s, limits_.peak_force_n);
}

/// Applies the stages that do not depend on the last sent force: peak, brake, motors.
Force SafetyChain::wanted(const Force& asked) noexcept {
  Force force = clamp(asked, limits_.peak_force_n, kLimitedByPeak);
  const double brake = brake_damping(limits_, speed_.speed_m_per_s());
  if (brake > 0.0) {
    report_.limited_by |= kLimitedBySpeed;
    force += damping_force(brake, speed_.velocity_mm_per_s(), limits_.peak_force_n);
    force = clamp_length(force, limits_.peak_force_n);
  }
  return clamp(force, motors_.allowed_n(), kLimitedByContinuous);
}

bool SafetyChain::wants_damping_only() const noexcept {
  return report_.state == SafetyState::kSilent ||
         (report_.state == SafetyState::kFalling && report_.fault != SafetyFault::kLateTick);
}

double SafetyChain::credit_n(double rate_n_per_ms) const noexcept {
  return rate_n_per_ms * kMsPerS * time_.credited_s;
}

Force SafetyChain::by_state(const Force& wanted) noexcept {
  switch (report_.state) {
    case SafetyState::kEngaging:
      return engage(wanted);
    case SafetyState::kActive:
      break;
    case SafetyState::kSilent:
      return step_towards(sent_, wanted,
                          credit_n(std::min(limits_.soft_fall_n_per_ms, limits_.rise_n_per_ms)));
    case SafetyState::kFalling:
      return fall(wanted);
    default:
      return {};
  }
  const Force risen = limit_rise(sent_, wanted, credit_n(limits_.rise_n_per_ms));
  if (risen != wanted) report_.limited_by |= kLimitedByRise;
  return risen;
}

void SafetyChain::wait(const Force& asked) noexcept {
  const bool is_calm = norm(asked) < limits_.engage_below_n && !speed_.must_cut() &&
                       time_.lateness == Lateness::kOnTime && silence_s_ < limits_.silent_damp_s;
  calm_ticks_ = is_calm ? calm_ticks_ + 1 : 0;
  report_.limited_by |= kLimitedByEngaging;
  if (calm_ticks_ >= limits_.engage_ticks) go_to(SafetyState::kEngaging);
}

Force SafetyChain::engage(const Force& wanted) noexcept {
  report_.limited_by |= kLimitedByEngaging;
  ramp_ = std::min(ramp_ + time_.credited_s / limits_.engage_s, 1.0);
  const Force target = ramp_ * wanted;
  const Force force = limit_rise(sent_, target, credit_n(limits_.engage_rise_n_per_ms));
  // Engaging ends only when the force has reached the target. Otherwise the faster rise of normal
  // operation would send the remaining difference immediately.
  const bool has_caught_up = norm(target - force) < limits_.engage_below_n;
  if (ramp_ >= 1.0 && has_caught_up) go_to(SafetyState::kActive);
  return force;
}

Force SafetyChain::fall(const Force& wanted) noexcept {
  const double ms = kMsPerS * time_.charged_s;
  const double ceiling = norm(sent_) - limits_.soft_fall_n_per_ms * ms;
  if (!(ceiling > 0.0)) {
    go_to(SafetyState::kWaiting);
    return {};
  }
  return limit_rise(sent_, clamp_length(wanted, ceiling), credit_n(limits_.rise_n_per_ms));
}

Force SafetyChain::clamp(const Force& force, double max_n, SafetyStage stage) noexcept {
  const Force clamped = clamp_length(force, max_n);
  if (clamped != force) report_.limited_by |= stage;
  if (stage == kLimitedByContinuous) report_.motors_are_warm = motors_.is_warm(clamped != force);
  return clamped;
}

Force SafetyChain::send(const Force& force) noexcept {
  sent_ = clamp_length(force, carries_force() ? limits_.peak_force_n : 0.0);
  return sent_;
}

}  // namespace felt
