#include "felt/devices/simulated/faulty_device.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "felt/base/random.h"

namespace felt {
namespace {

PenSample at_time(PenSample sample, std::int64_t time_ns) noexcept {
  sample.time_ns = time_ns;
  return sample;
}

Vec3 noise(std::uint64_t seed, double max_mm) noexcept {
  Random random(seed);
  const double x = random.between(-max_mm, max_mm), y = random.between(-max_mm, max_mm);
  return {x, y, random.between(-max_mm, max_mm)};
}

Vec3 in_steps(const Vec3& p, double step_mm) noexcept {
  const auto rounded = [step_mm](double v) { return step_mm * std::floor(v / step_mm + 0.5); };
  return {rounded(p.x), rounded(p.y), rounded(p.z)};
}

struct NamedFault {
  InjectedFault fault;
  std::string_view name;
};
constexpr std::array kNames{NamedFault{InjectedFault::kReadError, "read-error"},
                            NamedFault{InjectedFault::kWriteError, "write-error"},
                            NamedFault{InjectedFault::kUnplugged, "unplugged"},
                            NamedFault{InjectedFault::kNotFinite, "not-finite"},
                            NamedFault{InjectedFault::kInfinite, "infinite"},
                            NamedFault{InjectedFault::kJump, "jump"},
                            NamedFault{InjectedFault::kFrozen, "frozen"},
                            NamedFault{InjectedFault::kStuckAxis, "stuck-axis"},
                            NamedFault{InjectedFault::kSignFlip, "sign-flip"},
                            NamedFault{InjectedFault::kNoise, "noise"},
                            NamedFault{InjectedFault::kCoarse, "coarse"},
                            NamedFault{InjectedFault::kTimeBackwards, "time-backwards"},
                            NamedFault{InjectedFault::kForceIgnored, "force-ignored"},
                            NamedFault{InjectedFault::kButtonBounce, "button-bounce"},
                            NamedFault{InjectedFault::kForcesOff, "forces-off"},
                            NamedFault{InjectedFault::kWarmMotors, "warm-motors"},
                            NamedFault{InjectedFault::kUncalibrated, "uncalibrated"},
                            NamedFault{InjectedFault::kButtonStuck, "button-stuck"},
                            NamedFault{InjectedFault::kDenormal, "denormal"},
                            NamedFault{InjectedFault::kNoAnswer, "no-answer"},
                            NamedFault{InjectedFault::kJumpOften, "jump-often"},
                            NamedFault{InjectedFault::kSlowAnswers, "slow-answers"},
                            NamedFault{InjectedFault::kLostAnswers, "lost-answers"},
                            NamedFault{InjectedFault::kBurstAnswers, "burst-answers"},
                            NamedFault{InjectedFault::kLateAnswer, "late-answer"}};

constexpr auto kFaults = [] {
  std::array<InjectedFault, kNames.size()> faults{};
  for (std::size_t i = 0; i < kNames.size(); ++i) faults[i] = kNames[i].fault;
  return faults;
}();

}  // namespace

std::span<const InjectedFault> injected_faults() noexcept {
  return kFaults;
}

std::string_view name_of(InjectedFault fault) noexcept {
  for (const NamedFault& named : kNames) {
    if (named.fault == fault) return named.name;
  }
  return "?";
}

const FaultWindow* FaultyDevice::active(InjectedFault fault) const noexcept {
  for (const FaultWindow& w : schedule_) {
    if (w.fault == fault && now_ns_ >= w.from_ns && now_ns_ < w.until_ns) return &w;
  }
  return nullptr;
}

void FaultyDevice::distort(PenSample& sample, const FaultWindow& window) noexcept {
  Vec3& p = sample.position;
  switch (window.fault) {
    case InjectedFault::kNotFinite:
      p.y = std::numeric_limits<double>::quiet_NaN();
      break;
    case InjectedFault::kInfinite:
      sample.velocity.z = std::numeric_limits<double>::infinity();
      break;
    case InjectedFault::kJump:
      p.x += window.amount;
      break;
    case InjectedFault::kJumpOften:
      if (reads_ % 2 == 0) p.x += window.amount;
      break;
    case InjectedFault::kFrozen:
      sample = at_time(last_, sample.time_ns);
      break;
    case InjectedFault::kStuckAxis:
      p.z = last_.position.z;
      break;
    case InjectedFault::kSignFlip:
      p = -p;
      break;
    case InjectedFault::kNoise:
      p += noise(reads_, window.amount);
      break;
    case InjectedFault::kCoarse:
      p = in_steps(p, window.amount);
      break;
    case InjectedFault::kTimeBackwards:
      sample.time_ns -= static_cast<std::int64_t>(1e6 * window.amount);
      break;
    case InjectedFault::kButtonBounce:
      sample.buttons ^= static_cast<std::uint32_t>(reads_ & 1u);
      break;
    case InjectedFault::kButtonStuck:
      sample.buttons |= 1u;
      break;
    case InjectedFault::kDenormal:
      p.z = -std::numeric_limits<double>::denorm_min();
      sample.velocity = {p.z, -p.z, p.z};
      break;
    case InjectedFault::kNoAnswer:
      sample = last_;
      break;
    default:
      break;  // the other faults do not change samples
  }
}

tl::expected<PenSample, DeviceFault> FaultyDevice::read(std::int64_t now_ns) noexcept {
  now_ns_ = now_ns;
  ++reads_;
  if (active(InjectedFault::kUnplugged) != nullptr) device_.stop();
  auto sample = device_.read(now_ns);  // reads in every case, so that the device continues to run
  if (active(InjectedFault::kReadError) != nullptr ||
      active(InjectedFault::kUnplugged) != nullptr) {
    return tl::unexpected(DeviceFault::kDisconnected);
  }
  if (!sample) return sample;
  if (active(InjectedFault::kUncalibrated) != nullptr) {
    return tl::unexpected(DeviceFault::kNotCalibrated);
  }
  for (const FaultWindow& w : schedule_) {
    if (now_ns >= w.from_ns && now_ns < w.until_ns) distort(*sample, w);
  }
  last_ = *sample;
  return sample;
}

tl::expected<void, DeviceFault> FaultyDevice::write(const Force& force) noexcept {
  if (active(InjectedFault::kWriteError) != nullptr ||
      active(InjectedFault::kUnplugged) != nullptr) {
    return tl::unexpected(DeviceFault::kDisconnected);
  }
  const bool is_warm = active(InjectedFault::kWarmMotors) != nullptr;
  if (is_warm || active(InjectedFault::kForcesOff) != nullptr) {
    device_.stop();
    return tl::unexpected(is_warm ? DeviceFault::kOverheated : DeviceFault::kForcesOff);
  }
  if (active(InjectedFault::kForceIgnored) != nullptr ||
      active(InjectedFault::kNoAnswer) != nullptr) {
    return {};
  }
  return device_.write(force);
}

}  // namespace felt
