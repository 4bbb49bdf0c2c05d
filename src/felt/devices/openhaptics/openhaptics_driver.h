#pragma once

#include <memory>
#include <string>
#include <vector>

#include "felt/driver/driver.h"

namespace felt {

struct OpenHapticsOptions {
  /// File of libHD; empty: the environment's FELT_OPENHAPTICS_LIBRARY, and without that the usual
  /// names. One that is named is the only one that is tried.
  std::string library;
  /// Name that the maker's set-up program gave to the device, tried when the usual names do not
  /// open it; empty: the environment's FELT_OPENHAPTICS_DEVICE, or none.
  std::string device;
};

/// 3D Systems Touch and Touch X, SensAble PHANToM Omni, Desktop and Premium, through the maker's
/// OpenHaptics library, which runs the servo loop: a device of it must be run through its
/// loop_host(), outside of which read() fails.
std::unique_ptr<Driver> make_openhaptics_driver(OpenHapticsOptions options = {});

/// Names under which libHD is looked for, in this order.
std::vector<std::string> openhaptics_library_names();

}  // namespace felt
