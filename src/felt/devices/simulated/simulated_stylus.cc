#include "felt/devices/simulated/simulated_stylus.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/devices/simulated/aim_track.h"
#include "felt/devices/simulated/gliding_aim.h"
#include "felt/devices/simulated/held_body.h"
#include "felt/devices/simulated/landing_wait.h"
#include "felt/geometry/tilt.h"
#include "felt/rt/spsc_ring.h"

namespace felt {
namespace {

constexpr std::int64_t kStepNs = 250'000;
constexpr std::int64_t kLongestNs = 100'000'000;
constexpr double kStartHeightMm = 20.0;
constexpr double kAimBeyondMm = 100.0;

// Returns the aim for a device. If the device has a body, the aim's speed is limited like a hand's.
GlidingAim aim_for(const Capabilities& device) noexcept {
  return GlidingAim(device.has_force() ? GlidingAim::kHandSpeedMmPerS : 0.0);
}

Vec3 clamped(const Vec3& p, const Vec3& low, const Vec3& high) noexcept {
  return {std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y),
          std::clamp(p.z, low.z, high.z)};
}

double rounded(double value, double step) noexcept {
  return step > 0.0 ? step * std::floor(value / step + 0.5) : value;
}

// Returns the height of the pen of a grip that does not move up and down.
double height_of(const Aim& aim, const Capabilities& device) noexcept {
  const double pressure = aim.pressure.value_or(0.0);
  return pressure > 0.0 ? pressure * device.workspace_min.z : device.workspace_max.z;
}

Vec3 start_of(const Capabilities& device) noexcept {
  const Vec3 middle = 0.5 * (device.workspace_min + device.workspace_max);
  return clamped({middle.x, middle.y, kStartHeightMm}, device.workspace_min, device.workspace_max);
}

}  // namespace

/// The simulated body, and the aims that were not played yet.
struct SimulatedStylus::Parts {
  explicit Parts(const StylusPreset& preset)
      : body(preset.mechanics, preset.capabilities.workspace_min,
             preset.capabilities.workspace_max),
        aim(aim_for(preset.capabilities)),
        track(preset.capabilities.has_force() ? AimTrack::Play::kPaced : AimTrack::Play::kJoined) {}

  HeldBody body;
  SpscRing<StampedAim, kWaitingAims> queue;
  GlidingAim aim;
  AimTrack track;
  LandingWait landing;
};

SimulatedStylus::SimulatedStylus(const StylusPreset& preset,
                                 const std::optional<SimulatedHand>& hand)
    : preset_(preset),
      has_body_(preset.capabilities.has_force()),
      is_flat_(has_body_ && preset.has_trigger),
      parts_(std::make_unique<Parts>(preset)),
      delay_ticks_(static_cast<std::size_t>(
          std::clamp(preset.capabilities.delay_ticks, 0, kMaxDelayTicks))) {
  preset_.capabilities.delay_ticks = static_cast<int>(delay_ticks_);
  parts_->body.hold(hand);
  parts_->body.place(start_of(preset.capabilities));
}

SimulatedStylus::~SimulatedStylus() = default;

void SimulatedStylus::hold(const std::optional<SimulatedHand>& hand) noexcept {
  parts_->body.hold(hand);
}

const HeldBody& SimulatedStylus::body() const noexcept {
  return parts_->body;
}

Vec3 SimulatedStylus::hand_aim() const noexcept {
  return is_timed_ && !has_body_ ? parts_->body.position() : parts_->aim.at(now_ns_);
}

void SimulatedStylus::aim(const Aim& aim) noexcept {
  push_aim({aim, StampedAim::kNow});
}

void SimulatedStylus::push_aim(const StampedAim& stamped) noexcept {
  Aim aim = stamped.aim;
  if (!is_finite(aim.target_mm)) return;
  if (aim.pressure) {
    aim.pressure = std::isnan(*aim.pressure) ? std::nullopt
                                             : std::optional(std::clamp(*aim.pressure, 0.0, 1.0));
  }
  aim.tilt_deg = checked_tilt(aim.tilt_deg);
  const Capabilities& device = preset_.capabilities;
  constexpr Vec3 kBeyond{kAimBeyondMm, kAimBeyondMm, kAimBeyondMm};
  aim.target_mm =
      clamped(aim.target_mm, device.workspace_min - kBeyond, device.workspace_max + kBeyond);
  parts_->queue.push({aim, stamped.time_ns});
}

void SimulatedStylus::aim_at(std::int64_t time_ns, const Aim& aim) noexcept {
  push_aim({aim, std::max(time_ns, StampedAim::kNow + 1)});
}

void SimulatedStylus::place(const Vec3& position_mm) noexcept {
  parts_->body.place(position_mm);
  velocity_.reset();
  parts_->aim = aim_for(preset_.capabilities);
  parts_->aim.set({.target_mm = parts_->body.position()}, now_ns_, 0);
  parts_->track.clear();
  parts_->landing = {};
  is_timed_ = false;
}

void SimulatedStylus::take_untimed(const Aim& next, std::optional<Aim>& taken) noexcept {
  if (std::exchange(is_timed_, false)) {
    parts_->track.clear();
    parts_->landing = {};
    if (!has_body_) parts_->aim = aim_for(preset_.capabilities);
  }
  if (taken && changes_contact(*taken, next)) {
    waiting_ = next;
  } else {
    taken = next;
  }
}

void SimulatedStylus::take_aims(std::int64_t now_ns, std::int64_t tick_ns) noexcept {
  std::optional<Aim> taken = std::exchange(waiting_, std::nullopt);
  StampedAim next;
  for (std::size_t n = 0; n < kWaitingAims; ++n) {
    if (waiting_ || !parts_->track.has_room() || !parts_->queue.pop(next)) break;
    if (next.time_ns == StampedAim::kNow) {
      take_untimed(next.aim, taken);
    } else {
      parts_->track.push(next, now_ns);
      is_timed_ = true;
    }
  }
  while (is_timed_ && has_body_) {
    const Aim* due = parts_->track.due(now_ns);
    if (!due || (taken && changes_contact(*taken, *due))) break;
    GlidingAim& aim = parts_->aim;
    if (aim.is_set() && parts_->landing.holds(*due, parts_->track.late_ns(now_ns), parts_->body,
                                              now_ns_, tick_ns, aim)) {
      parts_->track.hold(now_ns);
      break;
    }
    taken = *due;
    parts_->track.pass();
  }
  if (!taken) return;
  if (!parts_->aim.is_set()) parts_->body.place(taken->target_mm);
  parts_->aim.set(*taken, now_ns_, tick_ns);
}

Force SimulatedStylus::next_force(std::int64_t now_ns) noexcept {
  // A loop whose ticks come a little early is not slower for that.
  const std::int64_t least_ns = preset_.force_hold_ns - preset_.force_hold_ns / 8;
  if (now_ns - accepted_ns_ >= least_ns || now_ns < accepted_ns_) {
    accepted_ = asked_;
    accepted_ns_ = now_ns;
  }
  delayed_[tick_ % delayed_.size()] = accepted_;
  const Force& then = delayed_[(tick_ + delayed_.size() - delay_ticks_) % delayed_.size()];
  ++tick_;
  return then;
}

void SimulatedStylus::move_to(std::int64_t now_ns) noexcept {
  if (!parts_->aim.is_set()) parts_->aim.set({.target_mm = parts_->body.position()}, now_ns_, 0);
  const std::int64_t end_ns = std::min(now_ns, now_ns_ + kLongestNs);
  if (has_body_) {
    const std::int64_t steps = (end_ns - now_ns_ + kStepNs - 1) / kStepNs;
    const double h_s = 1e-9 * static_cast<double>(end_ns - now_ns_) / static_cast<double>(steps);
    const auto aim_at = [&](std::int64_t step) {
      Vec3 aim_mm = parts_->aim.at(now_ns_ + (end_ns - now_ns_) * step / steps);
      if (is_flat_) aim_mm.z = parts_->body.position().z;
      return aim_mm;
    };
    Vec3 from = aim_at(0);
    for (std::int64_t i = 1; i <= steps; ++i) {
      const Vec3 to = aim_at(i);
      parts_->body.step(h_s, from, to, acting_);
      from = to;
    }
  } else {
    parts_->body.place(parts_->aim.at(now_ns));
  }
  now_ns_ = now_ns;
}

PenSample SimulatedStylus::sense(double dt_s) noexcept {
  const double step = preset_.capabilities.position_step_mm;
  const Aim& shown = parts_->aim.shown(now_ns_);
  if (is_flat_) parts_->body.set_height(height_of(shown, preset_.capabilities));
  const Vec3& p = parts_->body.position();
  PenSample sample;
  sample.time_ns = sampled_ns_ = now_ns_;
  sample.position = {rounded(p.x, step), rounded(p.y, step), is_flat_ ? p.z : rounded(p.z, step)};
  Vec3 moved = sample.position;
  if (is_flat_) moved.z = 0.0;  // a pen that goes down does not fall
  sample.velocity = velocity_.update(moved, dt_s);
  sample.pressure = shown.pressure;
  sample.buttons = shown.buttons;
  sample.tilt_deg = shown.tilt_deg;
  return sample;
}

PenSample SimulatedStylus::sample_of(const Aim& aim, std::int64_t time_ns) noexcept {
  const double dt_s = 1e-9 * static_cast<double>(time_ns - sampled_ns_);
  sampled_ns_ = time_ns;
  parts_->body.place(aim.target_mm);
  PenSample sample;
  sample.time_ns = time_ns;
  sample.position = parts_->body.position();
  sample.velocity = velocity_.update(sample.position, dt_s);
  sample.pressure = aim.pressure;
  sample.buttons = aim.buttons;
  sample.tilt_deg = aim.tilt_deg;
  return sample;
}

/// Returns every due aim as a sample of its own. If no aim is due, returns a sample between the
/// last aim and the next.
PenSample SimulatedStylus::read_track(std::int64_t now_ns) noexcept {
  std::array<Aim, kMaxSamples> aims;
  std::array<std::int64_t, kMaxSamples> times_ns{};
  std::size_t count = 0;
  for (const Aim* due = nullptr; count < kMaxSamples && (due = parts_->track.due(now_ns));
       ++count) {
    aims[count] = *due;
    times_ns[count] = parts_->track.due_ns();
    parts_->track.pass();
  }
  if (count == 0) return sample_of(parts_->track.at(now_ns), now_ns);
  // Each sample gets the time of its aim if that time lies between the last sample and now;
  // otherwise the time is moved into that range.
  const std::int64_t half_ns = (now_ns - sampled_ns_) / (2 * static_cast<std::int64_t>(count) + 2);
  for (std::size_t i = 0; i < count; ++i) {
    const auto after = static_cast<std::int64_t>(count - 1 - i);
    const std::int64_t time_ns =
        std::clamp(times_ns[i], sampled_ns_ + half_ns, now_ns - after * half_ns);
    between_[i] = sample_of(aims[i], time_ns);
  }
  between_next_ = 0;
  between_end_ = count - 1;
  return between_[between_end_];
}

std::optional<PenSample> SimulatedStylus::between() noexcept {
  if (between_next_ == between_end_) return std::nullopt;
  return between_[between_next_++];
}

tl::expected<PenSample, DeviceFault> SimulatedStylus::read(std::int64_t now_ns) noexcept {
  if (!started_) {
    started_ = true;
    now_ns_ = sampled_ns_ = now_ns;
  }
  between_next_ = between_end_ = 0;
  const std::int64_t elapsed_ns = std::max<std::int64_t>(now_ns - now_ns_, 0);
  take_aims(now_ns, elapsed_ns);
  acting_ = next_force(now_ns);
  if (is_timed_ && !has_body_ && now_ns >= now_ns_) {
    now_ns_ = now_ns;
    return read_track(now_ns);
  }
  if (elapsed_ns > 0) {
    move_to(now_ns);
  } else if (now_ns < now_ns_) {
    now_ns_ = now_ns;
    parts_->aim.restart(now_ns);
    parts_->track.clear();
    parts_->landing = {};
    is_timed_ = false;
  }
  return sense(1e-9 * static_cast<double>(elapsed_ns));
}

tl::expected<void, DeviceFault> SimulatedStylus::write(const Force& force) noexcept {
  if (!is_finite(force)) {
    stop();
    return tl::unexpected(DeviceFault::kBadData);
  }
  const double largest = preset_.capabilities.max_force_n;
  asked_ = force;
  if (is_flat_) asked_.z = 0.0;
  const double size = norm(asked_);
  if (size > largest) asked_ = (largest / size) * asked_;
  return {};
}

void SimulatedStylus::stop() noexcept {
  asked_ = accepted_ = {};
  delayed_.fill({});
}

}  // namespace felt
