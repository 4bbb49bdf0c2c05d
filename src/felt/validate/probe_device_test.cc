#include "felt/validate/probe_device.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "felt/rt/testing/scripted_device.h"

namespace felt::probe_device_test {
namespace {

std::vector<ProbeTick> taken(ProbeDevice& probe) {
  std::vector<ProbeTick> ticks;
  for (ProbeTick tick; probe.ticks().pop(tick);) ticks.push_back(tick);
  return ticks;
}

TEST(ProbeDeviceTest, NotesWhatGoesThroughUnchanged) {
  ScriptedDevice device;
  ProbeDevice probe(device);
  device.sample.position = {1, 2, 3};
  ASSERT_TRUE(probe.read(5));
  ASSERT_TRUE(probe.write({0.1, 0.2, 0.3}));
  EXPECT_EQ(device.force, (Force{0.1, 0.2, 0.3}));
  device.read_fault = DeviceFault::kDisconnected;
  EXPECT_FALSE(probe.read(6));
  device.write_fault = DeviceFault::kOverheated;
  EXPECT_EQ(probe.write({}).error(), DeviceFault::kOverheated);
  const std::vector<ProbeTick> ticks = taken(probe);
  ASSERT_EQ(ticks.size(), 2U);
  EXPECT_EQ(ticks[0].now_ns, 5);
  EXPECT_EQ(ticks[0].sample.position, (Vec3{1, 2, 3}));
  EXPECT_EQ(ticks[0].force, (Force{0.1, 0.2, 0.3}));
  EXPECT_FALSE(ticks[0].read_fault);
  EXPECT_EQ(ticks[1].read_fault, DeviceFault::kDisconnected);
  EXPECT_EQ(ticks[1].write_fault, DeviceFault::kOverheated);
}

TEST(ProbeDeviceTest, OutsideTheBallThereIsNoForceAnyMore) {
  ScriptedDevice device;
  ProbeDevice probe(device);
  probe.guard({0, 0, 0}, 15.0);
  device.sample.position = {14.9, 0, 0};
  ASSERT_TRUE(probe.read(1));
  ASSERT_TRUE(probe.write({0.3, 0, 0}));
  EXPECT_EQ(device.force.x, 0.3);
  device.sample.position = {15.1, 0, 0};
  ASSERT_TRUE(probe.read(2));
  ASSERT_TRUE(probe.write({0.3, 0, 0}));
  EXPECT_EQ(device.force.x, 0.0);
  EXPECT_TRUE(probe.has_tripped());
  device.sample.position = {0, 0, 0};
  ASSERT_TRUE(probe.read(3));
  ASSERT_TRUE(probe.write({0.3, 0, 0}));
  EXPECT_EQ(device.force.x, 0.0);
}

TEST(ProbeDeviceTest, APlaceThatIsNoNumberIsOutside) {
  ScriptedDevice device;
  ProbeDevice probe(device);
  probe.guard({0, 0, 0}, 15.0);
  device.sample.position.x = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(probe.read(1));
  EXPECT_TRUE(probe.has_tripped());
}

TEST(ProbeDeviceTest, TheTickAfterAStallIsMarkedOnce) {
  ScriptedDevice device;
  ProbeDevice probe(device);
  probe.note_stall();
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(probe.read(i));
    ASSERT_TRUE(probe.write({}));
  }
  const std::vector<ProbeTick> ticks = taken(probe);
  EXPECT_TRUE(ticks[0].after_stall);
  EXPECT_FALSE(ticks[1].after_stall);
}

}  // namespace
}  // namespace felt::probe_device_test
