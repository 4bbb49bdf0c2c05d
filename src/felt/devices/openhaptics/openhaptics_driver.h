#pragma once

#include <memory>
#include <string>
#include <vector>

#include "felt/driver/driver.h"

namespace felt {

struct OpenHapticsOptions {
  /// File of libHD; empty: the environment variable FELT_OPENHAPTICS_LIBRARY, or else the usual
  /// names. If a file is named, only that is tried.
  std::string library;
  /// Name that the maker's set-up program gave to the device, tried if the usual names do not open
  /// it; empty: the environment variable FELT_OPENHAPTICS_DEVICE, or none.
  std::string device;
};

/// Makes the driver of 3D Systems Touch and Touch X, and SensAble PHANToM Omni, Desktop and
/// Premium. It uses the maker's OpenHaptics library, which runs the servo loop: its devices must be
/// run through loop_host(), because read() fails outside of it.
std::unique_ptr<Driver> make_openhaptics_driver(OpenHapticsOptions options = {});

/// Returns the names under which libHD is searched, in this order.
std::vector<std::string> openhaptics_library_names();

}  // namespace felt
