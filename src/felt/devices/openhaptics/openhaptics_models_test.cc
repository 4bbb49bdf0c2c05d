#include "felt/devices/openhaptics/openhaptics_models.h"

#include <gtest/gtest.h>

#include <limits>

#include "felt/haptics/safety/safety_limits.h"

namespace felt::openhaptics_models_test {
namespace {

TEST(OpenHapticsModels, AreKnownByTheirWords) {
  EXPECT_EQ(openhaptics_model("PHANToM Omni").id, "omni");
  EXPECT_EQ(openhaptics_model("PHANTOM OMNI").id, "omni");
  EXPECT_EQ(openhaptics_model("Touch").id, "touch");
  EXPECT_EQ(openhaptics_model("Geomagic Touch").id, "touch");
  EXPECT_EQ(openhaptics_model("Geomagic Touch X").id, "touch-x");
  EXPECT_EQ(openhaptics_model("TouchX").id, "touch-x");
  EXPECT_EQ(openhaptics_model("PHANToM Desktop").id, "desktop");
  EXPECT_EQ(openhaptics_model("PHANToM Premium 1.5 6DOF").id, "premium-1.5");
  EXPECT_EQ(openhaptics_model("Premium 3.0").id, "premium-3.0");
  EXPECT_EQ(openhaptics_model("Something new").id, "generic-3dof");
  EXPECT_EQ(openhaptics_model("").id, "generic-3dof");
}

TEST(OpenHapticsModels, TheDevicesOwnWordOnlyLowers) {
  const Capabilities row = openhaptics_model("touch").capabilities;
  HdLimits said;
  EXPECT_EQ(openhaptics_capabilities(row, said), row);
  said.max_force_n = 40.0;
  said.continuous_force_n = 0.5;
  said.max_stiffness_n_per_mm = 0.3;
  said.max_damping_n_s_per_mm = 0.1;
  const Capabilities device = openhaptics_capabilities(row, said);
  EXPECT_EQ(device.max_force_n, row.max_force_n);
  EXPECT_EQ(device.continuous_force_n, 0.5);
  EXPECT_DOUBLE_EQ(device.max_stiffness_n_per_m, 300.0);
  EXPECT_EQ(device.max_damping_n_s_per_m, row.max_damping_n_s_per_m);
}

TEST(OpenHapticsModels, NonsenseIsNotBelieved) {
  const Capabilities row = openhaptics_model("touch").capabilities;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  HdLimits said{nan, -1.0, std::numeric_limits<double>::infinity(), nan, {}, -5};
  said.usable_mm[0] = nan;
  EXPECT_EQ(openhaptics_capabilities(row, said), row);
  said = {.usable_mm = {10, 0, 0, -10, 50, 50}};
  EXPECT_EQ(openhaptics_capabilities(row, said), row);
  said = {.usable_mm = {-80, -60, -35, 80, 1e9, 35}};
  EXPECT_EQ(openhaptics_capabilities(row, said), row);
  said = {.update_rate_hz = 100'000};
  EXPECT_EQ(openhaptics_capabilities(row, said), row);
}

TEST(OpenHapticsModels, WorkspaceAndRateAreTheDevicesOwn) {
  const Capabilities row = openhaptics_model("touch").capabilities;
  const HdLimits said{.usable_mm = {-80, -110, -35, 80, 10, 35}, .update_rate_hz = 500};
  const Capabilities device = openhaptics_capabilities(row, said);
  EXPECT_EQ(device.workspace_min, (Vec3{-80, -110, -35}));
  EXPECT_EQ(device.workspace_max, (Vec3{80, 10, 35}));
  EXPECT_EQ(device.period_ns, 2'000'000);
  EXPECT_GT(limits_for(device).peak_force_n, 0.0);
}

// For a user in front of the device, +x is right, +y up and +z towards the user (OpenHaptics
// reference, "coordinates").
TEST(OpenHapticsModels, TheDefaultPlaneIsTheDeskAndEachAxisHasItsSign) {
  Capabilities device = openhaptics_model("touch").capabilities;
  device.workspace_min = {-80, -110, -20};
  device.workspace_max = {80, 10, 50};
  const PlaneCalibration plane = openhaptics_plane(device);
  EXPECT_TRUE(plane.mirrors());
  EXPECT_EQ(plane.to_page(Vec3{0, -50, 15}), (Vec3{0, 0, 0}));
  EXPECT_EQ(plane.to_page(Vec3{1, -50, 15}), (Vec3{1, 0, 0}));  // right stays right
  EXPECT_EQ(plane.to_page(Vec3{0, -50, 16}), (Vec3{0, 1, 0}));  // towards the user is down the page
  EXPECT_EQ(plane.to_page(Vec3{0, -49, 15}), (Vec3{0, 0, 1}));  // up stays up
  EXPECT_EQ(plane.turn_to_device(Force{1, 0, 0}), (Force{1, 0, 0}));
  EXPECT_EQ(plane.turn_to_device(Force{0, 1, 0}), (Force{0, 0, 1}));
  EXPECT_EQ(plane.turn_to_device(Force{0, 0, 1}), (Force{0, 1, 0}));  // up, away from the desk
}

}  // namespace
}  // namespace felt::openhaptics_models_test
