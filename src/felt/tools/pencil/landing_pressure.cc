#include "felt/tools/pencil/landing_pressure.h"

#include <algorithm>

namespace felt {
namespace {

constexpr double kLongestDotMm = 0.5;
constexpr double kOvershoot = 1.1;  // of an impact; less is the hand's
constexpr double kDip = 0.9;        // of an impact, as a share of the level

double pressure_of(const InkSample& sample) {
  return sample.pressure.value_or(0.0);
}

bool is_dot(const std::vector<InkSample>& samples) {
  double path_mm = 0.0;
  for (std::size_t i = 1; i < samples.size() && path_mm <= kLongestDotMm; ++i) {
    path_mm += distance(samples[i - 1].position, samples[i].position);
  }
  return path_mm <= kLongestDotMm;
}

}  // namespace

void LandingPressure::begin(const PenSample& touch, bool is_felt) {
  lands_ = is_felt && -touch.velocity.z >= kMinFallMmPerS;
  touch_ns_ = bounce_ns_ = touch.time_ns;
  held_.clear();
  released_.clear();
}

std::int64_t LandingPressure::age_ns(std::size_t i) const noexcept {
  const std::int64_t time_ns = held_[i].time_ns.value_or(touch_ns_);
  return time_ns > touch_ns_ ? time_ns - touch_ns_ : 0;
}

std::span<const InkSample> LandingPressure::push(const InkSample& sample, bool touches) {
  released_.clear();
  if (!lands_) {
    released_.push_back(sample);
    return released_;
  }
  held_.push_back(sample);
  const std::int64_t now_ns = touch_ns_ + age_ns(held_.size() - 1);
  if (!touches) bounce_ns_ = now_ns;
  if (now_ns - bounce_ns_ < kSettleNs && now_ns - touch_ns_ < kLongestNs &&
      held_.size() < kMaxHeld) {
    return released_;
  }
  return release();
}

std::span<const InkSample> LandingPressure::end() {
  released_.clear();
  return lands_ ? release() : released_;
}

std::vector<InkSample> LandingPressure::held() const {
  std::vector<InkSample> samples = held_;
  correct(samples);
  return samples;
}

/// Returns the age of the samples from which on the pressure counts as settled: the last half of
/// kSettleNs, or the last half of a line that is shorter.
std::int64_t LandingPressure::level_from_ns() const noexcept {
  const std::int64_t last_ns = age_ns(held_.size() - 1);
  const std::int64_t contact_ns = last_ns - (bounce_ns_ - touch_ns_);
  return last_ns - std::min(kSettleNs / 2, contact_ns / 2);
}

/// Returns the pressure at which the pen settles: the mean of the newest samples. Returns nullopt
/// for a dot, which has no settled part.
std::optional<double> LandingPressure::level() const noexcept {
  if (is_dot(held_)) return std::nullopt;
  const std::int64_t from_ns = level_from_ns();
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = held_.size(); i-- > 0 && age_ns(i) >= from_ns; ++count) {
    sum += pressure_of(held_[i]);
  }
  return sum / std::max(count, 1);
}

/// Returns true if the pen bounced, or if its first peak of pressure is early and higher than the
/// level.
bool LandingPressure::is_impact(double level) const noexcept {
  if (bounce_ns_ > touch_ns_) return true;
  std::size_t peak = 0;
  for (std::size_t i = 0; i < held_.size() && age_ns(i) <= 2 * kPeakNs; ++i) {
    if (pressure_of(held_[i]) > pressure_of(held_[peak])) peak = i;
  }
  return age_ns(peak) <= kPeakNs && pressure_of(held_[peak]) > kOvershoot * level;
}

void LandingPressure::correct(std::vector<InkSample>& samples) const {
  const std::optional<double> settled = level();
  if (!settled || !is_impact(*settled)) return;
  const double newest = pressure_of(samples.back());
  const bool is_above = newest > *settled;
  // After an impact, the pressure may dip and come back to the level without passing through it.
  const double least = newest >= kDip * *settled ? kDip * *settled : 0.0;
  const double floor = least > 0.0 ? std::min(newest, *settled) : 0.0;
  const auto is_settled = [&](double pressure) {
    return (pressure > *settled) == is_above && pressure >= least;
  };
  std::size_t end = samples.size();
  while (end > 0 && is_settled(pressure_of(samples[end - 1]))) --end;
  for (std::size_t i = 0; i < end; ++i) samples[i].pressure = *settled;
  for (std::size_t i = end; i < samples.size(); ++i) {
    samples[i].pressure = std::clamp(pressure_of(samples[i]), floor, *settled);
  }
}

std::span<const InkSample> LandingPressure::release() {
  lands_ = false;
  released_ = held_;
  correct(released_);
  held_.clear();
  return released_;
}

}  // namespace felt
