#include "felt/devices/simulated/faulty_device.h"

#include <cmath>
#include <limits>

#include "felt/devices/simulated/random.h"

namespace felt {

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
    case InjectedFault::kFrozen: {
      const std::int64_t time_ns = sample.time_ns;
      sample = last_;
      sample.time_ns = time_ns;
      break;
    }
    case InjectedFault::kStuckAxis:
      p.z = last_.position.z;
      break;
    case InjectedFault::kSignFlip:
      p = -p;
      break;
    case InjectedFault::kNoise: {
      Random random(reads_);
      const double most = window.amount;
      p += {random.between(-most, most), random.between(-most, most), random.between(-most, most)};
      break;
    }
    case InjectedFault::kCoarse: {
      const auto steps = [&](double v) {
        return window.amount * std::floor(v / window.amount + 0.5);
      };
      p = {steps(p.x), steps(p.y), steps(p.z)};
      break;
    }
    case InjectedFault::kTimeBackwards:
      sample.time_ns -= static_cast<std::int64_t>(1e6 * window.amount);
      break;
    case InjectedFault::kButtonBounce:
      sample.buttons ^= static_cast<std::uint32_t>(reads_ & 1u);
      break;
    case InjectedFault::kReadError:
    case InjectedFault::kWriteError:
    case InjectedFault::kUnplugged:
    case InjectedFault::kForceIgnored:
      break;  // not in the sample
  }
}

tl::expected<PenSample, DeviceFault> FaultyDevice::read(std::int64_t now_ns) noexcept {
  now_ns_ = now_ns;
  ++reads_;
  if (active(InjectedFault::kUnplugged) != nullptr) device_.stop();
  auto sample = device_.read(now_ns);  // the world goes on, whether it is seen or not
  if (active(InjectedFault::kReadError) != nullptr ||
      active(InjectedFault::kUnplugged) != nullptr) {
    return tl::unexpected(DeviceFault::kDisconnected);
  }
  if (!sample) return sample;
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
  if (active(InjectedFault::kForceIgnored) != nullptr) return {};
  return device_.write(force);
}

}  // namespace felt
