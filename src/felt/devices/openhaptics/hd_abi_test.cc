#include "felt/devices/openhaptics/hd_abi.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <type_traits>

#include "felt/devices/openhaptics/hd_faults.h"

namespace felt::hd_abi_test {
namespace {

// Repeats the values as numbers, from the tables of the reference. A wrong value in the header
// would not show otherwise, because the driver and the fake library both use the header.
TEST(HdAbi, HasTheNumbersOfTheReference) {
  EXPECT_EQ(hd::error::kInvalidEnum + 4, hd::error::kBadHandle);
  EXPECT_EQ(hd::error::kInvalidOperation, 258U);
  EXPECT_EQ(hd::error::kInvalidInputType, 259U);
  EXPECT_EQ(hd::error::kWarmMotors, 512U);
  EXPECT_EQ(hd::error::kForceError, 516U);
  EXPECT_EQ(hd::error::kDeviceFault, 768U);
  EXPECT_EQ(hd::error::kAlreadyInUse, 769U);
  EXPECT_EQ(hd::error::kTimer, 772U);
  EXPECT_EQ(hd::error::kIllegalBegin, 1024U);
  EXPECT_EQ(hd::error::kSchedulerFull, 1281U);
  EXPECT_EQ(hd::error::kInvalidLicence, 1536U);
  EXPECT_EQ(hd::parameter::kButtons, 8192U);
  EXPECT_EQ(hd::parameter::kSafetySwitch, 8193U);
  EXPECT_EQ(hd::parameter::kInkwell, 8194U);
  EXPECT_EQ(hd::parameter::kPosition, 8272U);
  EXPECT_EQ(hd::parameter::kVelocity, 8273U);
  EXPECT_EQ(hd::parameter::kVersion, 9472U);
  EXPECT_EQ(hd::parameter::kSerialNumber, 9476U);
  EXPECT_EQ(hd::parameter::kUsableWorkspace, 9553U);
  EXPECT_EQ(hd::parameter::kCalibrationStyle, 9557U);
  EXPECT_EQ(hd::parameter::kUpdateRate, 9728U);
  EXPECT_EQ(hd::parameter::kMaxStiffness, 9730U);
  EXPECT_EQ(hd::parameter::kMaxForce, 9731U);
  EXPECT_EQ(hd::parameter::kMaxContinuousForce, 9732U);
  EXPECT_EQ(hd::parameter::kMotorTemperature, 9733U);
  EXPECT_EQ(hd::parameter::kMaxDamping, 9737U);
  EXPECT_EQ(hd::parameter::kForce, 9984U);
  EXPECT_EQ(hd::capability::kForceOutput, 16384U);
  EXPECT_EQ(hd::capability::kOneFrameLimit, 16388U);
  EXPECT_EQ(hd::calibration::kOk, 20480U);
  EXPECT_EQ(hd::calibration::kNeedsPerson, 20482U);
  EXPECT_EQ(hd::kFirst, 65535);
}

TEST(HdAbi, ErrorsComeByValueInTwelveBytes) {
  static_assert(std::is_trivially_copyable_v<hd::ErrorInfo>);
  EXPECT_EQ(offsetof(hd::ErrorInfo, internal_code), 4U);
  EXPECT_EQ(offsetof(hd::ErrorInfo, device), 8U);
}

TEST(HdAbi, EachErrorIsAFaultOfItsKind) {
  EXPECT_EQ(fault_of(0x200), DeviceFault::kOverheated);
  for (hd::Enum error = 0x201; error <= 0x204; ++error) {
    EXPECT_EQ(fault_of(error), DeviceFault::kForcesOff);
  }
  for (hd::Enum error = 0x300; error <= 0x304; ++error) {
    EXPECT_EQ(fault_of(error), DeviceFault::kDisconnected);
  }
  for (const hd::Enum error : {0x100U, 0x104U, 0x402U, 0x500U, 0x600U, 0x7777U}) {
    EXPECT_EQ(fault_of(error), DeviceFault::kOther);
  }
  EXPECT_EQ(graver(std::nullopt, std::nullopt), std::nullopt);
  EXPECT_EQ(graver(DeviceFault::kForcesOff, DeviceFault::kOverheated), DeviceFault::kOverheated);
  EXPECT_EQ(graver(DeviceFault::kDisconnected, DeviceFault::kOther), DeviceFault::kDisconnected);
}

}  // namespace
}  // namespace felt::hd_abi_test
