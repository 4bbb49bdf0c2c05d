#pragma once

#include <cstddef>
#include <cstdint>

/// The numbers of the kernel's input interface that our drivers use. They have names here, so that
/// the build does not depend on new kernel headers (FF_HAPTIC came with Linux 6.18). The numbers
/// come from the kernel's documentation of input event codes and of force feedback;
/// evdev_port_test.cc compares them with the installed headers.
namespace felt::evdev {

inline constexpr std::uint16_t kSyn = 0x00, kKey = 0x01, kAbs = 0x03, kFf = 0x15;  // types
inline constexpr std::uint16_t kSynReport = 0, kSynDropped = 3;

inline constexpr std::uint16_t kAbsX = 0x00, kAbsY = 0x01, kAbsZ = 0x02, kAbsRz = 0x05;
inline constexpr std::uint16_t kAbsThrottle = 0x06, kAbsWheel = 0x08, kAbsGas = 0x09;
inline constexpr std::uint16_t kAbsBrake = 0x0A;

inline constexpr std::uint16_t kButtonTrigger = 0x120;  ///< first button of a joystick
inline constexpr std::uint16_t kButtonJoystickEnd = 0x130;
inline constexpr std::uint16_t kButtonSouth = 0x130;  ///< first button of a game pad
inline constexpr std::uint16_t kButtonGamepadEnd = 0x140;
inline constexpr std::uint16_t kButtonGearDown = 0x150;  ///< BTN_WHEEL
inline constexpr std::uint16_t kButtonGearUp = 0x151;
inline constexpr std::uint16_t kButtonTouch = 0x14A;

inline constexpr std::uint16_t kFfHaptic = 0x4F;  ///< Linux 6.18 and newer
inline constexpr std::uint16_t kFfRumble = 0x50, kFfPeriodic = 0x51, kFfConstant = 0x52;
inline constexpr std::uint16_t kFfSpring = 0x53, kFfFriction = 0x54, kFfDamper = 0x55;
inline constexpr std::uint16_t kFfGain = 0x60, kFfAutocenter = 0x61;

inline constexpr std::size_t kAxisCount = 0x40, kKeyCount = 0x300, kFfCount = 0x80;

}  // namespace felt::evdev
