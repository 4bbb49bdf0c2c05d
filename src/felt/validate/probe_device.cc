#include "felt/validate/probe_device.h"

#include <algorithm>
#include <ctime>

namespace felt {
namespace {

void sleep_for(std::int64_t ns) noexcept {
  timespec time{ns / 1'000'000'000, ns % 1'000'000'000};
  while (clock_nanosleep(CLOCK_MONOTONIC, 0, &time, &time) != 0) {
  }
}

}  // namespace

tl::expected<PenSample, DeviceFault> ProbeDevice::read(std::int64_t now_ns) noexcept {
  const std::int64_t stall_ns = stall_ns_.exchange(kNoStall, std::memory_order_relaxed);
  // The sleep is intentional: it simulates a program that hangs. In no other function may a tick
  // sleep.
  if (stall_ns > 0) sleep_for(stall_ns);
  const auto sample = device_.read(now_ns);
  tick_.now_ns = now_ns;
  tick_.after_stall = stall_ns != kNoStall;
  tick_.read_fault = sample ? std::nullopt : std::optional(sample.error());
  if (sample) tick_.sample = *sample;
  balls_.update();
  const Ball& ball = balls_.get();
  if (sample && ball.radius_mm > 0.0 && !(norm(sample->position - ball.middle) <= ball.radius_mm)) {
    tripped_.store(true, std::memory_order_relaxed);
  }
  return sample;
}

tl::expected<void, DeviceFault> ProbeDevice::write(const Force& force) noexcept {
  const Force passed = tripped_.load(std::memory_order_relaxed) ? Force{} : force;
  const auto done = device_.write(passed);
  tick_.force = passed;
  tick_.write_fault = done ? std::nullopt : std::optional(done.error());
  ring_.push(tick_);
  return done;
}

void ProbeDevice::guard(const Vec3& middle_mm, double radius_mm) noexcept {
  balls_.publish({middle_mm, radius_mm});
}

}  // namespace felt
