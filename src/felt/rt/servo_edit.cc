// The functions of the servo for the edit thread. They are in a file of their own, so that the
// object file of the tick contains only symbols that the tick uses.
#include <algorithm>
#include <cmath>

#include "felt/rt/leap_filter.h"
#include "felt/rt/servo.h"

namespace felt {
namespace {

ServoOptions clamped(ServoOptions options) {
  options.period_ns = std::clamp<std::int64_t>(options.period_ns, 200'000, 4'000'000);
  const double fade_s = options.cross_fade_s;
  options.cross_fade_s =
      std::isfinite(fade_s) ? std::clamp(fade_s, 0.0, 1.0) : ServoOptions{}.cross_fade_s;
  options.limits.period_ns = options.period_ns;
  return options;
}

}  // namespace

Servo::Servo(Device& device, const ServoOptions& options)
    : device_(device),
      options_(clamped(options)),
      has_force_(device.capabilities().has_force()),
      is_arm_(device.is_arm()),
      chain_(options_.limits),
      leaps_(std::make_unique<LeapFilter>(options_.limits)),
      edit_ring_(options_.queued),
      autosave_ring_(options_.queued),
      force_ring_(options_.queues_forces ? std::make_unique<ForceRing>(options_.queued) : nullptr) {
}

Servo::~Servo() = default;

std::uint64_t Servo::publish(const ForceModel& model) noexcept {
  models_.publish({model, ++published_});
  return published_;
}

void Servo::heartbeat(std::int64_t now_ns) noexcept {
  heartbeat_ns_.store(now_ns, std::memory_order_release);
}

void Servo::arm() noexcept {
  arm_asked_.store(true, std::memory_order_release);
}

void Servo::disarm() noexcept {
  arm_asked_.store(false, std::memory_order_release);
  disarm_asked_.store(true, std::memory_order_release);
}

void Servo::set_strength(double share) noexcept {
  if (std::isnan(share)) return;
  strength_asked_.store(std::clamp(share, 0.0, 1.0), std::memory_order_relaxed);
}

void Servo::set_session_offset(std::int64_t offset_ns) noexcept {
  session_offset_ns_.store(offset_ns, std::memory_order_relaxed);
}

const TickReport& Servo::latest() noexcept {
  reports_.update();
  return reports_.get();
}

}  // namespace felt
