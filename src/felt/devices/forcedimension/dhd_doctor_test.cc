#include "felt/devices/forcedimension/dhd_doctor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/devices/forcedimension/forcedimension.h"
#include "felt/driver/testing/fake_system.h"

namespace felt::dhd::dhd_doctor_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::SizeIs;

FakeSystem with_omega() {
  FakeSystem system;
  system.add_file("/sys/bus/usb/devices/1-2/idVendor", "1451\n")
      .add_file("/sys/bus/usb/devices/1-2/idProduct", "0402\n")
      .add_file("/sys/bus/usb/devices/1-2/product", "omega.3\n")
      .add_file("/sys/bus/usb/devices/1-2/busnum", "1\n")
      .add_file("/sys/bus/usb/devices/1-2/devnum", "14\n")
      .add_file("/dev/bus/usb/001/014")
      .add_file("/sys/bus/usb/devices/usb1/idVendor", "1d6b\n");
  return system;
}

TEST(DhdDoctor, WhoOwnsNothingOfItHearsOneQuietLine) {
  const auto findings = diagnose(FakeSystem(), "", "");
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_EQ(findings[0].level, FindingLevel::kAbsent);
  EXPECT_THAT(findings[0].steps, SizeIs(5)) << "for those who ask by name";
}

TEST(DhdDoctor, AllIsWell) {
  FakeSystem system = with_omega();
  system.add_library("libdrd.so");
  const auto findings = diagnose(system, "", "");
  ASSERT_THAT(findings, SizeIs(2));
  EXPECT_EQ(findings[0].level, FindingLevel::kOk);
  EXPECT_THAT(findings[0].what, HasSubstr("omega.3"));
  EXPECT_EQ(findings[1].level, FindingLevel::kOk);
  EXPECT_THAT(findings[1].what, HasSubstr("libdrd.so"));
}

// With this_system(), the driver really loads the library. So it reports missing functions, and not
// only that the file exists.
TEST(DhdDoctor, ALibraryThatIsAnotherOneIsNotFine) {
  ForceDimensionOptions options;
  options.library = "libm.so.6";
  const auto findings = make_forcedimension_driver(options)->diagnose(this_system());
  ASSERT_FALSE(findings.empty());
  const Finding& library = findings.size() > 1 ? findings[findings.size() - 2] : findings[0];
  EXPECT_EQ(library.level, FindingLevel::kProblem);
  EXPECT_THAT(library.what, HasSubstr("is a different one or too old"));
  EXPECT_THAT(library.details, HasSubstr("it lacks dhdGetDeviceCount"));
}

TEST(DhdDoctor, ADeviceWithoutPermissionGetsAUdevRule) {
  FakeSystem system = with_omega();
  system.forbid("/dev/bus/usb/001/014").add_library("libdrd.so");
  const auto findings = diagnose(system, "", "");
  ASSERT_THAT(findings, SizeIs(2));
  EXPECT_EQ(findings[0].level, FindingLevel::kProblem);
  EXPECT_THAT(findings[0].what, HasSubstr("ada does not have permission to use it"));
  EXPECT_THAT(findings[0].details, HasSubstr("Permission denied"));
  EXPECT_THAT(findings[0].steps, Contains(HasSubstr("feltline doctor --fix")));
  ASSERT_TRUE(findings[0].fix.has_value());
  EXPECT_THAT(findings[0].fix->content, HasSubstr("ATTR{idVendor}==\"1451\""));
  EXPECT_THAT(findings[0].fix->content, HasSubstr("TAG+=\"uaccess\""));
  EXPECT_EQ(findings[0].fix->activate, kReloadUdev);
}

TEST(DhdDoctor, ADeviceThatNoFileLeadsToIsToldApart) {
  FakeSystem system = with_omega();
  system.remove("/dev/bus/usb/001/014");
  const auto findings = diagnose(system, "", "");
  EXPECT_EQ(findings[0].level, FindingLevel::kProblem);
  EXPECT_THAT(findings[0].what, HasSubstr("device file is missing"));
  EXPECT_FALSE(findings[0].fix.has_value()) << "no rule helps";
}

TEST(DhdDoctor, TheFalconIsKnownByItsProductToo) {
  FakeSystem system;
  system.add_file("/sys/bus/usb/devices/3-1/idVendor", "0403\n")
      .add_file("/sys/bus/usb/devices/3-1/idProduct", "cb48\n")
      .add_file("/sys/bus/usb/devices/3-1/busnum", "3\n")
      .add_file("/sys/bus/usb/devices/3-1/devnum", "7\n")
      .add_file("/dev/bus/usb/003/007")
      .add_file("/sys/bus/usb/devices/3-2/idVendor", "0403\n")  // any other FTDI chip
      .add_file("/sys/bus/usb/devices/3-2/idProduct", "6001\n");
  const auto findings = diagnose(system, "", "");
  ASSERT_THAT(findings, SizeIs(2));
  EXPECT_THAT(findings[0].what, HasSubstr("Novint Falcon"));
}

TEST(DhdDoctor, ADeviceWithoutLibraryGetsTheWayToTheSdk) {
  const auto findings = diagnose(with_omega(), "", "");
  ASSERT_THAT(findings, SizeIs(2));
  EXPECT_EQ(findings[1].level, FindingLevel::kProblem);
  EXPECT_THAT(findings[1].what, HasSubstr("libdrd.so"));
  EXPECT_THAT(findings[1].steps, SizeIs(4));
}

TEST(DhdDoctor, ALibraryForAnotherProcessorIsToldApart) {
  FakeSystem system = with_omega();
  system.refuse_library("libdrd.so", "libdrd.so: wrong ELF class: ELFCLASS32");
  const auto findings = diagnose(system, "", "");
  EXPECT_EQ(findings[1].level, FindingLevel::kProblem);
  EXPECT_EQ(findings[1].details, "libdrd.so: wrong ELF class: ELFCLASS32");
  EXPECT_THAT(findings[1].steps, Contains(HasSubstr("uname -m")));
}

TEST(DhdDoctor, ALibraryThatLacksAnotherNamesThatOne) {
  FakeSystem system = with_omega();
  system.refuse_library(
      "libdrd.so", "libusb-1.0.so.0: cannot open shared object file: No such file or directory");
  const auto findings = diagnose(system, "", "");
  EXPECT_EQ(findings[1].level, FindingLevel::kProblem);
  EXPECT_THAT(findings[1].details, HasSubstr("libusb-1.0.so.0"));
  EXPECT_THAT(findings[1].steps, Contains(HasSubstr("sudo apt install libusb-1.0-0")));
}

TEST(DhdDoctor, TheLibraryOfTheOtherWordSizeIsPassedOverWhenARightOneIsThere) {
  FakeSystem system = with_omega();
  system.set_environment("FDSDK", "/opt/sdk")
      .add_file("/opt/sdk/lib/lin-i686-gcc/libdrd.so")
      .add_file("/opt/sdk/lib/lin-x86_64-gcc/libdrd.so")
      .refuse_library("/opt/sdk/lib/lin-i686-gcc/libdrd.so",
                      "/opt/sdk/lib/lin-i686-gcc/libdrd.so: wrong ELF class: ELFCLASS32")
      .add_library("/opt/sdk/lib/lin-x86_64-gcc/libdrd.so");
  EXPECT_EQ(diagnose(system, "", "")[1].level, FindingLevel::kOk);
}

TEST(DhdDoctor, ANameThatLeadsNowhereIsToldWithItsVariable) {
  const auto findings = diagnose(FakeSystem(), "/old/libdrd.so", "");
  EXPECT_EQ(findings[0].level, FindingLevel::kProblem);
  EXPECT_THAT(findings[0].what, HasSubstr("FELT_FORCEDIMENSION_LIBRARY"));
  EXPECT_THAT(findings[0].what, HasSubstr("/old/libdrd.so"));
}

TEST(DhdDoctor, TheLibraryWithoutADeviceAsksForItsCables) {
  FakeSystem system;
  system.add_library("libdhd.so");
  const auto findings = diagnose(system, "", "");
  ASSERT_THAT(findings, SizeIs(2));
  EXPECT_EQ(findings[1].level, FindingLevel::kWarning);
  EXPECT_THAT(findings[1].steps, Contains(HasSubstr("power supply")));
}

TEST(DhdDoctor, WhatTheLibraryRefusedIsToldInItsWords) {
  FakeSystem system = with_omega();
  system.add_library("libdrd.so");
  const auto findings = diagnose(system, "", "device already in use (error 20)");
  ASSERT_THAT(findings, SizeIs(3));
  EXPECT_EQ(findings[2].details, "device already in use (error 20)");
  EXPECT_THAT(findings[2].steps, Contains(HasSubstr("other programs")));
}

}  // namespace
}  // namespace felt::dhd::dhd_doctor_test
