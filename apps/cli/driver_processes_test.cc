#include "driver_processes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/cli/testing/hostile_driver.h"
#include "felt/driver/testing/fake_system.h"
#include "packed.h"

namespace felt::cli::driver_processes_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Manner = HostileDriver::Manner;

using Drivers = std::vector<std::unique_ptr<Driver>>;

HostileDriver& add(Drivers& drivers, const char* name, Manner manner = Manner::kWell) {
  auto driver = std::make_unique<HostileDriver>(name, manner);
  HostileDriver& added = *driver;
  drivers.push_back(std::move(driver));
  return added;
}

DeviceDescriptor some_device() {
  DeviceDescriptor device;
  device.id = "good:1";
  device.driver = "good";
  device.kind = DeviceKind::kCue;
  device.label = "A pen";
  device.serial = "S\0N";
  device.version = "1.2";
  device.is_connected = false;
  device.has_own_frame = false;
  device.capabilities.max_force_n = 3.3;
  return device;
}

TEST(DriverLookTest, WhatADriverSaysComesBackAsItIs) {
  Drivers drivers;
  HostileDriver& good = add(drivers, "good");
  good.devices = {some_device()};
  good.findings = {{FindingLevel::kProblem,
                    "It is \"broken\"\n",
                    "words\n\ttab",
                    {"a", "b\nc"},
                    SystemFix{"/etc/x", "y", "z"}},
                   {FindingLevel::kOk, "fine"}};
  const std::vector<DriverReport> looks =
      query_drivers(drivers, FakeSystem(), DriverQuery::kFindings);
  ASSERT_THAT(looks, SizeIs(1));
  EXPECT_EQ(looks[0].name, "good");
  EXPECT_EQ(looks[0].label, "Maker of good");
  ASSERT_THAT(looks[0].devices, SizeIs(1));
  const DeviceDescriptor& device = looks[0].devices[0];
  EXPECT_EQ(device.id, "good:1");
  EXPECT_EQ(device.kind, DeviceKind::kCue);
  EXPECT_EQ(device.version, "1.2");
  EXPECT_FALSE(device.is_connected);
  EXPECT_FALSE(device.has_own_frame);
  EXPECT_EQ(device.capabilities, some_device().capabilities);
  ASSERT_THAT(looks[0].findings, SizeIs(2));
  const Finding& finding = looks[0].findings[0];
  EXPECT_EQ(finding.level, FindingLevel::kProblem);
  EXPECT_EQ(finding.what, "It is \"broken\"\n");
  EXPECT_EQ(finding.details, "words\n\ttab");
  EXPECT_THAT(finding.steps, ::testing::ElementsAre("a", "b\nc"));
  ASSERT_TRUE(finding.fix);
  EXPECT_EQ(finding.fix->activate, "z");
  EXPECT_FALSE(looks[0].findings[1].fix);
}

TEST(DriverLookTest, OnlyDevicesWhereNothingElseIsAsked) {
  Drivers drivers;
  add(drivers, "good").findings = {{FindingLevel::kOk, "fine"}};
  EXPECT_THAT(query_drivers(drivers, FakeSystem(), DriverQuery::kDevices)[0].findings, IsEmpty());
}

TEST(DriverLookTest, LibrariesAtTheirWorstSpoilNothingElse) {
  Drivers drivers;
  for (const Manner manner : {Manner::kCrashes, Manner::kExits, Manner::kThrows, Manner::kPrints}) {
    add(drivers, "bad", manner).devices = {some_device()};
  }
  add(drivers, "good").devices = {some_device()};
  const std::vector<DriverReport> looks =
      query_drivers(drivers, FakeSystem(), DriverQuery::kDevices);
  ASSERT_THAT(looks, SizeIs(5));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_THAT(looks[i].devices, IsEmpty()) << i;
    ASSERT_THAT(looks[i].findings, SizeIs(1)) << i;
    EXPECT_EQ(looks[i].findings[0].level, FindingLevel::kProblem);
  }
  EXPECT_THAT(looks[0].findings[0].what, HasSubstr("crashed (Segmentation fault)"));
  EXPECT_EQ(looks[0].findings[0].details, "about to fall over");
  EXPECT_THAT(looks[1].findings[0].what, HasSubstr("ended the program"));
  EXPECT_THAT(looks[1].findings[0].details, HasSubstr("undefined symbol: hdBeginFrame"));
  EXPECT_EQ(looks[2].findings[0].details, "something in C++");
  for (std::size_t i = 3; i < 5; ++i) {
    EXPECT_THAT(looks[i].devices, SizeIs(1)) << i;
    EXPECT_THAT(looks[i].findings, IsEmpty()) << i;
  }
}

TEST(DriverLookTest, ALibraryThatHangsIsLeftAlone) {
  Drivers drivers;
  add(drivers, "bad", Manner::kHangs);
  const std::vector<DriverReport> looks =
      query_drivers(drivers, FakeSystem(), DriverQuery::kDevices, std::chrono::milliseconds(200));
  ASSERT_THAT(looks[0].findings, SizeIs(1));
  EXPECT_THAT(looks[0].findings[0].what, HasSubstr("does not answer"));
}

TEST(PackedTest, WhatIsCutReadsAsEmptyAndSaysSo) {
  Packer packer;
  packer.put("twelve bytes");
  packer.put(3.5);
  for (std::size_t size = 0; size < packer.bytes().size(); ++size) {
    Unpacker bytes(std::string_view(packer.bytes()).substr(0, size));
    bytes.take<std::string>();
    EXPECT_EQ(bytes.take<double>(), 0.0);
    EXPECT_FALSE(bytes.is_good());
  }
  Unpacker whole(packer.bytes());
  EXPECT_EQ(whole.take<std::string>(), "twelve bytes");
  EXPECT_EQ(whole.take<double>(), 3.5);
  EXPECT_TRUE(whole.is_good());
  const std::uint64_t huge = UINT64_MAX;
  Packer lie;
  lie.put(huge);
  EXPECT_EQ(Unpacker(lie.bytes()).take_count(), 0U);
}

}  // namespace
}  // namespace felt::cli::driver_processes_test
