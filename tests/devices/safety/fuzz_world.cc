#include "tests/devices/safety/fuzz_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "felt/base/constants.h"

namespace felt::safety {
namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

FuzzWorld::FuzzWorld(std::uint64_t seed) : random_(seed), body_(random_, {}) {
  const std::uint64_t mood = below(10);
  mood_ = mood < 4 ? Mood::kClean : mood < 8 ? Mood::kRough : Mood::kWild;
  hand_ = static_cast<Hand>(below(static_cast<std::uint64_t>(Hand::kCount)));
  model_ = static_cast<Model>(below(static_cast<std::uint64_t>(Model::kCount)));
  choose_limits();
  const double period_s = 1e-9 * static_cast<double>(limits_.period_ns);
  const double seconds = chance(0.03) ? 14.0 : random_.between(0.7, 3.5);
  ticks_ = static_cast<int>(std::min(seconds / period_s, 20000.0));
  now_ns_ = chance(0.1) ? static_cast<std::int64_t>(random_.bits()) / 2 : 0;
  reports_velocity_ = !chance(0.2);
  amplitude_mm_ = random_.between(0.0, 30.0);
  rate_hz_ = random_.between(0.2, 6.0);
  constant_ = {random_.between(-4, 4), random_.between(-4, 4), random_.between(-4, 4)};
  stiffness_ = std::pow(10.0, random_.between(2.0, 5.0));
  if (hand_ == Hand::kSweep) velocity_ = any_way(random_.between(100.0, 1300.0));
  position_ = last_position_ = {random_.between(-50, 50), random_.between(-50, 50), 1.0};
  body_ = FuzzBody(random_, position_);
  if (mood_ != Mood::kClean && chance(0.6)) {
    lie_ = static_cast<Lie>(below(static_cast<std::uint64_t>(Lie::kCount)));
    frozen_velocity_ = any_way(random_.between(0.0, 900.0));
  }
}

void FuzzWorld::choose_limits() {
  Capabilities device;
  device.max_force_n = random_.between(0.2, 22.0);
  if (chance(0.5)) device.continuous_force_n = random_.between(0.1, 3.0);
  if (chance(0.5)) device.advised_force_n = random_.between(0.2, 8.0);
  if (chance(0.5)) device.max_stiffness_n_per_m = random_.between(100.0, 5000.0);
  if (chance(0.3)) device.max_damping_n_s_per_m = random_.between(0.5, 30.0);
  constexpr std::array<std::int64_t, 6> kPeriods{200'000,   500'000,   1'000'000,
                                                 1'000'000, 1'000'000, 4'000'000};
  device.period_ns = kPeriods.at(below(kPeriods.size()));
  device.delay_ticks = static_cast<int>(below(4));
  limits_ = limits_for(device, chance(0.7) ? 3.0 : random_.between(0.0, 4.0));
}

Vec3 FuzzWorld::any_way(double length) {
  const Vec3 v{random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1)};
  return (length / std::max(norm(v), 1e-3)) * v;
}

std::int64_t FuzzWorld::next_time() {
  const double period_ns = static_cast<double>(limits_.period_ns);
  if (mood_ == Mood::kClean) return now_ns_ + limits_.period_ns;
  double step_ns = period_ns * random_.between(0.8, 1.2);
  const double odds = mood_ == Mood::kRough ? 0.0008 : 0.004;
  if (chance(odds)) {
    constexpr std::array<double, 12> kSteps{0.0,   -1e3, 6e6,    15e6,    25e6, 500e6,
                                            -15e6, -1e9, 3600e9, -3600e9, 1e3,  4.9e6};
    step_ns = kSteps.at(below(kSteps.size()));
  } else if (mood_ == Mood::kWild && chance(0.01)) {
    step_ns = period_ns * random_.between(0.0, 4.0);
  }
  if (mood_ == Mood::kWild && chance(1e-4)) {
    return chance(0.5) ? std::numeric_limits<std::int64_t>::max()
                       : std::numeric_limits<std::int64_t>::min();
  }
  // Resets the time to 0 if the next step could overflow.
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max() / 2;
  if (now_ns_ > kFar || now_ns_ < -kFar) return 0;
  return now_ns_ + static_cast<std::int64_t>(step_ns);
}

void FuzzWorld::orders(const SafetyReport& report, TickInput& in) {
  const double odds = mood_ == Mood::kWild ? 1.0 : mood_ == Mood::kRough ? 0.2 : 0.0;
  in.arm = tick_ == 3 || (report.state == SafetyState::kLatched && chance(0.01)) ||
           (report.state == SafetyState::kOff && tick_ > 3 && chance(0.02)) || chance(0.001 * odds);
  in.disarm = chance(0.0015 * odds);
  in.read_fails = chance(0.0005 * odds);
  in.write_fails = chance(0.0005 * odds);

  if (time_s_ > silent_until_s_ && chance(0.0004)) {
    silent_until_s_ = time_s_ + random_.between(0.3, 3.0);
  }
  if (time_s_ >= next_beat_s_ && time_s_ > silent_until_s_) {
    in.heartbeat_ns = in.now_ns;
    next_beat_s_ = time_s_ + random_.between(0.02, 0.1);
  } else if (chance(0.002 * odds)) {
    in.heartbeat_ns = static_cast<std::int64_t>(random_.bits()) / 4;
  }

  // The model requests no force at first and from time to time while the chain waits, so that the
  // chain can engage. After that, the model requests any force.
  const bool waits = report.state == SafetyState::kWaiting;
  if (tick_ > calm_until_ && (chance(0.0005) || (waits && chance(0.05)))) {
    calm_until_ = tick_ + 8;
  }
}

void FuzzWorld::move_hand(const Force& sent, double dt_s) {
  switch (hand_) {
    case Hand::kStill:
      break;
    case Hand::kPress: {
      const double angle = 2.0 * kPi * rate_hz_ * time_s_;
      const double speed = 2.0 * kPi * rate_hz_ * amplitude_mm_;
      velocity_ = {0.3 * speed * std::cos(angle), 0.0, -speed * std::sin(angle)};
      break;
    }
    case Hand::kWalk:
      velocity_ = 0.98 * velocity_ + any_way(random_.between(0.0, 60.0));
      break;
    case Hand::kSweep:
      if (chance(0.002)) velocity_ = any_way(random_.between(100.0, 2600.0));
      break;
    case Hand::kFree:  // the force moves a body of 45 g on a weak spring
      velocity_ +=
          dt_s * (1e3 / 0.045 * Vec3{sent.x, sent.y, sent.z} - 700.0 * position_ - 7.0 * velocity_);
      break;
    case Hand::kNoise:
      velocity_ = any_way(random_.between(0.0, 400.0));
      break;
    case Hand::kCount:
      break;
  }
  if (frozen_ticks_ > 0) return;
  position_ += std::min(dt_s, 0.03) * velocity_;
}

PenSample FuzzWorld::sense(double dt_s) {
  PenSample sample;
  sample.time_ns = now_ns_;
  sample.position = position_;
  if (jumped_ticks_ > 0) {
    --jumped_ticks_;
    sample.position += jump_;
  }
  if (frozen_ticks_ > 0) --frozen_ticks_;
  if (reports_velocity_ && dt_s > 0.0) sample.velocity = velocity_;
  if (lie_ == Lie::kReversed) sample.velocity = -1.2 * sample.velocity;
  if (lie_ == Lie::kTenfold) sample.velocity = 10.0 * sample.velocity;
  if (lie_ == Lie::kFrozen) sample.velocity = frozen_velocity_;
  spoil(sample);
  last_position_ = sample.position;
  return sample;
}

/// Adds a random sensor fault: an invalid number, a jump, a frozen position or a wrong velocity.
void FuzzWorld::spoil(PenSample& sample) {
  const double odds = mood_ == Mood::kWild ? 0.004 : mood_ == Mood::kRough ? 0.001 : 0.0;
  if (!chance(odds)) return;
  constexpr std::array<double, 8> kOdd{kNan, kInf, -kInf, 1e308, -1e300, 5e-324, 1e6, -1e-310};
  const double odd = kOdd.at(below(kOdd.size()));
  switch (below(9)) {
    case 0:
      sample.position.x = odd;
      break;
    case 1:
      sample.position.z = odd;
      break;
    case 2:
      sample.velocity.y = odd;
      break;
    case 3:
      sample.pressure = odd;
      break;
    case 4:
    case 5:
      jump_ = any_way(std::pow(10.0, random_.between(-1.0, 3.0)));
      jumped_ticks_ = static_cast<int>(below(6));
      break;
    case 6:
      frozen_ticks_ = static_cast<int>(below(300));
      break;
    case 7:
      sample.velocity = any_way(random_.between(0.0, 5000.0));
      break;
    case 8:
      sample.position += any_way(0.5);
      break;
    default:
      break;
  }
}

TickInput FuzzWorld::next(const SafetyReport& report, const Force& sent) {
  const double period_s = 1e-9 * static_cast<double>(limits_.period_ns);
  TickInput in;
  const std::int64_t before_ns = now_ns_;
  if (tick_ > 0) now_ns_ = next_time();
  in.now_ns = now_ns_;
  double dt_s = 1e-9 * (static_cast<double>(now_ns_) - static_cast<double>(before_ns));
  if (!(dt_s >= 0.0 && dt_s < 0.6)) dt_s = period_s;
  time_s_ += dt_s;
  orders(report, in);
  move_hand(sent, dt_s);
  in.sample = sense(dt_s);
  if (chance(0.05)) {
    in.slopes = {random_.between(0, 2000), random_.between(0, 1500), random_.between(0, 1500)};
  } else {
    in.slopes = {500, 600, 300};
  }
  if (mood_ == Mood::kWild && chance(0.001)) constant_ = 2.0 * Force{constant_.y, -constant_.x, 1};
  if (mood_ == Mood::kWild && chance(0.001)) stiffness_ = std::pow(10.0, random_.between(1.0, 6.0));
  ++tick_;
  return in;
}

Force FuzzWorld::asked(const PenSample& sample, const StiffnessScale& scale, double dt_s) {
  if (tick_ <= calm_until_) return {};
  const double odds = mood_ == Mood::kWild ? 0.0005 : mood_ == Mood::kRough ? 0.0001 : 0.0;
  if (chance(odds)) {
    const double odd = chance(0.5) ? std::numeric_limits<double>::quiet_NaN()
                                   : std::numeric_limits<double>::infinity();
    return {0.0, odd, 1.0};
  }
  const Vec3& p = sample.position;
  const Vec3& v = sample.velocity;
  switch (model_) {
    case Model::kNone:
      return {};
    case Model::kConstant:
      return constant_;
    case Model::kPlane:
      return {0.0, 0.0, p.z < 0.0 ? -1e-3 * scale.normal * (500.0 * p.z + 2.0 * v.z) : 0.0};
    case Model::kStiff: {
      const double k = -1e-3 * stiffness_;
      return {k * p.x, k * p.y, k * p.z};
    }
    case Model::kActiveDamper:
      return {0.02 * v.x, 0.02 * v.y, 0.02 * v.z};
    case Model::kRandom:
      return {random_.between(-10, 10), random_.between(-10, 10), random_.between(-10, 10)};
    case Model::kFlip:
      return (tick_ / 8) % 2 == 0 ? constant_ : -constant_;
    case Model::kHuge: {
      const double huge = std::pow(10.0, random_.between(-320.0, 308.0));
      return {huge * constant_.x / 8.0, -huge, chance(0.5) ? huge : 0.0};
    }
    case Model::kBody:
      return body_.asked(sample, scale, dt_s, random_);
    case Model::kCount:
      break;
  }
  return {};
}

}  // namespace felt::safety
