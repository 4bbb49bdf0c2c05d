#include "felt/driver/calibrated_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>

#include "felt/rt/testing/scripted_device.h"

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

// The same pen in the same hand leans more or less with how the board is set up before it.
TEST(CalibratedDevice, ThePenLeansAgainstTheSheetNotTheDevice) {
  ScriptedDevice inner;
  CalibratedDevice device(inner, leaning());
  EXPECT_EQ(device.read(1)->lean_deg, std::nullopt) << "no device, no lean";
  const PlaneCalibration map = leaning();
  inner.axis = map.rows()[2];  // out of the sheet
  EXPECT_EQ(device.read(2)->lean_deg, 0.0);
  inner.axis = Vec3{0, 0, 1};  // the device's own upright: the table leans by 30 degrees
  EXPECT_EQ(device.read(3)->lean_deg, 30.0);
  inner.axis = 7.5 * map.rows()[0];  // of any length, in the sheet
  EXPECT_EQ(device.read(4)->lean_deg, 90.0);
  inner.axis = map.rows()[2] - map.rows()[1];
  EXPECT_EQ(device.read(5)->lean_deg, 45.0);
}

TEST(CalibratedDevice, TheScaleOfTheSheetTurnsNoPen) {
  ScriptedDevice inner;
  inner.axis = Vec3{1, 2, 4};
  const auto lean = [&](double scale) {
    CalibratedDevice device(inner, *PlaneCalibration::from(leaning().rows(), {1, 2, 3}, scale));
    return device.read(1)->lean_deg;
  };
  EXPECT_EQ(lean(0.5), lean(1.0));
  EXPECT_EQ(lean(2.0), lean(1.0));
}

TEST(CalibratedDevice, AnAxisWithoutDirectionIsNoLean) {
  ScriptedDevice inner;
  CalibratedDevice device(inner, leaning());
  inner.sample.lean_deg = 12.0;
  EXPECT_EQ(device.read(1)->lean_deg, 12.0) << "what a device says by itself is kept";
  for (const Vec3& axis : {Vec3{}, Vec3{std::nan(""), 0, 1}, Vec3{HUGE_VAL, 0, 1}}) {
    inner.axis = axis;
    EXPECT_EQ(device.read(1)->lean_deg, std::nullopt);
  }
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

TEST(CalibratedDevice, APersonsProfileIsItsPlaneAndItsLimits) {
  ScriptedDevice inner;
  DeviceProfile profile;
  const CalibratedDevice bare(inner, profile, leaning());
  EXPECT_EQ(bare.calibration(), leaning());
  EXPECT_EQ(bare.capabilities(), leaning().to_sheet(inner.capabilities()));
  profile.plane = PlaneCalibration::from(leaning().rows(), {1, 2, 3}, 2.0);
  profile.stiffness_cap_n_per_m = 100;
  profile.force_limit_n = 0.5;
  const CalibratedDevice set(inner, profile, leaning());
  EXPECT_EQ(set.calibration(), *profile.plane);
  EXPECT_EQ(set.capabilities().max_stiffness_n_per_m, 50.0) << "100 N/m at the hand";
  EXPECT_EQ(set.capabilities().advised_force_n, 0.5);
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
