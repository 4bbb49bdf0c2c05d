#include "felt/devices/calibrated/calibrated_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>

#include "felt/rt/scripted_device.h"

namespace felt {
namespace {

// A table that leans by 30 degrees, mirrored as a sheet is before a right-handed device.
PlaneCalibration leaning() {
  const double c = std::cos(0.5235987755982988), s = std::sin(0.5235987755982988);
  return *PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, -c, s}, Vec3{0, s, c}}, {40, 30, -5});
}

TEST(CalibratedDevice, MapsPlacesInAndForcesOut) {
  ScriptedDevice inner;
  const PlaneCalibration map = leaning();
  CalibratedDevice device(inner, map);
  inner.sample.position = map.to_device(Vec3{12, 34, -0.5});
  inner.sample.velocity = map.turn_to_device(Vec3{100, -50, 3});
  inner.sample.pressure = 0.25;
  inner.sample.buttons = 5;
  const PenSample sample = device.read(77).value();
  EXPECT_EQ(sample.time_ns, 77);
  EXPECT_NEAR(norm(sample.position - Vec3{12, 34, -0.5}), 0.0, 1e-12);
  EXPECT_NEAR(norm(sample.velocity - Vec3{100, -50, 3}), 0.0, 1e-12);
  EXPECT_EQ(sample.pressure, 0.25);
  EXPECT_EQ(sample.buttons, 5u);
  const Force force{0.1, -0.2, 0.7};
  ASSERT_TRUE(device.write(force).has_value());
  EXPECT_NEAR(work_mj(inner.force, inner.sample.velocity), work_mj(force, sample.velocity), 1e-12);
  EXPECT_GT(inner.force.z, 0.0);
}

// A pen that was somewhere between two ticks, in its own frame.
class BetweenTicks final : public Device {
 public:
  [[nodiscard]] std::string_view name() const noexcept override { return "between"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return none_; }
  tl::expected<PenSample, DeviceFault> read(std::int64_t) noexcept override { return PenSample{}; }
  std::optional<PenSample> between() noexcept override { return std::exchange(waits, {}); }
  tl::expected<void, DeviceFault> write(const Force&) noexcept override { return {}; }
  void stop() noexcept override {}

  std::optional<PenSample> waits;

 private:
  Capabilities none_;
};

TEST(CalibratedDevice, WhatWasBetweenTwoTicksIsMappedToo) {
  BetweenTicks inner;
  const PlaneCalibration map = leaning();
  CalibratedDevice device(inner, map);
  EXPECT_FALSE(device.between().has_value());
  inner.waits = PenSample{3, map.to_device(Vec3{7, 8, 9}), {}, 0.5, 1};
  const std::optional<PenSample> told = device.between();
  ASSERT_TRUE(told.has_value());
  EXPECT_EQ(told->time_ns, 3);
  EXPECT_NEAR(norm(told->position - Vec3{7, 8, 9}), 0.0, 1e-12);
  EXPECT_FALSE(device.between().has_value());
}

TEST(CalibratedDevice, FaultsAndStopsPassThrough) {
  ScriptedDevice inner;
  CalibratedDevice device(inner, leaning());
  EXPECT_EQ(device.name(), inner.name());
  inner.read_fault = DeviceFault::kDisconnected;
  EXPECT_EQ(device.read(1).error(), DeviceFault::kDisconnected);
  inner.write_fault = DeviceFault::kOverheated;
  EXPECT_EQ(device.write({}).error(), DeviceFault::kOverheated);
  device.stop();
  EXPECT_EQ(inner.stops, 1);
}

TEST(CalibratedDevice, TheSameFrameLeavesAllAsItIs) {
  ScriptedDevice inner;
  CalibratedDevice device(inner, PlaneCalibration{});
  inner.sample.position = {1.0 / 3.0, -2.0 / 7.0, 5.5};
  EXPECT_EQ(device.read(5).value(), inner.sample);
  EXPECT_EQ(device.capabilities(), inner.capabilities());
}

}  // namespace
}  // namespace felt
