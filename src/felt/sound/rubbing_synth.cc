#include "felt/sound/rubbing_synth.h"

#include <algorithm>
#include <cmath>

#include "felt/geometry/height_field.h"

namespace felt {
namespace {

constexpr double kRateHz = RubbingSynth::kRateHz;
// Smoothing of the path: it removes the steps of a sensor (0.05 mm in a millisecond), but not the
// motion of a hand.
constexpr double kWay = follow_share(0.003, kRateHz);
constexpr double kStillMmPerS = 1.5,
                 kMovesMmPerS = 5.0;  // silent below kStillMmPerS, full loudness above kMovesMmPerS
constexpr double kFastestMmPerS = 3000.0;
constexpr double kMaxReceivedPushN = 4.0;
// The gate opens before anything is audible, and closes before the user notices a delay.
constexpr double kOpenS = 0.0005, kCloseS = 0.012;
// The loudness is 1 for a friction of 0.3 N at 200 mm/s, which is 60 mW.
constexpr double kFullPowerMw = 60.0;
constexpr double kUsualGrainUm = 10.0, kMinGrainUm = 1.5, kMaxRough = 1.6;
constexpr double kHissGain = 1.8;
constexpr double kHillGain = 0.02;   // multiplies slope and speed in mm/s, at a push of 1 N
constexpr double kHillDepth = 0.75;  // how much louder the roughness is uphill
constexpr double kLevel = 0.32;
constexpr double kCeiling = 0.9;
constexpr double kLowestHz = 45.0;
/// Corner of the high-pass filter of the roughness, whose low tones are weak because it does not
/// shake the table.
constexpr double kHissHz = 500.0;
constexpr double kInaudible = 1e-7;  // -140 dB
// For the squeak: the Stribeck curve falls most steeply at kStribeckMmPerS / sqrt(2).
constexpr double kStribeckMmPerS = 130.0;
constexpr double kSqueakRate = 0.012, kSqueakLoss = 0.55, kSqueakGain = 4.0, kSqueakSeed = 2e-4;
// The tap is a pulse of 1.2 ms that remains audible for kTapS.
constexpr double kTapForceS = 0.0012, kTapS = 0.012, kFullStrike = 150.0;
constexpr double kTapGain = 1.8;
/// Longest wave of the roughness if the surface has no relief.
constexpr double kSmoothLongestMm = 0.5;

double unit(double value) noexcept {
  return value > 0.0 ? std::min(value, 1.0) : 0.0;
}

/// Returns x softly limited to -1..1; linear near 0.
double bent(double x) noexcept {
  return x / std::sqrt(1.0 + x * x);
}

}  // namespace

RubbingSynth::RubbingSynth() noexcept {
  set_pair({});
}

void RubbingSynth::set_pair(const RubbingPair& pair) noexcept {
  pair_ = pair;
  const bool has_relief = pair.relief != nullptr && pair.relief->max_slope() > 0.0;
  if (!has_relief) pair_.relief = nullptr;
  const double wave_mm = has_relief ? pair.relief->spec().wavelength_mm : 2.0 * kSmoothLongestMm;
  const double rms_mm = has_relief ? 1e-3 * pair.relief->spec().rms_um : 0.0;
  slope_scale_ = has_relief ? wave_mm / (2.0 * plain::kPi * rms_mm) : 0.0;
  roughness_.set(0.5 * wave_mm, pair.seed);
  const double bright = 0.5 * (pair.surface_brightness + pair.medium_brightness);
  low_pass_.set(700.0 * plain::exp2(4.5 * bright), kRateHz);
  high_pass_.set(kLowestHz, kRateHz);
  hiss_pass_.set(kHissHz, kRateHz);
  // Bodies 0 and 1 are a page on its table: the lowest two modes of a plate. The frequency of the
  // second is 2.8 times as high, about as for a square plate clamped at its rim. Body 2 is the
  // stick of the medium, about 100 mm of wood, chalk or rubber held in a hand.
  const double boom_hz =
      200.0 * std::sqrt(std::clamp(pair.stiffness_n_per_m, 50.0, 5000.0) / 500.0);
  bodies_[0].set(boom_hz, 2.5, kRateHz);
  bodies_[1].set(2.8 * boom_hz * (0.7 + 0.6 * pair.surface_brightness), 3.0, kRateHz);
  bodies_[2].set(900.0 * plain::exp2(2.2 * pair.medium_brightness), 4.0, kRateHz);
  level_ = kLevel * pair.loudness;
}

void RubbingSynth::strike(double mm_per_s) noexcept {
  // A dull (soft) medium makes a softer tap.
  tap_gain_ = kTapGain * (0.25 + pair_.medium_brightness) * std::sqrt(unit(mm_per_s / kFullStrike));
  tap_left_ = static_cast<int>(kTapForceS * kRateHz);
  tap_window_ = static_cast<int>(kTapS * kRateHz);
}

void RubbingSynth::follow(Point at, double push_n) noexcept {
  const bool touches = push_n > 0.0;
  if (touches && !touches_ && gate_ == 0.0)
    first_ = at_ = at;  // because the motion above the surface is not rubbing
  touches_ = touches;
  first_ = first_ + kWay * (at - first_);
  const Vec step = kWay * (first_ - at_);
  at_ = at_ + step;
  velocity_ = kRateHz * step;
  speed_ = std::min(norm(velocity_), kFastestMmPerS);
  push_ += kWay * (std::min(push_n, kMaxReceivedPushN) - push_);
}

/// Updates the values that change slowly. Called three times in a millisecond.
void RubbingSynth::look() noexcept {
  const bool rubs = touches_ && speed_ > kStillMmPerS;
  gate_goal_ = rubs || tap_window_ > 0 ? 1.0 : 0.0;
  roughness_.set_speed(speed_, kRateHz, kControlSamples);
  if (pair_.squeak <= 0.0) return;
  // Energy feed of the squeak: how steeply friction falls with speed (1 at the steepest), times the
  // push, minus the losses of the mode.
  const double v = speed_ / kStribeckMmPerS;
  const double falls = 2.3316 * v * plain::exp(-std::min(v * v, 50.0));
  squeak_feed_ = touches_ ? pair_.squeak * falls * std::min(push_, 1.5) - kSqueakLoss : -1.0;
  const double hz = 1100.0 * plain::exp2(1.3 * pair_.medium_brightness) *
                    (1.0 + 0.10 * std::min(push_, 2.0) + 0.15 * v / (1.0 + v));
  const double turn = 2.0 * plain::kPi * hz / kRateHz;
  squeak_cos_ = plain::cos(turn);
  squeak_sin_ = plain::sin(turn);
}

double RubbingSynth::excitation() noexcept {
  const double moves =
      std::clamp((speed_ - kStillMmPerS) / (kMovesMmPerS - kStillMmPerS), 0.0, 1.0);
  // Pressure flattens the relief, and a soft medium transmits less of it.
  const double through = pair_.through * relief_left(pair_.wear, push_ / pair_.firm_push_n);
  double slope = 0.0;
  if (pair_.relief != nullptr && speed_ > kStillMmPerS) {
    slope = dot(pair_.relief->at(at_).slope, velocity_) / speed_ * through;
  }
  const double uphill = 1.0 + kHillDepth * bent(slope * slope_scale_);
  const double rough =
      std::min(std::sqrt((kMinGrainUm + pair_.grain_um) / kUsualGrainUm), kMaxRough);
  const double power_mw = pair_.friction * push_ * speed_;
  noise_ = moves * roughness_.next(at_);
  const double hiss = rough * std::sqrt(power_mw / kFullPowerMw) * uphill * noise_;
  const double hills = kHillGain * slope * speed_ * std::sqrt(push_);
  return kHissGain * hiss_pass_(hiss) + moves * hills;
}

double RubbingSynth::squeak() noexcept {
  const double size = squeak_a_ * squeak_a_ + squeak_b_ * squeak_b_;
  if (squeak_feed_ <= 0.0 && size < kInaudible * kInaudible) return squeak_a_ = squeak_b_ = 0.0;
  const double grows = 1.0 + kSqueakRate * (squeak_feed_ - size);
  const double a = squeak_cos_ * squeak_a_ - squeak_sin_ * squeak_b_;
  const double b = squeak_sin_ * squeak_a_ + squeak_cos_ * squeak_b_;
  squeak_a_ = grows * a + kSqueakSeed * noise_;
  squeak_b_ = grows * b;
  return kSqueakGain * squeak_a_;
}

double RubbingSynth::tap() noexcept {
  if (tap_window_ > 0) --tap_window_;
  if (tap_left_ <= 0) return 0.0;
  const double all = std::floor(kTapForceS * kRateHz);
  const double part = 1.0 - --tap_left_ / all;   // 0..1 during the touch
  return tap_gain_ * 4.0 * part * (1.0 - part);  // a parabola, close to a half sine
}

void RubbingSynth::be_silent() noexcept {
  gate_ = squeak_a_ = squeak_b_ = 0.0;
  low_pass_.clear();
  high_pass_.clear();
  hiss_pass_.clear();
  for (Resonator& body : bodies_) body.clear();
}

double RubbingSynth::next(Point at, double push_n) noexcept {
  follow(at, push_n);
  if (--until_look_ <= 0) {
    until_look_ = kControlSamples;
    look();
  }
  const double step = gate_goal_ > gate_ ? 1.0 / (kOpenS * kRateHz) : -1.0 / (kCloseS * kRateHz);
  gate_ = std::clamp(gate_ + step, 0.0, 1.0);
  if (gate_ == 0.0) {
    be_silent();
    return 0.0;
  }
  const double rubbing = excitation() + tap();
  double sound = low_pass_(rubbing);
  constexpr std::array<double, 3> kHow{0.35, 0.35, 0.9};
  for (std::size_t i = 0; i < bodies_.size(); ++i) sound += kHow[i] * bodies_[i](rubbing);
  sound = high_pass_(pair_.squeak > 0.0 ? sound + squeak() : sound);
  const double out = gate_ * gate_ * (3.0 - 2.0 * gate_) * kCeiling * bent(level_ * sound);
  return std::fabs(out) > kInaudible ? out : 0.0;
}

}  // namespace felt
