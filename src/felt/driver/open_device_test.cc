#include "felt/driver/open_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "felt/driver/testing/scripted_driver.h"
#include "felt/rt/testing/scripted_device.h"

namespace felt::open_device_test {
namespace {

// Returns the plane of a table tilted by 30 degrees. It mirrors, because the device's frame is
// right-handed.
PlaneCalibration leaning() {
  const double c = std::cos(0.5235987755982988), s = std::sin(0.5235987755982988);
  return *PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, -c, s}, Vec3{0, s, c}}, {40, 30, -5});
}

TEST(OpenDevice, MapsPlacesInAndForcesOut) {
  ScriptedDevice inner;
  const PlaneCalibration map = leaning();
  OpenDevice device(inner, map);
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

// The tilt of the pen is measured against the surface. So it changes with the tilt of the board,
// even if the pen does not move.
TEST(OpenDevice, ThePenTiltsAgainstThePageNotTheDevice) {
  ScriptedDevice inner;
  OpenDevice device(inner, leaning());
  EXPECT_EQ(device.read(1)->tilt_deg, std::nullopt) << "no device, no tilt";
  const PlaneCalibration map = leaning();
  inner.axis = map.rows()[2];  // normal to the surface
  EXPECT_EQ(device.read(2)->tilt_deg, 0.0);
  inner.axis = Vec3{0, 0, 1};  // the device's z axis, because the table is tilted by 30 degrees
  EXPECT_EQ(device.read(3)->tilt_deg, 30.0);
  inner.axis = 7.5 * map.rows()[0];  // parallel to the surface, not of length 1
  EXPECT_EQ(device.read(4)->tilt_deg, 90.0);
  inner.axis = map.rows()[2] - map.rows()[1];
  EXPECT_EQ(device.read(5)->tilt_deg, 45.0);
}

TEST(OpenDevice, TheScaleOfThePageTurnsNoPen) {
  ScriptedDevice inner;
  inner.axis = Vec3{1, 2, 4};
  const auto tilt = [&](double scale) {
    OpenDevice device(inner, *PlaneCalibration::from(leaning().rows(), {1, 2, 3}, scale));
    return device.read(1)->tilt_deg;
  };
  EXPECT_EQ(tilt(0.5), tilt(1.0));
  EXPECT_EQ(tilt(2.0), tilt(1.0));
}

TEST(OpenDevice, AnAxisWithoutDirectionIsNoTilt) {
  ScriptedDevice inner;
  OpenDevice device(inner, leaning());
  inner.sample.tilt_deg = 12.0;
  EXPECT_EQ(device.read(1)->tilt_deg, 12.0) << "what a device says by itself is kept";
  for (const Vec3& axis : {Vec3{}, Vec3{std::nan(""), 0, 1}, Vec3{HUGE_VAL, 0, 1}}) {
    inner.axis = axis;
    EXPECT_EQ(device.read(1)->tilt_deg, std::nullopt);
  }
}

// A device that reports a sample between two ticks, in its own frame.
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

TEST(OpenDevice, WhatWasBetweenTwoTicksIsMappedToo) {
  BetweenTicks inner;
  const PlaneCalibration map = leaning();
  OpenDevice device(inner, map);
  EXPECT_FALSE(device.between().has_value());
  inner.waits = PenSample{3, map.to_device(Vec3{7, 8, 9}), {}, 0.5, 1};
  const std::optional<PenSample> reported = device.between();
  ASSERT_TRUE(reported.has_value());
  EXPECT_EQ(reported->time_ns, 3);
  EXPECT_NEAR(norm(reported->position - Vec3{7, 8, 9}), 0.0, 1e-12);
  EXPECT_FALSE(device.between().has_value());
}

TEST(OpenDevice, FaultsAndStopsPassThrough) {
  ScriptedDevice inner;
  OpenDevice device(inner, leaning());
  EXPECT_EQ(device.name(), inner.name());
  inner.read_fault = DeviceFault::kDisconnected;
  EXPECT_EQ(device.read(1).error(), DeviceFault::kDisconnected);
  inner.write_fault = DeviceFault::kOverheated;
  EXPECT_EQ(device.write({}).error(), DeviceFault::kOverheated);
  device.stop();
  EXPECT_EQ(inner.stops, 1);
}

std::unique_ptr<OpenDevice> opened(const std::shared_ptr<ScriptedArm>& arm,
                                   const DeviceSetup& setup) {
  ScriptedDriver driver(arm);
  return *OpenDevice::open(driver, arm->descriptor, setup);
}

TEST(OpenDevice, AProfileIsItsPlaneAndItsLimits) {
  const auto arm = std::make_shared<ScriptedArm>();
  const Capabilities& can = arm->descriptor.capabilities;
  const auto device = opened(arm, {});
  const PlaneCalibration usual = ScriptedDriver(arm).default_plane(arm->descriptor, {});
  EXPECT_EQ(device->plane(), usual);
  EXPECT_EQ(device->capabilities(), usual.to_page(can));
  DeviceProfile profile;
  profile.plane = PlaneCalibration::from(leaning().rows(), {1, 2, 3}, 2.0);
  profile.stiffness_cap_n_per_m = 100;
  profile.force_limit_n = 0.5;
  device->set_profile(profile);
  EXPECT_EQ(device->plane(), *profile.plane);
  EXPECT_EQ(device->default_plane(), usual);
  EXPECT_EQ(device->capabilities().max_stiffness_n_per_m, 50.0) << "100 N/m at the hand";
  EXPECT_EQ(device->capabilities().advised_force_n, 0.5);
  EXPECT_EQ(device->device_capabilities(), can);
  profile.serial = "OTHER-42";
  device->set_profile(profile);
  EXPECT_EQ(device->plane(), usual) << "that plane was set with another unit";
  EXPECT_EQ(device->capabilities().advised_force_n, 0.5);
}

TEST(OpenDevice, WithoutAPlaneOfTheUserTheReachIsOnThePage) {
  const auto arm = std::make_shared<ScriptedArm>();
  const auto device = opened(arm, {.page = Rect{0, 0, 300, 200}});
  const Capabilities& can = device->capabilities();
  EXPECT_NEAR(0.5 * (can.workspace_min.x + can.workspace_max.x), 150.0, 1e-9);
  EXPECT_NEAR(0.5 * (can.workspace_min.y + can.workspace_max.y), 100.0, 1e-9);
  EXPECT_EQ(device->plane().scale(), 1.0);
}

TEST(OpenDevice, ADeviceWithoutAFrameOfItsOwnHasNoPlane) {
  const auto arm = std::make_shared<ScriptedArm>();
  arm->descriptor.has_own_frame = false;
  DeviceProfile profile;
  profile.plane = leaning();
  profile.force_limit_n = 0.5;
  const auto device = opened(arm, {.profile = profile, .page = Rect{0, 0, 300, 200}});
  EXPECT_EQ(device->plane(), PlaneCalibration());
  EXPECT_EQ(device->capabilities().advised_force_n, 0.5);
}

TEST(OpenDevice, HomingAndStatusAreTheDevices) {
  const auto arm = std::make_shared<ScriptedArm>();
  arm->homing = Homing::kInkwell;
  arm->vendor_words = "error 7";
  const auto device = opened(arm, {.driver_lock = std::make_shared<std::timed_mutex>()});
  EXPECT_EQ(device->homing(), Homing::kInkwell);
  EXPECT_EQ(device->read(1).error(), DeviceFault::kNotCalibrated);
  EXPECT_EQ(device->status().vendor_words.view(), "error 7");
  ASSERT_TRUE(device->find_home());
  EXPECT_EQ(device->homing(), Homing::kNone);
  EXPECT_TRUE(device->read(2).has_value());
}

TEST(OpenDevice, IsAbandonedIfItsDriverHangs) {
  const auto arm = std::make_shared<ScriptedArm>();
  const auto lock = std::make_shared<std::timed_mutex>();
  opened(arm, {.driver_lock = lock}).reset();
  EXPECT_EQ(arm->closed, 1);
  auto device = opened(arm, {.driver_lock = lock});
  const std::lock_guard hanging(*lock);
  std::thread([&device] { device.reset(); }).join();
  EXPECT_EQ(arm->opened, 2);
  EXPECT_EQ(arm->closed, 1) << "closing would hang, too";
}

TEST(OpenDevice, TheSameFrameLeavesAllAsItIs) {
  ScriptedDevice inner;
  OpenDevice device(inner, PlaneCalibration{});
  inner.sample.position = {1.0 / 3.0, -2.0 / 7.0, 5.5};
  EXPECT_EQ(device.read(5).value(), inner.sample);
  EXPECT_EQ(device.capabilities(), inner.capabilities());
}

}  // namespace
}  // namespace felt::open_device_test
