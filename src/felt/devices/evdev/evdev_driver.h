#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "felt/driver/driver.h"
#include "felt/driver/evdev_port.h"

namespace felt {

struct EvdevOptions {
  /// Where it looks for devices; null: this machine.
  const SystemView* system = nullptr;
  /// How a node is opened.
  std::function<Result<std::unique_ptr<EvdevPort>>(const std::string& path)> open = open_evdev;
  /// False: no thread uploads effects; whoever owns the device calls EffectServed::serve(). For
  /// tests on a virtual clock.
  bool has_thread = true;
};

/// What a device of this driver also is.
class EffectServed {
 public:
  virtual ~EffectServed() = default;
  /// What the thread does each kLookNs: silences at once, and uploads each kServeNs. Not on the
  /// haptic thread.
  virtual void serve(std::int64_t now_ns) noexcept = 0;
};

/// Joysticks and wheels with force feedback, through the kernel's input interface: renderers of few
/// springs and frictions at a low rate, not of 1000 forces a second (README.md). Each open device
/// has a thread that tells it all that it is told: uploads, 125 times a second at most, and stops.
std::unique_ptr<Driver> make_evdev_driver(EvdevOptions options = {});
inline constexpr std::int64_t kServeNs = 8'000'000;
inline constexpr std::int64_t kLookNs = 1'000'000;

}  // namespace felt
