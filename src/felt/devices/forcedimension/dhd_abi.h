#pragma once

#include <cstdint>

/// Our own declarations of the functions in `dhdc.h` and `drdc.h`, the headers of Force Dimension's
/// libraries (SDK 3.x: libdhd.so, and libdrd.so, which contains the functions of both libraries).
/// Units are metres, m/s and newtons; X is the depth towards the user, Y right, Z up.
///
/// Every function for a single device takes the device's number as its last argument. In the
/// maker's header this argument has a default value and is easily overlooked. If a function type
/// here lacked the argument, the library's function would read an undefined value. All functions
/// are plain C functions. If a function returns an int, a negative value means an error; any other
/// value is a result, 0, or a positive notice.
namespace felt::dhd {

using Id = char;

/// Results of dhdErrorGetLast(), which returns the last error of the calling thread.
enum Error : int {
  kNoError = 0,
  kError = 1,
  kErrorCom = 2,
  kErrorBusy = 3,
  kErrorNoDriver = 4,
  kErrorNoDevice = 5,
  kErrorNotAvailable = 6,
  kErrorTimeout = 7,
  kErrorGeometry = 8,
  kErrorExpertMode = 9,
  kErrorNotImplemented = 10,
  kErrorOutOfMemory = 11,
  kErrorNotReady = 12,
  kErrorConfiguration = 14,
  kErrorInvalidIndex = 15,
  kErrorNullArgument = 17,
  kErrorRedundancy = 18,
  kErrorInUse = 20,
  kErrorInvalid = 21,
};

/// Notices that functions return instead of 0. They are not errors.
inline constexpr int kTimeGuard = 1;       ///< called too soon; returned the last values again
inline constexpr int kMotorSaturated = 2;  ///< the motors produce their maximum force
inline constexpr int kFailed = -1;

inline constexpr int kOff = 0;
inline constexpr int kOn = 1;

/// Indices of the array that dhdGetStatus() fills. Our array is larger than the 17 elements of SDK
/// 3.17, because a newer library may write more.
inline constexpr int kStatusSize = 17;
inline constexpr int kStatusRoom = 64;
enum StatusIndex : int {
  kStatusPower = 0,
  kStatusConnected = 1,
  kStatusStarted = 2,
  kStatusReset = 3,  ///< the device is in the mode for calibration
  kStatusIdle = 4,
  kStatusForce = 5,
  kStatusBrake = 6,
  kStatusTorque = 7,
  kStatusWristDetected = 8,
  kStatusError = 9,
  kStatusGravity = 10,
  kStatusTimeGuard = 11,
  kStatusWristInit = 12,
  kStatusRedundancy = 13,
  kStatusForceOffCause = 14,
  kStatusLocks = 15,
  kStatusAxisChecked = 16,
};

/// The reason why the motors are off, as dhdGetStatus() stores it at index kStatusForceOffCause.
enum ForceOffCause : int {
  kCauseNone = 0,
  kCauseButton = 1,    ///< the force button of the device
  kCauseVelocity = 2,  ///< the guard against fast movement
  kCauseWatchdog = 3,  ///< no force command came within the watchdog's limit
  kCauseSoftware = 4,  ///< a program requested it
  kCauseUsb = 5,
  kCauseDeadMan = 6,  ///< nobody holds the device
};

/// Unit of the watchdog's limit. The limit is a byte, so it is at most 31.9 ms.
inline constexpr std::int64_t kWatchdogUnitNs = 125'000;
inline constexpr unsigned char kWatchdog31Ms = 248;

// The types of the functions, named like the functions but without "dhd" or "drd".
using GetDeviceCount = int();
using OpenId = int(Id index);
using Close = int(Id);
using GetSystemType = int(Id);
using GetSystemName = const char*(Id);
using GetSerialNumber = int(unsigned short*, Id);
using GetSdkVersion = void(int* major, int* minor, int* release, int* revision);
using GetStatus = int(int*, Id);
using IsTrue = bool(Id);
using Simple = int(Id);  ///< drdAutoInit, dhdReset, dhdStop
using DrdStop = int(bool force_on, Id);
using WaitForReset = int(int timeout_ms, Id);
using ExpertMode = int();
using EnableForce = int(unsigned char, Id);
using SetInt = int(int, Id);  ///< dhdSetGravityCompensation
using SetDouble = int(double, Id);
using Get3 = int(double*, double*, double*, Id);
using SetForce = int(double, double, double, Id);
using SetForceAndGripperForce = int(double, double, double, double, Id);
using SetForceAndTorqueAndGripperForce = int(double, double, double, double, double, double, double,
                                             Id);
using GetButton = int(int index, Id);
using GetButtonMask = unsigned int(Id);
using SetWatchdog = int(unsigned char, Id);
using GetWatchdog = int(unsigned char*, Id);
using GetComFreq = double(Id);
using ErrorGetLast = int();
using ErrorGetLastStr = const char*();

}  // namespace felt::dhd
