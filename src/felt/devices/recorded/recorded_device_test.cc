#include "felt/devices/recorded/recorded_device.h"

#include <limits>

#include <gtest/gtest.h>

#include "felt/base/constants.h"

namespace felt::recorded_device_test {
namespace {

PenSample sample(std::int64_t ms, double x, double z, std::optional<double> pressure = {},
                 std::uint32_t buttons = 0) {
  return {.time_ns = ms * kMs,
          .position = {x, 0, z},
          .velocity = {},
          .pressure = pressure,
          .buttons = buttons};
}

TEST(RecordedDevice, InterpolatesAtTheLoopsTimes) {
  RecordedDevice device({sample(10, 0, 1), sample(20, 10, -1, 0.5, 1), sample(30, 10, -1, 0.7, 1)},
                        {});
  EXPECT_EQ(device.read(0)->position, (Vec3{0, 0, 1}));
  EXPECT_EQ(device.read(10 * kMs)->position, (Vec3{0, 0, 1}));
  const PenSample between = device.read(15 * kMs).value();
  EXPECT_EQ(between.position, (Vec3{5, 0, 0}));
  EXPECT_EQ(between.time_ns, 15 * kMs);
  EXPECT_FALSE(between.pressure.has_value()) << "pressure and buttons are the earlier sample's";
  EXPECT_EQ(between.buttons, 0u);
  EXPECT_NEAR(device.read(25 * kMs)->pressure.value(), 0.6, 1e-12);
  EXPECT_FALSE(device.is_over());
  EXPECT_EQ(device.read(99 * kMs)->position, (Vec3{10, 0, -1}));
  EXPECT_TRUE(device.is_over());
}

TEST(RecordedDevice, TiltsAsThePenDid) {
  std::vector<PenSample> recording{sample(10, 0, -1), sample(20, 1, -1), sample(30, 2, -1)};
  recording[0].tilt_deg = 20.0;
  recording[1].tilt_deg = 50.0;
  RecordedDevice device(recording, {});
  EXPECT_EQ(device.read(0)->tilt_deg, 20.0);
  EXPECT_NEAR(device.read(15 * kMs)->tilt_deg.value(), 35.0, 1e-12);
  EXPECT_EQ(device.read(25 * kMs)->tilt_deg, 50.0) << "what comes next does not say";
  EXPECT_EQ(device.read(30 * kMs)->tilt_deg, std::nullopt);
}

TEST(RecordedDevice, BeforeItsStartThePenIsInTheAir) {
  RecordedDevice device({sample(10, 3, -1, 0.5, 1)}, {});
  EXPECT_FALSE(in_contact(device.read(0).value()));
  EXPECT_TRUE(in_contact(device.read(10 * kMs).value()));
}

TEST(RecordedDevice, DerivesTheVelocity) {
  RecordedDevice device({sample(0, 0, 1), sample(1000, 50, 1)}, {});
  PenSample s;
  for (int ms = 0; ms < 100; ++ms) s = device.read(ms * kMs).value();
  EXPECT_NEAR(s.velocity.x, 50.0, 1e-6);
}

// The recording has a dot of 0.4 ms between two ticks, and a lift that is as short.
TEST(RecordedDevice, LosesNoDotAndNoLiftInASlowLoop) {
  std::vector<PenSample> recording;
  for (int ms = 0; ms < 40; ++ms) {
    const bool down = ms == 9 || (ms > 20 && ms != 25 && ms < 30);
    recording.push_back(sample(ms, 1, down ? -1 : 1));
  }
  RecordedDevice device(recording, {});
  int touches = 0;
  bool touching = false;
  for (int ms = 0; ms < 40; ms += 4) {
    const bool now = in_contact(device.read(ms * kMs).value());
    touches += now && !touching ? 1 : 0;
    touching = now;
  }
  EXPECT_EQ(touches, 3);
}

TEST(RecordedDevice, RemembersForcesAndObeysNone) {
  RecordedDevice device({sample(0, 7, 1)}, {});
  ASSERT_TRUE(device.write({1, 2, 3}).has_value());
  EXPECT_EQ(device.last_force(), (Force{1, 2, 3}));
  EXPECT_EQ(device.read(5 * kMs)->position, (Vec3{7, 0, 1}));
  device.stop();
  EXPECT_EQ(device.last_force(), Force{});
}

TEST(RecordedDevice, SurvivesBadRecordings) {
  EXPECT_EQ(RecordedDevice({}, {}).read(0).error(), DeviceFault::kBadData);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  RecordedDevice device({sample(5, 1, 1), sample(3, 2, 1), sample(4, nan, 1), sample(9, 4, 1)}, {});
  for (int ms = 0; ms < 20; ++ms) {
    const auto s = device.read(ms * kMs);
    ASSERT_TRUE(s.has_value());
    EXPECT_TRUE(is_finite(s->position) && is_finite(s->velocity));
  }
  EXPECT_EQ(device.read(1)->time_ns, 1) << "a clock that is set back is no error";
}

}  // namespace
}  // namespace felt::recorded_device_test
