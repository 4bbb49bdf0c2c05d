// Tests the default position of the surface before a Force Dimension device, and the direction of
// the force on each axis.
#include <gtest/gtest.h>

#include <array>

#include "felt/devices/forcedimension/forcedimension.h"
#include "tests/devices/drivers/forcedimension_bench.h"

namespace felt::plane_test {
namespace {

TEST(ForceDimensionPlane, RightIsYDownIsMinusZAndTheHandIsAtX) {
  const auto driver = make_forcedimension_driver();
  const PlaneCalibration plane = driver->default_plane({}, {});
  EXPECT_EQ(plane.to_page(Vec3{}), Vec3{}) << "the middle of the arm's reach";
  EXPECT_EQ(plane.turn_to_page(Vec3{0, 1, 0}), (Vec3{1, 0, 0}));
  EXPECT_EQ(plane.turn_to_page(Vec3{0, 0, 1}), (Vec3{0, -1, 0}));
  EXPECT_EQ(plane.turn_to_page(Vec3{1, 0, 0}), (Vec3{0, 0, 1}));
  EXPECT_TRUE(plane.mirrors()) << "the device's axes are right-handed, the page's are not";
}

TEST(ForceDimensionPlane, AForceGoesWhereItPointsOnEachAxis) {
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    for (const double sign : {1.0, -1.0}) {
      ForceDimensionBench bench({});
      bench.world().stylus().hold({});  // nobody holds it, so it follows the force
      bench.world().stylus().place({70, 70, 0});
      OpenDevice device(*bench.device(), bench.plane());
      Vec3 first, last;
      for (std::int64_t t = 0; t <= 30'000'000; t += 250'000) {
        bench.before_tick(t);
        const auto sample = device.read(t);
        ASSERT_TRUE(sample.has_value());
        if (t == 0) first = sample->position;
        last = sample->position;
        ASSERT_TRUE(device.write({sign * axis.x, sign * axis.y, sign * axis.z}).has_value());
      }
      const double along = sign * dot(last - first, axis);
      EXPECT_GT(along, 0.5) << axis.x << axis.y << axis.z << " " << sign;
      EXPECT_EQ(bench.broken_rule(), "");
    }
  }
}

// Tests the same in the vendor's axes: +x is towards the user.
TEST(ForceDimensionPlane, TheDriversForceIsInTheDevicesOwnAxes) {
  ForceDimensionBench bench({});
  for (std::int64_t t = 0; t < 10'000'000; t += 250'000) {
    bench.before_tick(t);
    ASSERT_TRUE(bench.device()->read(t).has_value());
    ASSERT_TRUE(bench.device()->write({1.0, 0.5, 0.25}).has_value());
  }
  const Force held = bench.world().held_force();  // in the frame of the surface
  EXPECT_DOUBLE_EQ(held.z, 1.0);
  EXPECT_DOUBLE_EQ(held.x, 0.5);
  EXPECT_DOUBLE_EQ(held.y, -0.25);
}

}  // namespace
}  // namespace felt::plane_test
