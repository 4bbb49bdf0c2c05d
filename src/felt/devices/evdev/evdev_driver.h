#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "felt/driver/driver.h"
#include "felt/driver/evdev_port.h"

namespace felt {

struct EvdevOptions {
  /// The system in which to look for devices; null means this machine.
  const SystemView* system = nullptr;
  /// The function that opens a device node.
  std::function<Result<std::unique_ptr<EvdevPort>>(const std::string& path)> open = open_evdev;
  /// If false, the device has no thread that uploads effects, and its owner must call
  /// EffectServed::serve(). For tests with a virtual clock.
  bool has_thread = true;
};

/// An additional interface of this driver's devices. If a device has no thread, its owner uses this
/// interface to do the work of the thread.
class EffectServed {
 public:
  virtual ~EffectServed() = default;
  /// Does the periodic work of the device's thread: stops effects if that was requested, and
  /// uploads new effects when they are due. The thread calls serve() every kLookNs. Must not be
  /// called on the haptic thread.
  virtual void serve(std::int64_t now_ns) noexcept = 0;
};

/// Makes the driver of joysticks and wheels with force feedback, through the kernel's input
/// interface. These devices render a few springs and frictions at a low rate instead of 1000 forces
/// a second (README.md). Each open device has a thread that does all writing: it uploads effects,
/// at most 125 times a second, and stops them.
std::unique_ptr<Driver> make_evdev_driver(EvdevOptions options = {});
inline constexpr std::int64_t kServeNs = 8'000'000;
inline constexpr std::int64_t kLookNs = 1'000'000;

}  // namespace felt
