#include "felt/rt/device.h"

namespace felt {

std::string_view describe(DeviceFault fault) noexcept {
  switch (fault) {
    case DeviceFault::kDisconnected:
      return "The device is no longer connected.";
    case DeviceFault::kNotCalibrated:
      return "The device must be calibrated before it can be used.";
    case DeviceFault::kForcesOff:
      return "The device has switched its forces off by itself.";
    case DeviceFault::kOverheated:
      return "The motors of the device are too warm.";
    case DeviceFault::kBadData:
      return "The device sends invalid data.";
    case DeviceFault::kOther:
      break;
  }
  return "The device reports an error.";
}

}  // namespace felt
