#include "felt/haptics/safety/safety_motion.h"

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"

namespace felt {
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
  // Squares of huge distances are infinite, which is far enough.
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
  measured_mm_per_s_ = {};
  fast_samples_ = 0;
  speed_m_per_s_ = 0.0;
  velocity_mm_per_s_ = {};
  must_cut_ = false;
}

void SpeedGuard::update(const PenSample& sample, const TickTime& time) noexcept {
  bool is_judged = false;
  if (!has_anchor_) {
    has_anchor_ = true;
    anchor_mm_ = sample.position;
    since_anchor_s_ = 0.0;
  } else {
    since_anchor_s_ += time.charged_s;
    if (since_anchor_s_ >= span_s_) {
      measured_mm_per_s_ = (1.0 / since_anchor_s_) * (sample.position - anchor_mm_);
      anchor_mm_ = sample.position;
      since_anchor_s_ = 0.0;
      is_judged = true;
    }
  }
  const double measured = norm(measured_mm_per_s_);
  const double reported = norm(sample.velocity);
  velocity_mm_per_s_ = reported >= measured ? sample.velocity : measured_mm_per_s_;
  speed_m_per_s_ = kMPerMm * std::max(reported, measured);

  if (is_judged) fast_samples_ = speed_m_per_s_ > cut_m_per_s_ ? fast_samples_ + 1 : 0;
  fast_samples_ = std::min(fast_samples_, cut_samples_);
  must_cut_ = speed_m_per_s_ > cut_now_m_per_s_ || fast_samples_ >= cut_samples_;
}

}  // namespace felt
