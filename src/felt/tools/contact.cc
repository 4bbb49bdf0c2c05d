#include "felt/tools/contact.h"

#include <algorithm>
#include <utility>

namespace felt {
namespace {

constexpr double kSpeedNoiseMmPerS = 6.0;  // of the filtered speed
constexpr double kHeightNoiseMm = 0.1;     // steps of sensors, and grain
// The filtered speed lags behind that of a pen that the surface still pushes out.
constexpr double kLagOfLeaving = 1.4;

/// Computed in double, because the difference of two invalid times may overflow 64 bits.
double ns_between(std::int64_t from_ns, std::int64_t to_ns) noexcept {
  return static_cast<double>(to_ns) - static_cast<double>(from_ns);
}

}  // namespace

void Contact::reset() noexcept {
  const std::int64_t landed_ns = landed_ns_;
  *this = {};
  landed_ns_ = landed_ns;
}

Contact::Change Contact::update(const PenSample& sample) noexcept {
  const double dt_s = std::clamp(1e-9 * ns_between(last_ns_, sample.time_ns), 0.0, 1.0);
  const double rising = speed_.update({0.0, 0.0, sample.position.z}, dt_s).z;
  last_ns_ = sample.time_ns;
  if (in_contact(sample)) return touch(sample);
  if (phase_ == Phase::kDown) {
    phase_ = Phase::kGap;
    gap_since_ns_ = sample.time_ns;
    gap_from_mm_ = sample.position.z;
    leaving_mm_per_s_ = rising;
    gap_samples_ = 0;
  }
  if (phase_ == Phase::kGap) {
    ++gap_samples_;
    if (is_chatter(sample) || is_bounce(sample)) return Change::kGap;
  }
  fall_mm_per_s_ = -rising;
  return std::exchange(phase_, Phase::kAir) == Phase::kGap ? Change::kLifted : Change::kAir;
}

Contact::Change Contact::touch(const PenSample& sample) noexcept {
  const Phase before = std::exchange(phase_, Phase::kDown);
  if (before == Phase::kAir) {
    lands_ = landed_ns_ > 0 && !sample.pressure && fall_mm_per_s_ >= kMinLandingMmPerS &&
             fall_mm_per_s_ <= kMaxLandingMmPerS;
  }
  if (before != Phase::kDown) down_since_ns_ = sample.time_ns;
  if (ns_between(down_since_ns_, sample.time_ns) >= static_cast<double>(landed_ns_)) lands_ = false;
  if (before == Phase::kAir) return Change::kTouched;
  return before == Phase::kGap ? Change::kBack : Change::kDown;
}

bool Contact::is_chatter(const PenSample& sample) const noexcept {
  return sample.position.z < kLiftMm && gap_samples_ < kMaxGapSamples &&
         ns_between(gap_since_ns_, sample.time_ns) < static_cast<double>(kLiftNs);
}

bool Contact::is_bounce(const PenSample& sample) const noexcept {
  const double gap_ns = ns_between(gap_since_ns_, sample.time_ns);
  const std::int64_t longest_ns = sample.position.z < kLowBounceMm ? kLowBounceNs : kBounceNs;
  if (!lands_ || sample.position.z >= kBounceMm || gap_ns < 0.0 ||
      gap_ns >= static_cast<double>(longest_ns) || gap_samples_ > kMaxBounceSamples) {
    return false;
  }
  // Thrown at this speed and then slowed down by the hand, the pen cannot be higher.
  const double thrown_mm_per_s =
      std::min(kLagOfLeaving * leaving_mm_per_s_, fall_mm_per_s_) + kSpeedNoiseMmPerS;
  return sample.position.z <= gap_from_mm_ + kHeightNoiseMm + 1e-9 * gap_ns * thrown_mm_per_s;
}

}  // namespace felt
