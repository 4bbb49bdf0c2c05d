#include "felt/rt/null_device.h"

#include <gtest/gtest.h>

#include "felt/base/constants.h"

namespace felt::null_device_test {
namespace {

TEST(NullDevice, R51_ThePenIsWhereTheMouseIsAndForcesDoNothing) {
  NullDevice device;
  device.aim({10.0, 20.0, -1.0}, 0.5, 1);
  for (int i = 0; i < 50; ++i) {
    const auto sample = device.read(i * kMs);
    ASSERT_TRUE(sample.has_value());
    EXPECT_EQ(sample->time_ns, i * kMs);
    EXPECT_EQ(sample->position, (Vec3{10.0, 20.0, -1.0}));
    EXPECT_EQ(sample->pressure, 0.5);
    EXPECT_EQ(sample->buttons, 1U);
    EXPECT_EQ(sample->velocity, Vec3{});
    EXPECT_TRUE(device.write({3.0, -2.0, 1.0}).has_value());
  }
}

TEST(NullDevice, ThePenTiltsAsTheHandSays) {
  NullDevice device;
  device.aim({{1, 2, -1}, 0.5, 1, 32.5});
  EXPECT_EQ(device.read(0)->tilt_deg, 32.5);
  device.aim({1, 2, -1}, 0.5, 1);
  EXPECT_EQ(device.read(1 * kMs)->tilt_deg, std::nullopt);
}

TEST(NullDevice, R55_HasNoForcesWhateverItIsTold) {
  Capabilities wishes;
  wishes.max_force_n = 3.0;
  wishes.continuous_force_n = 1.0;
  wishes.period_ns = 2 * kMs;
  const NullDevice device(wishes);
  EXPECT_FALSE(device.capabilities().has_force());
  EXPECT_EQ(device.capabilities().continuous_force_n, 0.0);
  EXPECT_EQ(device.capabilities().period_ns, 2 * kMs);
}

TEST(NullDevice, VelocityIsThatOfThePoseLowPassed) {
  NullDevice device;
  Vec3 velocity;
  for (int i = 0; i < 200; ++i) {
    device.aim({0.1 * i, 0.0, 1.0}, {}, 0);  // 100 mm/s
    velocity = device.read(i * kMs)->velocity;
    EXPECT_LE(velocity.x, 100.0 + 1e-9);
  }
  EXPECT_NEAR(velocity.x, 100.0, 0.01);
  EXPECT_NEAR(velocity.z, 0.0, 1.0);
}

TEST(NullDevice, StartsAboveThePageAndStaysWhereItWasAimed) {
  NullDevice device;
  EXPECT_FALSE(in_contact(*device.read(0)));
  device.aim({1.0, 2.0, -0.5}, {}, 0);
  EXPECT_TRUE(in_contact(*device.read(kMs)));
  device.stop();
  EXPECT_TRUE(in_contact(*device.read(2 * kMs)));
}

TEST(DeviceFault, EachHasASentence) {
  for (const DeviceFault fault :
       {DeviceFault::kDisconnected, DeviceFault::kNotCalibrated, DeviceFault::kForcesOff,
        DeviceFault::kOverheated, DeviceFault::kBadData, DeviceFault::kOther}) {
    EXPECT_EQ(describe(fault).back(), '.');
    EXPECT_EQ(describe(fault) == describe(DeviceFault::kOther), fault == DeviceFault::kOther);
  }
}

}  // namespace
}  // namespace felt::null_device_test
