#pragma once

#include <functional>
#include <memory>
#include <string>

#include "felt/driver/driver.h"
#include "felt/driver/evdev_port.h"
#include "felt/driver/hidraw_port.h"

namespace felt {

struct CueOptions {
  /// The system in which to look for devices; null means this machine.
  const SystemView* system = nullptr;
  /// The function that opens device nodes.
  std::function<Result<std::unique_ptr<HidrawPort>>(const std::string& path)> open_hidraw =
      felt::open_hidraw;
  std::function<Result<std::unique_ptr<EvdevPort>>(const std::string& path)> open_evdev =
      felt::open_evdev;
};

/// Makes the driver of all devices that play waveforms: haptic pens, touchpads, mice and game
/// controllers (README.md). find() only reads sysfs and does not open devices.
std::unique_ptr<Driver> make_cue_driver(CueOptions options = {});

}  // namespace felt
