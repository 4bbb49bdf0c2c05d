#include "felt/driver/testing/fake_system.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace felt::fake_system_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(FakeSystemTest, IsEmptyAtFirst) {
  const FakeSystem system;
  EXPECT_THAT(system.list("/dev"), IsEmpty());
  EXPECT_EQ(system.read("/etc/group"), std::nullopt);
  EXPECT_FALSE(system.exists("/dev"));
  EXPECT_FALSE(system.listens("localhost", 10001));
  EXPECT_EQ(system.environment("HOME"), std::nullopt);
  const Result<void> library = system.try_library("libHD.so");
  ASSERT_FALSE(library);
  EXPECT_EQ(library.error().message,
            "libHD.so: cannot open shared object file: No such file or directory");
}

TEST(FakeSystemTest, FoldersAreThereWithWhatLiesInThem) {
  FakeSystem system;
  system.add_file("/dev/hidraw1").add_file("/dev/hidraw0").add_file("/dev/input/event3");
  EXPECT_THAT(system.list("/dev"), ElementsAre("hidraw0", "hidraw1", "input"));
  EXPECT_THAT(system.list("/dev/"), ElementsAre("hidraw0", "hidraw1", "input"));
  EXPECT_TRUE(system.exists("/dev/input"));
  system.remove("/dev/input/event3");
  EXPECT_FALSE(system.exists("/dev/input"));
}

TEST(FakeSystemTest, LinksLeadToFilesAndFolders) {
  FakeSystem system;
  system.add_file("/sys/devices/usb1/1-2/idVendor", "2988\n")
      .add_link("/sys/bus/usb/devices/1-2", "../../../devices/usb1/1-2")
      .add_link("/sys/round", "/sys/round");
  EXPECT_EQ(system.resolve("/sys/bus/usb/devices/1-2"), "/sys/devices/usb1/1-2");
  EXPECT_EQ(system.read("/sys/bus/usb/devices/1-2/idVendor"), "2988\n");
  EXPECT_THAT(system.list("/sys/bus/usb/devices"), ElementsAre("1-2"));
  EXPECT_THAT(system.list("/sys/bus/usb/devices/1-2"), ElementsAre("idVendor"));
  EXPECT_EQ(system.resolve("/sys/devices/usb1/1-2"), "");
  EXPECT_FALSE(system.exists("/sys/round"));
}

TEST(FakeSystemTest, WhatIsForbiddenIsThereAllTheSame) {
  FakeSystem system;
  system.add_file("/dev/hidraw0").forbid("/dev/hidraw0");
  EXPECT_TRUE(system.exists("/dev/hidraw0"));
  const Result<void> use = system.may_use("/dev/hidraw0");
  ASSERT_FALSE(use);
  EXPECT_EQ(use.error().code, ErrorCode::kIo);
  EXPECT_EQ(use.error().message, "/dev/hidraw0: Permission denied");
  EXPECT_EQ(system.may_use("/dev/hidraw1").error().code, ErrorCode::kNotFound);
  EXPECT_TRUE(system.allow("/dev/hidraw0").may_use("/dev/hidraw0"));
}

TEST(ThisSystemTest, SeesThisMachine) {
  const SystemView& system = this_system();
  EXPECT_THAT(system.list("/proc/self"), ::testing::Contains("limits"));
  EXPECT_THAT(system.read("/proc/self/limits").value_or(""), HasSubstr("Max realtime priority"));
  EXPECT_FALSE(system.user().empty());
  EXPECT_THAT(system.groups(), ::testing::Not(IsEmpty()));
  const Result<void> library = system.try_library("libno-such-library-of-feltline.so");
  ASSERT_FALSE(library);
  EXPECT_THAT(library.error().message, HasSubstr("libno-such-library-of-feltline.so"));
  EXPECT_TRUE(system.try_library("libc.so.6"));
  EXPECT_EQ(system.may_use("/no/such/file").error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace felt::fake_system_test
