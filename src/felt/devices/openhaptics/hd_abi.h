#pragma once

#include <cstdint>

/// The part of the binary interface of libHD on 64-bit Linux that we need, in our own declarations
/// and names (docs/design/devices.md#openhaptics; OpenHaptics API reference, tables ).
/// The values are facts of the interface. Nothing was copied from the maker's headers.
namespace felt::hd {

using Enum = unsigned;
using Handle = unsigned;
using Callback = unsigned (*)(void*);
using CallbackHandle = unsigned long;

/// An error of the library; get_error() returns it by value.
struct ErrorInfo {
  unsigned code;
  int internal_code;
  Handle device;
};
static_assert(sizeof(ErrorInfo) == 12);

inline constexpr Handle kNoHandle = 0xFFFFFFFF;
inline constexpr unsigned kCallbackDone = 0;      // return value of a callback
inline constexpr unsigned kCallbackContinue = 1;  // return value of a callback
inline constexpr unsigned short kFirst = 65535;   // priority of a callback; highest
inline constexpr unsigned char kFalse = 0;
inline constexpr unsigned char kTrue = 1;

/// Results of get_error(). The first hexadecimal digit is the kind of error.
namespace error {
inline constexpr Enum kNone = 0;
inline constexpr Enum kInvalidEnum = 0x100;
inline constexpr Enum kInvalidValue = 0x101;
inline constexpr Enum kInvalidOperation = 0x102;
inline constexpr Enum kInvalidInputType = 0x103;
inline constexpr Enum kBadHandle = 0x104;
inline constexpr Enum kWarmMotors = 0x200;
inline constexpr Enum kTooMuchForce = 0x201;
inline constexpr Enum kTooSuddenForce = 0x202;
inline constexpr Enum kTooFast = 0x203;
inline constexpr Enum kForceError = 0x204;
inline constexpr Enum kDeviceFault = 0x300;
inline constexpr Enum kAlreadyInUse = 0x301;
inline constexpr Enum kCommunication = 0x302;
inline constexpr Enum kCommunicationSetup = 0x303;
inline constexpr Enum kTimer = 0x304;
inline constexpr Enum kIllegalBegin = 0x400;
inline constexpr Enum kIllegalEnd = 0x401;
inline constexpr Enum kFrameError = 0x402;
inline constexpr Enum kInvalidPriority = 0x500;
inline constexpr Enum kSchedulerFull = 0x501;
inline constexpr Enum kInvalidLicence = 0x600;
}  // namespace error

/// Parameters of a device that can be read or set, with the number and type of their values.
namespace parameter {
inline constexpr Enum kButtons = 0x2000;       // int; bits 0..3
inline constexpr Enum kSafetySwitch = 0x2001;  // boolean
inline constexpr Enum kInkwell = 0x2002;       // boolean
inline constexpr Enum kEncoders = 0x2010;      // 6 long
inline constexpr Enum kPosition = 0x2050;      // 3 double or float, mm
inline constexpr Enum kVelocity = 0x2051;      // 3, mm/s
inline constexpr Enum kTransform = 0x2052;     // 16, by columns; position at 12..14
inline constexpr Enum kVersion = 0x2500;       // string; the next four parameters are strings, too
inline constexpr Enum kModelType = 0x2501;
inline constexpr Enum kDriverVersion = 0x2502;
inline constexpr Enum kVendor = 0x2503;
inline constexpr Enum kSerialNumber = 0x2504;
inline constexpr Enum kFirmwareVersion = 0x2505;        // double
inline constexpr Enum kLargestWorkspace = 0x2550;       // 6, mm: minimum x y z, maximum x y z
inline constexpr Enum kUsableWorkspace = 0x2551;        // the same
inline constexpr Enum kTabletopOffset = 0x2552;         // float, mm
inline constexpr Enum kInputDof = 0x2553;               // int
inline constexpr Enum kOutputDof = 0x2554;              // int
inline constexpr Enum kCalibrationStyle = 0x2555;       // int; bits of namespace calibration
inline constexpr Enum kUpdateRate = 0x2600;             // int, Hz
inline constexpr Enum kMeasuredUpdateRate = 0x2601;     // int, Hz
inline constexpr Enum kMaxStiffness = 0x2602;           // N/mm
inline constexpr Enum kMaxForce = 0x2603;               // N
inline constexpr Enum kMaxContinuousForce = 0x2604;     // N
inline constexpr Enum kMotorTemperature = 0x2605;       // 3 or 6, 0 cold .. 1 too warm
inline constexpr Enum kSoftwareVelocityLimit = 0x2606;  // mm/s; also a capability
inline constexpr Enum kSoftwareImpulseLimit = 0x2607;   // N/ms; also a capability
inline constexpr Enum kForceRampingRate = 0x2608;       // N/s
inline constexpr Enum kMaxDamping = 0x2609;             // N s/mm
inline constexpr Enum kForce = 0x2700;                  // 3, N; zero at the start of each frame
}  // namespace parameter

/// Capabilities that can be switched on and off.
namespace capability {
inline constexpr Enum kForceOutput = 0x4000;
inline constexpr Enum kMaxForceClamping = 0x4001;
inline constexpr Enum kForceRamping = 0x4002;
inline constexpr Enum kSoftwareForceLimit = 0x4003;
inline constexpr Enum kOneFrameLimit = 0x4004;
}  // namespace capability

namespace calibration {
inline constexpr Enum kOk = 0x5000;
inline constexpr Enum kNeedsUpdate = 0x5001;
inline constexpr Enum kNeedsPerson = 0x5002;
inline constexpr Enum kEncoderReset = 1;  // calibration styles; can be combined as bits
inline constexpr Enum kAuto = 2;
inline constexpr Enum kInkwell = 4;
}  // namespace calibration

}  // namespace felt::hd
