#pragma once

#include <cstdint>
#include <string_view>

namespace felt::dhd {

/// Which call takes the force of a device, so that what we do not use is told to be zero.
enum class ForceCall : std::uint8_t {
  kForce,                  ///< nothing but the base has motors
  kForceAndGripper,        ///< the gripper, too
  kForceTorqueAndGripper,  ///< and the wrist
};

/// What the number that dhdGetSystemType() gives means.
struct SystemType {
  int number = 0;
  std::string_view model;  ///< row of device_models()
  std::string_view label;  ///< for people; empty: ask the library for the name
  ForceCall call = ForceCall::kForce;
  /// Its second button is the one under the finger (omega.3 of type 110; CHAI3D's CDeltaDevices).
  bool second_button_is_first = false;
};

/// Never nothing: a type that nobody knows is a device with three axes, of which the least is
/// expected (CHAI3D knows twenty more numbers than the maker's header).
SystemType system_type_of(int number) noexcept;

}  // namespace felt::dhd
