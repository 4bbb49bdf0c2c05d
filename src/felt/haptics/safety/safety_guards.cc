#include "felt/haptics/safety/safety_guards.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/base/constants.h"
#include "felt/haptics/sample_gap.h"

namespace felt {
namespace {

constexpr double kShortestS = 0.0002;
constexpr double kLongestS = 0.005;

/// Returns `to` minus `from` in s. Uses unsigned numbers because their difference does not
/// overflow.
double seconds_between(std::int64_t from, std::int64_t to) noexcept {
  const auto difference = [](std::int64_t low, std::int64_t high) {
    return 1e-9 *
           static_cast<double>(static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low));
  };
  return to >= from ? difference(from, to) : -difference(to, from);
}

}  // namespace

TickClock::TickClock(const SafetyLimits& limits) noexcept
    : period_s_(1e-9 * static_cast<double>(limits.period_ns)),
      late_s_(limits.late_s),
      very_late_s_(limits.very_late_s) {}

TickTime TickClock::tick(std::int64_t now_ns) noexcept {
  const double measured_s = has_last_ ? seconds_between(last_ns_, now_ns) : period_s_;
  last_ns_ = now_ns;
  has_last_ = true;

  TickTime time;
  time.model_s = std::clamp(measured_s, kShortestS, kLongestS);
  time.credited_s = std::clamp(measured_s, 0.0, std::min(2.0 * period_s_, kLongestS));
  time.charged_s = std::max(measured_s, kShortestS);
  if (std::abs(measured_s) > very_late_s_) {
    time.lateness = Lateness::kVeryLate;
  } else if (std::abs(measured_s) > late_s_) {
    time.lateness = Lateness::kLate;
  }
  return time;
}

void HeartbeatWatch::beat(std::int64_t made_ns) noexcept {
  if (has_beat_ && made_ns == last_beat_ns_) return;
  has_beat_ = true;
  is_new_ = true;
  last_beat_ns_ = made_ns;
}

void HeartbeatWatch::restart() noexcept {
  silence_s_ = 0.0;
  is_new_ = false;
}

double HeartbeatWatch::tick(std::int64_t now_ns, const TickTime& time) noexcept {
  silence_s_ += time.charged_s;
  if (is_new_) {
    is_new_ = false;
    // A heartbeat that arrives late counts with its age. A heartbeat from the future counts as sent
    // now.
    silence_s_ = std::min(silence_s_, std::max(seconds_between(last_beat_ns_, now_ns), 0.0));
  }
  return silence_s_;
}

namespace {

constexpr double kForgivenShare = 0.125;

}  // namespace

bool is_finite(const PenSample& sample) noexcept {
  return is_finite(sample.position) && is_finite(sample.velocity) &&
         std::isfinite(sample.pressure.value_or(0.0));
}

bool repeats(const PenSample& last, const PenSample& sample) noexcept {
  return sample.time_ns == last.time_ns && sample.position == last.position &&
         sample.velocity == last.velocity;
}

JumpGuard::JumpGuard(const SafetyLimits& limits) noexcept
    : jump_mm_per_s_(limits.jump_mm_per_ms * kMsPerS), hold_s_(limits.jump_hold_s) {}

PositionVerdict JumpGuard::judge(const Vec3& position_mm, const TickTime& time) noexcept {
  const double span_s = time.lateness == Lateness::kVeryLate
                            ? kMaxReachS
                            : std::min(waited_s_ + time.model_s, kMaxReachS);
  waited_s_ = 0.0;
  // The square of a huge distance may be infinite, which correctly counts as too far.
  if (!has_last_ || norm(position_mm - last_mm_) <= jump_mm_per_s_ * span_s) {
    last_mm_ = position_mm;
    has_last_ = true;
    is_holding_ = false;
    doubt_s_ = std::max(0.0, doubt_s_ - kForgivenShare * time.model_s);
    return PositionVerdict::kBelieved;
  }
  held_s_ = is_holding_ ? held_s_ + time.charged_s : 0.0;
  is_holding_ = true;
  doubt_s_ += time.model_s;
  constexpr double kRounding = 1e-9;
  const bool too_long = held_s_ + kRounding >= hold_s_ || doubt_s_ >= kMaxDoubtS;
  return too_long ? PositionVerdict::kFault : PositionVerdict::kHeld;
}

SpeedGuard::SpeedGuard(const SafetyLimits& limits) noexcept
    : cut_m_per_s_(limits.cut_m_per_s),
      cut_now_m_per_s_(limits.cut_now_m_per_s),
      cut_samples_(limits.cut_samples),
      span_s_(0.9e-9 * static_cast<double>(limits.period_ns)) {}

void SpeedGuard::reset() noexcept {
  has_anchor_ = false;
  fast_samples_ = 0;
  must_cut_ = false;
  forget_speed();
}

void SpeedGuard::forget_speed() noexcept {
  measured_mm_per_s_ = velocity_mm_per_s_ = {};
  speed_m_per_s_ = 0.0;
  filter_.reset();
}

void SpeedGuard::wait(const TickTime& time) noexcept {
  since_anchor_s_ += time.charged_s;
  waited_s_ += time.charged_s;
  if (waited_s_ > kMaxSampleGapS) forget_speed();
}

// Measures the speed from an anchor position over at least span_s_. Only such measurements count
// towards cut_samples_; a single higher speed, reported or measured, cuts at cut_now_m_per_s_.
void SpeedGuard::update(const PenSample& sample, const TickTime& time) noexcept {
  bool is_judged = false;
  waited_s_ = 0.0;
  if (!has_anchor_) {
    has_anchor_ = true;
    anchor_mm_ = sample.position;
    since_anchor_s_ = 0.0;
    filter_.update(sample.position, 0.0);
  } else {
    since_anchor_s_ += time.charged_s;
    if (since_anchor_s_ >= span_s_) {
      measured_mm_per_s_ = (1.0 / since_anchor_s_) * (sample.position - anchor_mm_);
      filter_.update(sample.position, since_anchor_s_);
      anchor_mm_ = sample.position;
      since_anchor_s_ = 0.0;
      is_judged = true;
    }
  }
  const double measured = norm(measured_mm_per_s_);
  const double reported = norm(sample.velocity);
  // The low-passed one, because positions may come at a lower rate than ticks.
  const bool agree = dot(sample.velocity, filter_.velocity()) > 0.0;
  velocity_mm_per_s_ = agree && reported >= measured ? sample.velocity : measured_mm_per_s_;
  speed_m_per_s_ = kMPerMm * std::max(reported, measured);

  if (is_judged) fast_samples_ = speed_m_per_s_ > cut_m_per_s_ ? fast_samples_ + 1 : 0;
  fast_samples_ = std::min(fast_samples_, cut_samples_);
  must_cut_ = speed_m_per_s_ > cut_now_m_per_s_ || fast_samples_ >= cut_samples_;
}

namespace {

constexpr double kLongestTickS = 0.005;

}  // namespace

double sustained_force_n(const SafetyLimits& limits) noexcept {
  if (!(limits.continuous_force_n > 0.0)) return std::numeric_limits<double>::infinity();
  const double tau_s = 0.5 * limits.rms_window_s;
  return limits.continuous_force_n * std::sqrt(limits.rms_window_s / (limits.rms_window_s + tau_s));
}

MotorGuard::MotorGuard(const SafetyLimits& limits) noexcept
    : tau_s_(0.5 * limits.rms_window_s),
      sustained_n_(limits.continuous_force_n > 0.0 ? sustained_force_n(limits) : 0.0),
      // A fade from F to s newtons at `slope` costs (F - s)^2 (F + 2 s)/(3 slope) N^2 s more than
      // holding s. Replacing F + 2 s by its upper bound, peak + 2 s, makes this solvable for F.
      gain_(3.0 * (limits.peak_force_n / limits.rms_fade_s) * tau_s_ /
            (limits.peak_force_n + 2.0 * sustained_n_)) {
  if (!(gain_ > 0.0)) gain_ = 0.0;  // if the peak is 0, it is 0/0
}

void MotorGuard::heat(double force_n, double duration_s) noexcept {
  // An implicit step, so that the energy balance is correct for any duration.
  const double share = duration_s / tau_s_;
  mean_square_ = (mean_square_ + share * force_n * force_n) / (1.0 + share);
}

double MotorGuard::allowed_n() const noexcept {
  if (!(sustained_n_ > 0.0)) return std::numeric_limits<double>::infinity();
  const double room = std::max(sustained_n_ * sustained_n_ - mean_square_, 0.0);
  const double fading = sustained_n_ + std::sqrt(gain_ * room);
  // The force that reaches the bound within a single tick. This limit decides at the end of the
  // fade.
  const double in_a_tick = std::sqrt(sustained_n_ * sustained_n_ + room * (tau_s_ / kLongestTickS));
  return std::min(fading, in_a_tick);
}

double MotorGuard::rms_n() const noexcept {
  return std::sqrt(mean_square_);
}

bool MotorGuard::is_warm(bool limited) noexcept {
  if (limited) {
    warm_ = true;
  } else if (mean_square_ < 0.5 * sustained_n_ * sustained_n_) {
    warm_ = false;
  }
  return warm_;
}

void PassivityObserver::reset() noexcept {
  *this = PassivityObserver{};
}

double PassivityObserver::update(const PenSample& sample, const Force& sent) noexcept {
  constexpr double kMaxMj = 1e9;
  const bool is_in_contact = in_contact(sample);
  if (is_in_contact && !was_in_contact_) energy_mj_ = 0.0;
  if (has_last_) {
    const double work = work_mj(sent, sample.position - last_mm_);
    if (std::isfinite(work)) energy_mj_ = std::clamp(energy_mj_ + work, -kMaxMj, kMaxMj);
  }
  was_in_contact_ = is_in_contact;
  has_last_ = true;
  last_mm_ = sample.position;
  return energy_mj_;
}

}  // namespace felt
