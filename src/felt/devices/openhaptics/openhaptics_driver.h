#pragma once

#include <memory>
#include <string>
#include <vector>

#include "felt/driver/driver.h"

namespace felt {

struct OpenHapticsOptions {
  /// The file of libHD. If it is empty, the environment variable FELT_OPENHAPTICS_LIBRARY names the
  /// file; if that is not set, the names of openhaptics_library_names() are tried. If a file is
  /// named here or in the variable, only that file is tried.
  std::string library;
  /// The name that the maker's set-up program gave to the device. If it is empty, the environment
  /// variable FELT_OPENHAPTICS_DEVICE is used, if set. The name is tried if the usual names do not
  /// open the device.
  std::string device;
};

/// Makes the driver of 3D Systems Touch and Touch X, and SensAble PHANToM Omni, Desktop and
/// Premium. It uses the maker's OpenHaptics library, which runs the servo loop: its devices must be
/// run through loop_host(), because read() fails outside of the library's loop.
std::unique_ptr<Driver> make_openhaptics_driver(OpenHapticsOptions options = {});

/// Returns the file names under which libHD is searched, in this order.
std::vector<std::string> openhaptics_library_names();

}  // namespace felt
