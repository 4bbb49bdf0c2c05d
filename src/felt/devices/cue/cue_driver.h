#pragma once

#include <functional>
#include <memory>
#include <string>

#include "felt/driver/driver.h"
#include "felt/driver/evdev_port.h"
#include "felt/driver/hidraw_port.h"

namespace felt {

struct CueOptions {
  /// The system in which to look for devices; null: this machine.
  const SystemView* system = nullptr;
  /// The function that opens device nodes.
  std::function<Result<std::unique_ptr<HidrawPort>>(const std::string& path)> open_hidraw =
      felt::open_hidraw;
  std::function<Result<std::unique_ptr<EvdevPort>>(const std::string& path)> open_evdev =
      felt::open_evdev;
};

/// Makes the driver of haptic pens, touchpads, mice and game controllers: everything that plays
/// waveforms (README.md). find() only reads sysfs and opens nothing.
std::unique_ptr<Driver> make_cue_driver(CueOptions options = {});

}  // namespace felt
