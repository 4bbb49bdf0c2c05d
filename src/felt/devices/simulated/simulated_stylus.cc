#include "felt/devices/simulated/simulated_stylus.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace felt {
namespace {

constexpr std::int64_t kStepNs = 250'000;
constexpr std::int64_t kLongestNs = 100'000'000;
constexpr double kStartHeightMm = 20.0;
constexpr double kAimBeyondMm = 100.0;

// The aim of a device that has a body is that of a hand, which takes its time.
MovingAim aim_for(const Capabilities& device) noexcept {
  return MovingAim(device.has_force() ? MovingAim::kHandSpeedMmPerS : 0.0);
}

Vec3 clamped(const Vec3& p, const Vec3& low, const Vec3& high) noexcept {
  return {std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y),
          std::clamp(p.z, low.z, high.z)};
}

double rounded(double value, double step) noexcept {
  return step > 0.0 ? step * std::floor(value / step + 0.5) : value;
}

Vec3 start_of(const Capabilities& device) noexcept {
  const Vec3 middle = 0.5 * (device.workspace_min + device.workspace_max);
  return clamped({middle.x, middle.y, kStartHeightMm}, device.workspace_min, device.workspace_max);
}

}  // namespace

SimulatedStylus::SimulatedStylus(const StylusPreset& preset,
                                 const std::optional<SimulatedHand>& hand)
    : preset_(preset),
      body_(preset.mechanics, preset.capabilities.workspace_min, preset.capabilities.workspace_max),
      aim_(aim_for(preset.capabilities)),
      delay_ticks_(static_cast<std::size_t>(
          std::clamp(preset.capabilities.delay_ticks, 0, kMostDelayTicks))) {
  preset_.capabilities.delay_ticks = static_cast<int>(delay_ticks_);
  body_.hold(hand);
  body_.place(start_of(preset.capabilities));
}

void SimulatedStylus::aim(const Vec3& target_mm, std::optional<double> pressure,
                          std::uint32_t buttons) noexcept {
  if (!is_finite(target_mm)) return;
  if (pressure) {
    pressure =
        std::isnan(*pressure) ? std::nullopt : std::optional(std::clamp(*pressure, 0.0, 1.0));
  }
  const Capabilities& device = preset_.capabilities;
  constexpr Vec3 kBeyond{kAimBeyondMm, kAimBeyondMm, kAimBeyondMm};
  queue_.push({clamped(target_mm, device.workspace_min - kBeyond, device.workspace_max + kBeyond),
               pressure, buttons});
}

void SimulatedStylus::place(const Vec3& position_mm) noexcept {
  body_.place(position_mm);
  velocity_.reset();
  aim_ = aim_for(preset_.capabilities);
  aim_.set({.target_mm = body_.position()}, now_ns_, 0);
}

void SimulatedStylus::take_aims(std::int64_t tick_ns) noexcept {
  std::optional<Aim> taken = std::exchange(waiting_, std::nullopt);
  Aim next;
  for (std::size_t n = 0; n < kWaitingAims && queue_.pop(next); ++n) {
    if (taken && changes_contact(*taken, next)) {
      waiting_ = next;
      break;
    }
    taken = next;
  }
  if (!taken) return;
  if (!aim_.is_set()) body_.place(taken->target_mm);
  aim_.set(*taken, now_ns_, tick_ns);
}

Force SimulatedStylus::next_force() noexcept {
  delayed_[tick_ % delayed_.size()] = asked_;
  const Force& then = delayed_[(tick_ + delayed_.size() - delay_ticks_) % delayed_.size()];
  ++tick_;
  return then;
}

void SimulatedStylus::move_to(std::int64_t now_ns) noexcept {
  if (!aim_.is_set()) aim_.set({.target_mm = body_.position()}, now_ns_, 0);
  const std::int64_t end_ns = std::min(now_ns, now_ns_ + kLongestNs);
  if (preset_.capabilities.has_force()) {
    const std::int64_t steps = (end_ns - now_ns_ + kStepNs - 1) / kStepNs;
    const double h_s = 1e-9 * static_cast<double>(end_ns - now_ns_) / static_cast<double>(steps);
    Vec3 from = aim_.at(now_ns_);
    for (std::int64_t i = 1; i <= steps; ++i) {
      const Vec3 to = aim_.at(now_ns_ + (end_ns - now_ns_) * i / steps);
      body_.step(h_s, from, to, acting_);
      from = to;
    }
  } else {
    body_.place(aim_.at(now_ns));
  }
  now_ns_ = now_ns;
}

PenSample SimulatedStylus::sense(double dt_s) noexcept {
  const double step = preset_.capabilities.position_step_mm;
  const Vec3& p = body_.position();
  PenSample sample;
  sample.time_ns = now_ns_;
  sample.position = {rounded(p.x, step), rounded(p.y, step), rounded(p.z, step)};
  sample.velocity = velocity_.update(sample.position, dt_s);
  const Aim& shown = aim_.shown(now_ns_);
  sample.pressure = shown.pressure;
  sample.buttons = shown.buttons;
  return sample;
}

tl::expected<PenSample, DeviceFault> SimulatedStylus::read(std::int64_t now_ns) noexcept {
  if (!started_) {
    started_ = true;
    now_ns_ = now_ns;
  }
  const std::int64_t elapsed_ns = std::max<std::int64_t>(now_ns - now_ns_, 0);
  take_aims(elapsed_ns);
  acting_ = next_force();
  if (elapsed_ns > 0) {
    move_to(now_ns);
  } else if (now_ns < now_ns_) {
    now_ns_ = now_ns;
    aim_.restart(now_ns);
  }
  return sense(1e-9 * static_cast<double>(elapsed_ns));
}

tl::expected<void, DeviceFault> SimulatedStylus::write(const Force& force) noexcept {
  if (!is_finite(force)) {
    stop();
    return tl::unexpected(DeviceFault::kBadData);
  }
  const double most = preset_.capabilities.max_force_n;
  const double size = norm(force);
  asked_ = size > most ? (most / size) * force : force;
  return {};
}

void SimulatedStylus::stop() noexcept {
  asked_ = {};
  delayed_.fill({});
}

}  // namespace felt
