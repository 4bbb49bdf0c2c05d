#include "desktop/feel/friction_synth.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace felt::desktop {
namespace {

constexpr double kTau = 6.283185307179586;
constexpr double kFollowS = 0.006;
constexpr double kDriftHz = 60.0;
constexpr double kFullForceN = 0.6;       // as loud as it gets
constexpr double kFullSpeedMmPerS = 200;  // likewise
constexpr double kFastestMmPerS = 3000.0;
constexpr double kSilent = 1e-5;  // -100 dB

/// 0..1 and NaN as 0.
double unit(double value) noexcept {
  return value > 0.0 ? std::min(value, 1.0) : 0.0;
}

/// Share of the way to its target that a first-order follower makes in a sample.
double share_of(double time_s, double rate_hz) noexcept {
  return 1.0 - std::exp(-1.0 / (time_s * rate_hz));
}

}  // namespace

RubTimbre timbre_of(const SurfaceMaterial& material) noexcept {
  if (material.id == "blackboard") return {0.09, 6500.0, 1.0};
  if (material.id == "felt") return {0.30, 1400.0, 0.6};
  if (material.id == "glass") return {0.05, 2500.0, 0.15};
  return {0.12, 4500.0, 0.8};
}

FrictionSynth::FrictionSynth(double rate_hz) noexcept
    : rate_hz_(std::clamp(rate_hz, 8000.0, 192000.0)) {
  make_noise();
}

/// Each level is the one before it, smoothed and with half as many values, as loud again.
void FrictionSynth::make_noise() noexcept {
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < kSize; ++i) {
    state = 1664525u * state + 1013904223u;  // Numerical Recipes' generator
    noise_[i] = static_cast<float>(static_cast<double>(state >> 8) / 8388608.0 - 1.0);
  }
  std::size_t from = 0, size = kSize;
  for (std::size_t level = 1; level < kLevels; ++level) {
    const std::size_t to = from + size, half = size / 2;
    double sum = 0.0;
    for (std::size_t i = 0; i < half; ++i) {
      const float a = noise_[from + (2 * i + size - 1) % size], b = noise_[from + 2 * i];
      const float c = noise_[from + 2 * i + 1];
      noise_[to + i] = 0.25F * a + 0.5F * b + 0.25F * c;
      sum += static_cast<double>(noise_[to + i]) * static_cast<double>(noise_[to + i]);
    }
    constexpr double kRms = 0.577;  // of the finest
    const auto louder = static_cast<float>(kRms / std::sqrt(sum / static_cast<double>(half)));
    for (std::size_t i = 0; i < half; ++i) noise_[to + i] *= louder;
    from = to;
    size = half;
  }
}

double FrictionSynth::noise_at(std::size_t level) const noexcept {
  std::size_t from = 0, size = kSize;
  for (std::size_t i = 0; i < level; ++i) {
    from += size;
    size /= 2;
  }
  const double at = way_ / static_cast<double>(std::size_t{1} << level);
  const auto index = static_cast<std::size_t>(at);
  const double part = at - static_cast<double>(index);
  const auto value = [&](std::size_t i) { return static_cast<double>(noise_[from + i % size]); };
  const double eased = part * part * (3.0 - 2.0 * part);
  return value(index) + eased * (value(index + 1) - value(index));
}

void FrictionSynth::rub(const Rubbing& now) noexcept {
  const auto sane = [](double value) { return std::isfinite(value) && value > 0.0 ? value : 0.0; };
  target_.speed_mm_per_s = std::min(sane(now.speed_mm_per_s), kFastestMmPerS);
  target_.friction_n = sane(now.friction_n);
  target_.timbre.grain_mm = std::max(sane(now.timbre.grain_mm), 0.01);
  target_.timbre.brightness_hz = std::clamp(sane(now.timbre.brightness_hz), 100.0, 0.4 * rate_hz_);
  target_.timbre.loudness = unit(now.timbre.loudness);
}

double FrictionSynth::next() noexcept {
  const double follow = share_of(kFollowS, rate_hz_);
  speed_ += follow * (target_.speed_mm_per_s - speed_);
  const double loud = target_.timbre.loudness * unit(target_.friction_n / kFullForceN) *
                      std::sqrt(unit(target_.speed_mm_per_s / kFullSpeedMmPerS));
  gain_ += follow * (loud - gain_);
  if (gain_ < kSilent && loud == 0.0) {
    gain_ = low_ = lower_ = drift_ = 0.0;
    return 0.0;
  }
  const double step = speed_ / (rate_hz_ * target_.timbre.grain_mm);
  way_ = std::fmod(way_ + step, static_cast<double>(kSize));
  // At most half a value of the noise a sample; between two levels both are heard.
  const double fine = std::clamp(std::log2(std::max(2.0 * step, 1e-9)) + 1.0, 0.0,
                                 static_cast<double>(kLevels) - 1.001);
  const auto level = static_cast<std::size_t>(fine);
  const double part = fine - static_cast<double>(level);
  const double raw = (1.0 - part) * noise_at(level) + part * noise_at(level + 1);
  const double damp = share_of(1.0 / (kTau * target_.timbre.brightness_hz), rate_hz_);
  low_ += damp * (raw - low_);
  lower_ += damp * (low_ - lower_);
  drift_ += share_of(1.0 / (kTau * kDriftHz), rate_hz_) * (lower_ - drift_);
  const double sound = 2.0 * gain_ * (lower_ - drift_);
  return kLoudest * sound / (1.0 + std::fabs(sound));
}

void FrictionSynth::render(std::span<float> samples) noexcept {
  for (float& sample : samples) sample = static_cast<float>(next());
}

}  // namespace felt::desktop
