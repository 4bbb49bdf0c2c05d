#pragma once

#include <functional>
#include <memory>
#include <string>

#include "felt/driver/driver.h"
#include "felt/driver/evdev_port.h"
#include "felt/driver/hidraw_port.h"

namespace felt {

struct CueOptions {
  /// Where it looks for devices; null: this machine.
  const SystemView* system = nullptr;
  /// How nodes are opened.
  std::function<Result<std::unique_ptr<HidrawPort>>(const std::string& path)> open_hidraw =
      felt::open_hidraw;
  std::function<Result<std::unique_ptr<EvdevPort>>(const std::string& path)> open_evdev =
      felt::open_evdev;
};

/// Haptic pens, touchpads, mice and game controllers: all that plays waveforms (README.md). find()
/// reads sysfs alone and opens nothing.
std::unique_ptr<Driver> make_cue_driver(CueOptions options = {});

}  // namespace felt
