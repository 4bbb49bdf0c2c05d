#pragma once

#include <optional>

#include "felt/devices/openhaptics/hd_abi.h"
#include "felt/rt/device.h"

namespace felt {

/// What an error of the library is to us: errors of forces pass (the motors are off for a while,
/// reading goes on), errors of the device, its cable or the timer end everything, and the rest
/// (0x100, 0x400 and beyond) is a call of ours that the library did not like.
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

/// Which of two faults is told when both came in one tick.
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
