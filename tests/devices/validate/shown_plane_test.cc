#include <gtest/gtest.h>

#include "felt/replay/live_loop.h"
#include "felt/replay/testing/zigzag_driver.h"
#include "felt/validate/driver_subject.h"

namespace felt::shown_plane_test {
namespace {

// Some libraries report the serial number only after the device is open.
TEST(ShownPlane, OfAnotherUnitIsNotUsed) {
  ZigzagWorld world;
  world.gone_after_reads = 1 << 30;
  ZigzagDriver driver(world);
  driver.give_own_frame();
  driver.report_serial_once_open("THIS-1");
  for (const bool same : {false, true}) {
    RealDevice device{&driver, driver.device(), {.device_id = "zigzag:1"}};
    device.profile.serial = same ? "THIS-1" : "OTHER-42";
    device.profile.plane =
        PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}, {900, 900, 70}, 1.0);
    ASSERT_TRUE(device.profile.plane);
    const Vec3 shown = device.profile.plane->to_page(driver.device().capabilities).workspace_min;
    auto loop = LiveLoop::start(device, {0, 0, 297, 210}, 3.0, {});
    ASSERT_TRUE(loop) << loop.error().message;
    EXPECT_EQ((*loop)->device().capabilities().workspace_min == shown, same);
    EXPECT_TRUE((*loop)->stop());
    DriverSubject subject(driver, driver.device(), {}, device.profile);
    ASSERT_TRUE(subject.open());
    EXPECT_EQ(subject.device()->capabilities().workspace_min == shown, same) << "device-test";
  }
}

}  // namespace
}  // namespace felt::shown_plane_test
