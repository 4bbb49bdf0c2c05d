#pragma once

#include <cstdint>
#include <string_view>

namespace felt::dhd {

/// The library call that sets a device's force. It is chosen so that motors that we do not use
/// (gripper, wrist) are set to zero.
enum class ForceCall : std::uint8_t {
  kForce,                  ///< only the base has motors
  kForceAndGripper,        ///< base and gripper have motors
  kForceTorqueAndGripper,  ///< base, gripper and wrist have motors
};

/// The kind of device that a result of dhdGetSystemType() stands for.
struct SystemType {
  int number = 0;
  std::string_view model;  ///< id of device_models()
  std::string_view label;  ///< for the user; if empty, the library's name is used
  ForceCall call = ForceCall::kForce;
  /// True if the second button is under the finger (omega.3 with type 110; see CHAI3D's
  /// CDeltaDevices).
  bool second_button_is_first = false;
};

/// Returns the type with this number. An unknown number is treated as a device with three axes and
/// the lowest limits (CHAI3D has twenty more numbers than the maker's header).
SystemType system_type_of(int number) noexcept;

}  // namespace felt::dhd
