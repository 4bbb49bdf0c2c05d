#include "felt/sound/distance_tone.h"

#include <algorithm>
#include <cmath>

#include "felt/sound/filters.h"
#include "felt/sound/plain_math.h"

namespace felt {
namespace {

constexpr double kSteadyHz = 165.0, kFarHz = 220.0, kOctaves = 2.0;
constexpr double kFarPulsesHz = 2.0, kNearPulsesHz = 12.0;
constexpr double kPulseShare = 0.4;  // of a period during which a pulse sounds
constexpr double kRiseS = 0.004;
constexpr int kClickSamples = 720;  // 15 ms
constexpr double kClickHz = 1500.0, kClickLevel = 0.5;

double sine(double phase) noexcept {
  return plain::sin(2.0 * plain::kPi * (phase > 0.5 ? phase - 1.0 : phase));
}

}  // namespace

void DistanceTone::set(const ToneInput& input) noexcept {
  if (input.is_on && input.clicks != input_.clicks) click_left_ = kClickSamples;
  input_ = input;
  const double distance = static_cast<double>(input.distance_mm);
  // NaN counts as far away.
  const double near = distance < kFarMm ? 1.0 - std::max(0.0, distance) / kFarMm : 0.0;
  const bool is_steady = distance <= kOnLineMm;
  hz_ = is_steady ? kSteadyHz : kFarHz * plain::exp2(kOctaves * near);
  pulses_hz_ = is_steady ? 0.0 : kFarPulsesHz + (kNearPulsesHz - kFarPulsesHz) * near * near;
}

double DistanceTone::next() noexcept {
  constexpr double kShare = follow_share(kRiseS, kRateHz);
  phase_ += hz_ / kRateHz;
  if (phase_ >= 1.0) phase_ -= 1.0;
  pulse_ += pulses_hz_ / kRateHz;
  if (pulse_ >= 1.0) pulse_ -= 1.0;
  const bool is_near = static_cast<double>(input_.distance_mm) < kFarMm;
  const bool sounds = input_.is_on && is_near && (pulses_hz_ == 0.0 || pulse_ < kPulseShare);
  level_ += kShare * ((sounds ? 1.0 : 0.0) - level_);
  double out = kLoudness * level_ * sine(phase_);
  if (click_left_ > 0) {
    const double left = static_cast<double>(click_left_--) / kClickSamples;
    const double turns = kClickHz * static_cast<double>(click_left_) / kRateHz;
    out += kClickLevel * left * left * sine(turns - std::floor(turns));
  }
  return out;
}

}  // namespace felt
