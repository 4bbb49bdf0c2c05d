#include "felt/devices/simulated/blind_hand.h"

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"

namespace felt {
namespace {

// docs/design/simulation.md#without-eyes has the sources.
constexpr double kFeelDelayS = 0.12;
constexpr double kFeelBlurS = 0.05;
constexpr double kNoiseN = 0.02, kNoiseShare = 0.1, kNoiseS = 0.1;
constexpr double kPressMm = 1.5;  // below the surface

constexpr double kRestS = 1.0;                    // after the touch
constexpr double kSpeed = 22.0, kMinSpeed = 6.0;  // mm/s
constexpr double kSlowingN = 0.35;                // the force at which the pen is slowest
constexpr double kTurnPerN = 3.0;                 // rad/s for each N from the side
constexpr double kYieldPerN = 40.0;               // mm/s for each N from the side
constexpr double kWeaveMm = 0.8, kWeaveHz = 0.9;

constexpr double kHeldBackN = 0.33, kHeldBackS = 0.15;
constexpr double kNothingN = 0.045, kNothingS = 0.9;
constexpr double kFeltN = 0.08;
// A force that was strong and is gone: the pen has slipped off the line.
constexpr double kStrongN = 0.3, kGoneShare = 0.25, kForgetNPerS = 1.0;

constexpr std::array kProbesDeg{90.0, -90.0, 45.0, -45.0, 135.0, -135.0};
/// If no end was heard, the directions of the next round lie between those of the last one.
constexpr std::array kRoundsDeg{0.0, -22.5, 22.5};
constexpr double kProbeSpeed = 14.0, kBackSpeed = 30.0;  // mm/s
constexpr double kProbeMm = 8.0, kProbeHeldN = 0.28, kProbeFeltN = 0.06;
constexpr double kHeardS = 0.25;      // a reaction to sound, and some patience
constexpr double kFeelAgainS = 0.25;  // until the felt force is that of the new position

Person without_eyes(Person person) {
  person.eye_gain_per_s = 0.0;
  person.eye_noise_mm = 0.0;
  person.load_share = 0.0;  // the hand yields to the line instead of resisting it
  person.preview_s = 0.0;   // nothing is known ahead
  return person;
}

Vec unit(double rad) noexcept {
  return {std::cos(rad), std::sin(rad)};
}

double radians(double degrees) noexcept {
  return degrees * kTau / 360.0;
}

}  // namespace

BlindHand::BlindHand(const StylusPreset& preset, const Person& person, Point start,
                     double heading_rad)
    : hand_(preset, without_eyes(person)),
      random_(person.seed + 0xb11d),
      tick_s_(1e-9 * static_cast<double>(preset.capabilities.period_ns)),
      delayed_(
          std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(kFeelDelayS / tick_s_)))),
      plans_(delayed_.size() + static_cast<std::size_t>(std::lround(kFeelBlurS / tick_s_)), start),
      plan_(start),
      turn_rad_(heading_rad),
      felt_at_(start),
      heard_at_(start) {
  press();
}

Vec BlindHand::heading() const noexcept {
  return unit(turn_rad_);
}

double BlindHand::weave_speed() const noexcept {
  return kWeaveMm * kTau * kWeaveHz * std::cos(kTau * kWeaveHz * weave_s_);
}

void BlindHand::press() noexcept {
  hand_.aim({{plan_.x, plan_.y, -kPressMm}, std::nullopt, 0});
}

/// Updates the force as the person feels it.
void BlindHand::feel() noexcept {
  const Force& force = hand_.stylus().acting_force();
  Vec& oldest = delayed_[tick_ % delayed_.size()];
  const Vec late = oldest;
  oldest = {force.x, force.y};
  plans_[tick_ % plans_.size()] = plan_;
  ++tick_;
  felt_ += tick_s_ / (kFeelBlurS + tick_s_) * (late - felt_);
  const double keep = std::exp(-tick_s_ / kNoiseS);
  const double gain = (kNoiseN + kNoiseShare * norm(felt_)) * std::sqrt(1.0 - keep * keep);
  noise_ = keep * noise_ + gain * Vec{random_.normal(), random_.normal()};
}

void BlindHand::step() noexcept {
  feel();
  switch (state_) {
    case State::kRest:
      rest();
      break;
    case State::kFollow:
      follow();
      break;
    case State::kProbe:
      probe();
      break;
    case State::kReturn:
      go_back();
      break;
    case State::kDone:
      break;
  }
  press();
}

/// Waits after the touch, until a line that attracts the pen is felt.
void BlindHand::rest() noexcept {
  waited_s_ += tick_s_;
  if (waited_s_ >= kRestS) state_ = State::kFollow;
}

void BlindHand::follow() noexcept {
  const Vec force = felt_ + noise_;
  const Vec along = heading(), across = perp(along);
  const double aside = dot(force, across), ahead = dot(force, along), all = norm(force);
  weave_s_ += tick_s_;
  const double speed = std::max(kMinSpeed, kSpeed * (1.0 - std::min(1.0, all / kSlowingN)));
  turn_rad_ += tick_s_ * kTurnPerN * aside;
  plan_ += tick_s_ * (speed * along + (kYieldPerN * aside + weave_speed()) * across);
  side_ += tick_s_ / (0.4 + tick_s_) * (aside - side_);
  // The force of now belongs to the plan of then.
  if (std::abs(aside) > kFeltN) felt_at_ = plans_[tick_ % plans_.size()];
  held_back_s_ = ahead < -kHeldBackN ? held_back_s_ + tick_s_ : 0.0;
  nothing_s_ = all < kNothingN ? nothing_s_ + tick_s_ : std::max(0.0, nothing_s_ - tick_s_);
  strongest_n_ = std::max(all, strongest_n_ - kForgetNPerS * tick_s_);
  if (held_back_s_ > kHeldBackS) {
    return start_probing(plan_ + force / (kMPerMm * hand_.person().arm_n_per_m));
  }
  off_line_s_ = hears_line_ ? 0.0 : off_line_s_ + tick_s_;
  if (hears_line_) heard_at_ = plans_[tick_ % plans_.size()];
  if (off_line_s_ > kHeardS) return start_probing(heard_at_);
  const bool has_slipped = strongest_n_ > kStrongN && all < kGoneShare * strongest_n_;
  if (has_slipped || nothing_s_ > kNothingS) start_probing(felt_at_);
}

void BlindHand::start_probing(Point from) noexcept {
  anchor_ = from;
  first_rad_ = turn_rad_;
  probe_ = round_ = 0;
  waited_s_ = held_back_s_ = nothing_s_ = strongest_n_ = off_line_s_ = 0.0;
  state_ = State::kReturn;
}

/// Moves back to the point from which the person probes, and waits until its force is felt.
void BlindHand::go_back() noexcept {
  const double away = distance(plan_, anchor_);
  const double step = kBackSpeed * tick_s_;
  plan_ = away <= step ? anchor_ : plan_ + (step / away) * (anchor_ - plan_);
  if (away > step) return;
  waited_s_ += tick_s_;
  if (waited_s_ < kFeelAgainS) return;
  if (probe_ == kProbesDeg.size()) {
    probe_ = 0;
    ++round_;
  }
  if (round_ == kRoundsDeg.size() || (round_ > 0 && hears_end_)) {
    state_ = State::kDone;
    return;
  }
  // First to the side from which the last force came.
  const double side = side_ < 0.0 ? -1.0 : 1.0;
  turn_rad_ = first_rad_ + side * radians(kProbesDeg[probe_] + kRoundsDeg[round_]);
  probed_mm_ = held_back_s_ = aside_n_ = weave_s_ = 0.0;
  state_ = State::kProbe;
}

/// Moves on in the direction of this probe until the pen is held back or the probe is long enough.
void BlindHand::probe() noexcept {
  const Vec force = felt_ + noise_;
  const Vec along = heading(), across = perp(along);
  weave_s_ += tick_s_;
  plan_ += tick_s_ * (kProbeSpeed * along + weave_speed() * across);
  probed_mm_ += kProbeSpeed * tick_s_;
  held_back_s_ = dot(force, along) < -kProbeHeldN ? held_back_s_ + tick_s_ : 0.0;
  // Only what is felt in the second half belongs to the direction of the probe.
  if (probed_mm_ > 0.5 * kProbeMm) aside_n_ = std::max(aside_n_, std::abs(dot(force, across)));
  const bool is_held_back = held_back_s_ > 0.5 * kHeldBackS;
  if (!is_held_back && probed_mm_ < kProbeMm) return;
  if (is_held_back || aside_n_ < kProbeFeltN || !hears_line_) {
    ++probe_;
    waited_s_ = 0.0;
    state_ = State::kReturn;
    return;
  }
  state_ = State::kFollow;
  felt_at_ = plan_;
  held_back_s_ = nothing_s_ = strongest_n_ = side_ = 0.0;
}

}  // namespace felt
