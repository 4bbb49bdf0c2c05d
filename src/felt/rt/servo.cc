// The tick. Everything here runs on the haptic thread; tests/devices/rt inspects the symbols of
// this object file.
#include "felt/rt/servo.h"

#include <algorithm>

#include "felt/haptics/safety/safety_guards.h"
#include "felt/rt/float_mode.h"
#include "felt/rt/leap_filter.h"
#include "felt/rt/realtime_scope.h"

namespace felt {
namespace {

Slopes scaled(double s, const Slopes& a) noexcept {
  return {s * a.normal_n_per_m, s * a.friction_n_per_m, s * a.lateral_n_per_m};
}

}  // namespace

const TickReport& Servo::step(std::int64_t now_ns) noexcept FELT_NONBLOCKING {
  const RealtimeScope scope;
  const FlushDenormals flush;
  take_orders();
  const std::int64_t period_ns = options_.period_ns;
  const std::int64_t interval_ns = last_tick_ns_ == kNever ? period_ns : now_ns - last_tick_ns_;
  last_tick_ns_ = now_ns;
  stats_.tick(now_ns, interval_ns - period_ns, period_ns);
  report_.dt_s = chain_.begin(now_ns);
  follow_strength();
  sense_and_act(now_ns);
  report_.safety = chain_.report();
  hand_over();
  return report_;
}

void Servo::stop() noexcept {
  disarm_asked_.store(false, std::memory_order_relaxed);
  chain_.disarm();
  if (!device_.write(Force{})) chain_.device_failed();
  device_.stop();
  report_.asked = {};
  report_.sent = {};
  report_.safety = chain_.report();
  reports_.publish(report_);
}

void Servo::take_orders() noexcept {
  // disarm() is handled first, so that the force rises from zero if both disarm() and arm() were
  // called since the last tick.
  if (disarm_asked_.exchange(false, std::memory_order_acquire)) chain_.disarm();
  if (arm_asked_.exchange(false, std::memory_order_acquire)) chain_.arm();
  const std::int64_t received_ns = heartbeat_ns_.load(std::memory_order_acquire);
  if (received_ns != received_ns_) {
    received_ns_ = received_ns;
    chain_.heartbeat(received_ns);
  }
}

void Servo::sense_and_act(std::int64_t now_ns) noexcept {
  const auto sample = device_.read(now_ns);
  report_.sample_ok = false;
  report_.asked = {};
  report_.sent = {};
  report_.terms.clear();
  if (!sample) {
    chain_.device_failed();
    // The device has already failed, so errors are ignored. If these calls still work, they help to
    // release the device.
    static_cast<void>(device_.write(Force{}));
    device_.stop();
    return;
  }
  report_.sample = *sample;
  report_.sample_ok = chain_.admit(*sample);
  if (report_.sample_ok) report_.asked = report_.strength * evaluate(*sample);
  report_.sent = chain_.limit(report_.asked, *sample);
  if (device_.write(report_.sent)) {
    report_.sent = device_.held_force().value_or(report_.sent);
  } else {
    chain_.device_failed();
    device_.stop();
    report_.sent = {};
  }
  if (!has_force_) hand_over_between();
  hand_over_ink(*sample, now_ns);
}

// The LeapFilter of an arm also gets the samples that the safety chain rejected, because it must
// detect the jumps.
void Servo::hand_over_ink(const PenSample& sample, std::int64_t now_ns) noexcept {
  if (!is_finite(sample)) return;
  if (is_arm_) {
    const std::optional<PenSample> passed = leaps_->pass(sample, now_ns);
    if (passed) hand_over(*passed);
    report_.ink_cuts = leaps_->cuts();
  } else if (report_.sample_ok || !has_force_) {
    hand_over(sample);
  }
}

void Servo::hand_over(const PenSample& sample) noexcept {
  edit_ring_.push(sample);
  autosave_ring_.push(sample);
}

void Servo::hand_over_between() noexcept {
  for (int i = 0; i < kMaxBetween; ++i) {
    const std::optional<PenSample> sample = device_.between();
    if (!sample) return;
    if (is_finite(*sample)) hand_over(*sample);
  }
}

void Servo::follow_strength() noexcept {
  const double asked = strength_asked_.load(std::memory_order_relaxed);
  const double step = report_.dt_s / kStrengthRampS;
  report_.strength = std::clamp(asked, report_.strength - step, report_.strength + step);
}

void Servo::take_model() noexcept {
  model_waits_ = models_.update() || model_waits_;
  if (!model_waits_) return;
  const NumberedModel& next = models_.get();
  if (next.model.fade_id() != current_.model.fade_id()) {
    // At most two models are evaluated. A third model waits until the first has faded out, so that
    // the force stays continuous and the duration of a tick is bounded.
    if (fade_ < 1.0) return;
    outgoing_ = current_;
    outgoing_memory_ = memory_;
    fade_ = options_.cross_fade_s > 0.0 ? 0.0 : 1.0;
  }
  current_ = next;
  model_waits_ = false;
}

// During a cross-fade both models are evaluated, each with its own memory. Both get the same share
// of the stiffness budget, which depends on their weighted slopes.
Force Servo::evaluate(PenSample sample) noexcept {
  // Converts the time from the loop's clock, which starts with the loop, to session time. Uses
  // unsigned numbers, because a device may report any time and the sum may wrap around.
  sample.time_ns = static_cast<std::int64_t>(static_cast<std::uint64_t>(sample.time_ns) +
                                             static_cast<std::uint64_t>(session_offset_ns()));
  if (fade_ < 1.0) fade_ = std::min(1.0, fade_ + report_.dt_s / options_.cross_fade_s);
  take_model();  // after fade_ has changed, so that a fade starts with the old force alone
  const bool fading = fade_ < 1.0;
  const Slopes slopes = fading ? scaled(fade_, current_.model.slopes()) +
                                     scaled(1.0 - fade_, outgoing_.model.slopes())
                               : current_.model.slopes();
  const StiffnessScale scale = chain_.budget(slopes);
  const Force force = force_of(current_.model, sample, scale, memory_);
  report_.terms = memory_.terms;
  report_.solid = memory_.solid;
  if (!fading) return force;
  return fade_ * force + (1.0 - fade_) * force_of(outgoing_.model, sample, scale, outgoing_memory_);
}

Force Servo::force_of(const ForceModel& model, const PenSample& sample, const StiffnessScale& scale,
                      ForceMemory& memory) const noexcept {
  memory.begin_tick(report_.dt_s);
  memory.period_s = 1e-9 * static_cast<double>(options_.period_ns);
  memory.scale = scale;
  memory.material_cap_n_per_m = options_.limits.max_stiffness_n_per_m;
  return model(sample, memory);
}

void Servo::hand_over() noexcept {
  if (force_ring_ && report_.sample_ok) {
    force_ring_->push({report_.sample.time_ns, report_.asked, report_.sent});
  }
  oldest_in_use_.store(fade_ < 1.0 ? outgoing_.number : current_.number, std::memory_order_release);
  reports_.publish(report_);
}

}  // namespace felt
