#include "felt/devices/simulated/feedback_hand.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "felt/base/constants.h"
#include "felt/devices/simulated/held_body.h"

namespace felt {
namespace {

constexpr double kSeenS = 0.1;        // how early or late the pen may be for its error to be seen
constexpr double kPlanLookS = 0.008;  // window for the speed and acceleration of the plan
constexpr std::int64_t kMaxGapNs = 100 * kMs;
constexpr double kEyeNoiseS = 0.2;  // correlation time of the perceived position's error
constexpr double kForgetS = 0.1;    // time constant of the correction's decay in the air
constexpr double kMaxTurn = 4.0;  // radians/s: the correction turns with the path up to this speed
constexpr double kLearnS = 0.3;   // time constant of learning a load
constexpr double kLearnFromMmPerS = 5.0;  // a slower movement has no reliable direction
constexpr double kKnownFromMmPerS = 1.0;
constexpr double kContactN = 0.05;  // force of a surface that is felt as contact
constexpr double kTouchS = 0.05;    // time constant of the feeling of contact
constexpr double kTremorHz[] = {8.0, 12.0};
constexpr double kWanderHz[] = {0.4, 2.5};

bool presses(const Aim& aim) noexcept {
  return aim.target_mm.z < 0.0 || aim.pressure.value_or(0.0) > 0.0;
}

// Moves `value` towards `target` with a first-order low-pass filter.
void low_pass(Vec& value, Vec target, double time_s, double step_s) noexcept {
  value += step_s / (time_s + step_s) * (target - value);
}

std::size_t ticks(double time_s, double tick_s) noexcept {
  return static_cast<std::size_t>(std::lround(std::max(0.0, time_s) / tick_s));
}

// Tones with an RMS of 1, from random numbers of their own.
Tones depth_tones(const Person& person) noexcept {
  Random random(person.seed ^ 0x9e3779b97f4a7c15ULL);
  return {random, kWanderHz[0], kWanderHz[1], 1.0};
}

}  // namespace

FeedbackHand::FeedbackHand(const StylusPreset& preset, const Person& person)
    : person_(person),
      renders_surface_(preset.renders_surface()),
      stylus_(preset, person.grip()),
      random_(person.seed),
      tremor_(random_, kTremorHz[0], kTremorHz[1], person.tremor_mm),
      wander_(random_, kWanderHz[0], kWanderHz[1], person.wander_mm),
      depth_(depth_tones(person)) {
  tick_s_ = 1e-9 * static_cast<double>(preset.capabilities.period_ns);
  preview_ = std::max<std::size_t>(ticks(person.preview_s, tick_s_), ticks(kPlanLookS, tick_s_));
  eye_delay_ = ticks(person.eye_delay_s, tick_s_);
  arm_delay_ = ticks(person.arm_delay_s, tick_s_);
  const std::size_t size =
      std::bit_ceil(std::max({preview_ + ticks(kSeenS, tick_s_), eye_delay_, arm_delay_}) + 2);
  plan_.resize(size);
  error_.resize(size);
  deviation_.resize(size);
  if (person.knows_friction) load_.x = -preset.mechanics.friction_n;
}

void FeedbackHand::aim(const Aim& aim) noexcept {
  if (is_finite(aim.target_mm)) newest_ = aim;
}

void FeedbackHand::see(std::optional<Vec> error_mm) noexcept {
  if (!error_mm || std::isfinite(norm_squared(*error_mm))) shown_error_ = error_mm;
}

tl::expected<void, DeviceFault> FeedbackHand::write(const Force& force) noexcept {
  return stylus_.write(force);
}

tl::expected<PenSample, DeviceFault> FeedbackHand::read(std::int64_t now_ns) noexcept {
  if (!started_) start(now_ns);
  if (newest_ && !holds_) pick_up();
  const std::int64_t tick_ns = std::llround(1e9 * tick_s_);
  now_ns_ = std::max(now_ns_, now_ns - kMaxGapNs);
  while (now_ns_ + tick_ns <= now_ns) {
    now_ns_ += tick_ns;
    if (holds_) step();
  }
  return stylus_.read(now_ns);
}

void FeedbackHand::start(std::int64_t now_ns) noexcept {
  started_ = true;
  start_ns_ = now_ns_ = now_ns;
}

// Puts the pen at the first aim, at rest.
void FeedbackHand::pick_up() noexcept {
  holds_ = true;
  arm_ = on_page(newest_->target_mm);
  std::fill(plan_.begin(), plan_.end(), *newest_);
  stylus_.aim(*newest_);
}

const Aim& FeedbackHand::planned(std::size_t ticks_ago) const noexcept {
  return plan_[(tick_ - ticks_ago) & (plan_.size() - 1)];
}

Point FeedbackHand::planned_point(std::size_t ticks_ago) const noexcept {
  return on_page(planned(ticks_ago).target_mm);
}

FeedbackHand::Motion FeedbackHand::planned_motion() const noexcept {
  const std::size_t look = std::max<std::size_t>(1, ticks(kPlanLookS, tick_s_));
  const double look_s = tick_s_ * static_cast<double>(look);
  const Point before = planned_point(preview_ + look), now = planned_point(preview_);
  const Point after = planned_point(preview_ - look);
  return {now, (after - before) / (2.0 * look_s),
          ((after - now) - (now - before)) / (look_s * look_s)};
}

// Advances by one tick: the muscles act on the arm, which holds the stylus with the grip.
void FeedbackHand::step() noexcept {
  ++tick_;
  plan_[tick_ & (plan_.size() - 1)] = *newest_;
  error_[tick_ & (error_.size() - 1)] = shown_error_ ? *shown_error_ : error_across();
  const Aim& now = planned(preview_);
  const bool draws = presses(now);
  const Motion motion = planned_motion();
  correct(draws, motion);
  const double t_s = 1e-9 * static_cast<double>(now_ns_ - start_ns_);
  const Vec wander = wander_.at(t_s) + tremor_.at(t_s);
  const Vec known_load = draws ? expected_load(motion.velocity) : Vec{};
  lead(known_load);
  feel_contact(now.pressure.value_or(0.0) > 0.0);
  const Vec off = motion.position + wander + offset_ + lead_ - arm_;
  const Vec off_speed = motion.velocity + offset_speed_ + lead_speed_ - arm_velocity_;
  deviation_[tick_ & (deviation_.size() - 1)] = off;

  const Vec load = load_at_pen();
  if (draws) learn_load(load, motion.velocity);
  const double rest = 1.0 + touch_ * (person_.rest - 1.0);
  const Vec stiffness_n = kMPerMm * (rest * person_.arm_n_per_m * off +
                                     std::sqrt(rest) * person_.arm_n_s_per_m * off_speed);
  const Vec plan_n =
      kMPerMm * person_.arm_kg * (motion.acceleration + lead_acceleration_) - known_load;
  const Vec late_n =
      kMPerMm * person_.reflex_n_per_m * deviation_[(tick_ - arm_delay_) & (deviation_.size() - 1)];
  const Vec noise_n = motor_noise(stiffness_n + plan_n + late_n);
  low_pass(muscle_[0], late_n + noise_n, person_.muscle_lag_s, tick_s_);
  low_pass(muscle_[1], muscle_[0], person_.muscle_lag_s, tick_s_);

  const Vec force = stiffness_n + plan_n + muscle_[1] + load;
  arm_velocity_ += tick_s_ / (kMPerMm * person_.arm_kg) * force;
  arm_ += tick_s_ * arm_velocity_;
  const double z = now.target_mm.z + depth_noise_mm(t_s);
  stylus_.aim({{arm_.x, arm_.y, z}, now.pressure, now.buttons, now.tilt_deg});
}

// On a device without forces out of the page, the surface under the pen or its grip holds it.
void FeedbackHand::feel_contact(bool presses) noexcept {
  const bool is_held = renders_surface_ ? stylus_.acting_force().z > kContactN : presses;
  const double feels = is_held ? 1.0 : 0.0;
  touch_ += tick_s_ / (kTouchS + tick_s_) * (feels - touch_);
}

// Slow noise of the height in the air, and of the force of the fingers on a surface.
double FeedbackHand::depth_noise_mm(double t_s) const noexcept {
  const double press_n =
      person_.press_noise_n + person_.press_noise * std::max(0.0, stylus_.acting_force().z);
  const double pressed_mm = press_n / (kMPerMm * person_.grip().stiffness_n_per_m);
  return ((1.0 - touch_) * person_.depth_mm + touch_ * pressed_mm) * depth_.at(t_s).x;
}

// The arm goes ahead of the pen by as much as spring and damper of the fingers yield to the load.
// Who knows the friction also knows how this changes in a curve.
void FeedbackHand::lead(Vec known_load) noexcept {
  const SimulatedHand grip = person_.grip();
  const Vec target = Vec{} - known_load / (kMPerMm * grip.stiffness_n_per_m);
  if (!person_.knows_friction) {
    lead_ = target;
    return;
  }
  const double lag_s = grip.damping_n_s_per_m / grip.stiffness_n_per_m;
  const Vec speed = 1.0 / (lag_s + tick_s_) * (target - lead_);
  lead_acceleration_ = 1.0 / tick_s_ * (speed - lead_speed_);
  lead_speed_ = speed;
  lead_ += tick_s_ * speed;
}

// White noise, constant and in proportion to the force of the muscles (Sutton, Sykes, J Physiol
// 191, 1967; Harris, Wolpert, Nature 394, 1998). The lags of the muscles turn it into a force with
// this standard deviation.
Vec FeedbackHand::motor_noise(Vec muscles_n) noexcept {
  const double lag_s = person_.muscle_lag_s;
  const double deviation_n = person_.force_noise_n + person_.motor_noise * norm(muscles_n);
  const double gain = deviation_n * std::sqrt(4.0 * lag_s / tick_s_);
  return gain * Vec{random_.normal(), random_.normal()};
}

// The force of the stylus on the arm: that of the fingers' spring and damper, N.
Vec FeedbackHand::load_at_pen() const noexcept {
  if (!capabilities().has_force()) return {};
  const SimulatedHand grip = person_.grip();
  const Vec3& body = stylus_.body().position();
  const Vec3& speed = stylus_.body().velocity();
  return kMPerMm * (grip.stiffness_n_per_m * (on_page(body) - arm_) +
                    grip.damping_n_s_per_m * (Vec{speed.x, speed.y} - arm_velocity_));
}

// Learns the load along and across the movement.
void FeedbackHand::learn_load(Vec load, Vec velocity) noexcept {
  if (norm(velocity) < kLearnFromMmPerS) return;
  const Vec along = normalized(velocity);
  low_pass(load_, {dot(load, along), dot(load, perp(along))}, kLearnS, tick_s_);
}

Vec FeedbackHand::expected_load(Vec velocity) const noexcept {
  const Vec along = normalized(velocity);
  const double from = person_.knows_friction ? kKnownFromMmPerS : kLearnFromMmPerS;
  const double moves = norm(velocity) / (norm(velocity) + from);
  return moves * person_.load_share * (load_.x * along + load_.y * perp(along));
}

// Corrects the plan by the error that the eye sees; forgets the correction in the air. In a curve
// the correction turns with the path, because what is constant is the error across the path.
void FeedbackHand::correct(bool draws, const Motion& motion) noexcept {
  const double keep = std::exp(-tick_s_ / kEyeNoiseS);
  const double gain = person_.eye_noise_mm * std::sqrt(1.0 - keep * keep);
  eye_noise_ = keep * eye_noise_ + gain * Vec{random_.normal(), random_.normal()};
  Vec wanted;
  if (draws) {
    const Vec seen = error_[(tick_ - eye_delay_) & (error_.size() - 1)];
    wanted = -person_.eye_gain_per_s * (seen + eye_noise_);
  } else {
    wanted = -1.0 / kForgetS * offset_;
  }
  low_pass(lagging_, wanted, person_.muscle_lag_s, tick_s_);
  low_pass(offset_speed_, lagging_, person_.muscle_lag_s, tick_s_);
  const double speed = norm(motion.velocity);
  if (draws && speed > kLearnFromMmPerS) {
    const double turn = cross(motion.velocity, motion.acceleration) / (speed * speed);
    offset_ += tick_s_ * std::clamp(turn, -kMaxTurn, kMaxTurn) * perp(offset_);
  }
  offset_ += tick_s_ * offset_speed_;
}

// Returns how far the pen is from the nearest planned position. While the plan moves, only across
// the path, because a pen that is early or late makes no error in the drawing.
Vec FeedbackHand::error_across() noexcept {
  const Point pen = on_page(stylus_.body().position());
  const std::size_t newest = preview_ - std::min(preview_ - 1, ticks(kSeenS, tick_s_));
  const std::size_t oldest = preview_ + ticks(kSeenS, tick_s_);
  std::size_t nearest = std::clamp(match_, newest, oldest);
  double best = distance(pen, planned_point(nearest));
  const auto try_to = [&](std::size_t at) {
    const double away = distance(pen, planned_point(at));
    if (away > best) return false;
    best = away;
    nearest = at;
    return true;
  };
  for (std::size_t at = nearest; at > newest && try_to(at - 1);) --at;
  for (std::size_t at = nearest; at < oldest && try_to(at + 1);) ++at;
  match_ = nearest;
  const Vec off = pen - planned_point(nearest);
  const Vec along = normalized(planned_point(nearest - 1) - planned_point(nearest + 1));
  return along == Vec{} ? off : dot(off, perp(along)) * perp(along);
}

}  // namespace felt
