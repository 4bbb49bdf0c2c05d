#pragma once

#include <optional>

#include "felt/devices/openhaptics/hd_abi.h"
#include "felt/rt/device.h"

namespace felt {

/// Returns our fault for an error of the library. Force errors are temporary: the motors are off
/// for a while, but reading goes on. Errors of the device, its cable or the timer are permanent.
/// All others (0x100 to 0x1FF, and from 0x400 on) mean that the library rejected one of our calls.
constexpr DeviceFault fault_of(hd::Enum error) noexcept {
  switch (error >> 8) {
    case 2:
      return error == hd::error::kWarmMotors ? DeviceFault::kOverheated : DeviceFault::kForcesOff;
    case 3:
      return DeviceFault::kDisconnected;
    default:
      return DeviceFault::kOther;
  }
}

/// Returns the more serious of two faults. If both occur in one tick, only the more serious fault
/// is reported.
constexpr std::optional<DeviceFault> graver(std::optional<DeviceFault> a,
                                            std::optional<DeviceFault> b) noexcept {
  constexpr auto weight = [](std::optional<DeviceFault> fault) {
    if (!fault) return 0;
    switch (*fault) {
      case DeviceFault::kDisconnected:
        return 5;
      case DeviceFault::kOther:
        return 4;
      case DeviceFault::kOverheated:
        return 3;
      default:
        return 2;
    }
  };
  return weight(a) >= weight(b) ? a : b;
}

}  // namespace felt
