#include "felt/tools/pressing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "felt/haptics/safety/safety_guards.h"
#include "felt/stroke/fit/width_map.h"

namespace felt::pressing_test {
namespace {

const SurfaceMaterial& paper() {
  return surface_materials().front();
}

PenSample at_depth(double mm) {
  PenSample s;
  s.position.z = -mm;
  return s;
}

TEST(Pressing, R14_GrowsWithDepthAndIsExactAtTheClamps) {
  const WidthMapOptions widths;
  for (const SurfaceMaterial& surface : surface_materials()) {
    SCOPED_TRACE(surface.id);
    const Pressing pressing(surface, {});
    double last = 0.0;
    for (int k = -1000; k <= 10000; ++k) {
      const double p = pressing.of(at_depth(0.001 * k)).value();
      const double width = width_of_pressure(widths, p);
      EXPECT_GE(width, last) << k;
      last = width;
    }
    EXPECT_EQ(last, widths.max_mm);
    const double k_mm = 0.001 * pressing.stiffness_n_per_m();
    EXPECT_EQ(pressing.of(at_depth(0.1 / k_mm * (1 - 1e-12))).value(), 0.0);
    EXPECT_EQ(width_of_pressure(widths, pressing.of(at_depth(0.0)).value()), widths.min_mm);
    EXPECT_GT(pressing.of(at_depth(0.1 / k_mm + 0.001)).value(), 0.0);
    EXPECT_LT(pressing.of(at_depth(1.2 / k_mm - 0.001)).value(), 1.0);
    EXPECT_EQ(pressing.of(at_depth(1.2 / k_mm + 0.001)).value(), 1.0);
  }
}

TEST(Pressing, R14_TheSpringForceDecidesNotTheDepth) {
  const Pressing on_paper(*find_surface("paper"), {}), on_felt(*find_surface("felt"), {});
  ASSERT_EQ(on_paper.stiffness_n_per_m(), 500.0);
  ASSERT_EQ(on_felt.stiffness_n_per_m(), 300.0);
  for (int k = 0; k <= 300; ++k) {
    const double force = 0.01 * k;
    const double p = on_paper.of(at_depth(force / 0.5)).value();
    EXPECT_NEAR(p, on_felt.of(at_depth(force / 0.3)).value(), 1e-12);
    EXPECT_NEAR(p, on_paper.of_force(force), 1e-12);
  }
  // The same depth gives a different force.
  EXPECT_GT(on_paper.of(at_depth(2)).value(), on_felt.of(at_depth(2)).value() + 0.15);
}

TEST(Pressing, R14_TheStiffnessIsTheOneThatTheDeviceRenders) {
  const SurfaceMaterial& glass = *find_surface("glass");
  EXPECT_EQ(Pressing(glass, {}).stiffness_n_per_m(), 800.0);
  EXPECT_EQ(Pressing(glass, {.max_stiffness_n_per_m = 400}).stiffness_n_per_m(), 360.0);
  EXPECT_EQ(Pressing(glass, {.max_stiffness_n_per_m = 3000}).stiffness_n_per_m(), 800.0);
}

TEST(Pressing, R14_FullWidthIsWhatTheMotorsHoldForEver) {
  EXPECT_EQ(Pressing(paper(), {.continuous_force_n = 0.0}).max_n(), 1.2);
  EXPECT_EQ(Pressing(paper(), {.continuous_force_n = 8.0}).max_n(), 1.2);
  const Capabilities touch{.max_force_n = 3.3, .continuous_force_n = 0.88};
  MotorGuard motors(limits_for(touch));
  for (int i = 0; i < 120'000; ++i) motors.heat(motors.allowed_n(), 0.001);
  const double slides_n = Pressing(paper(), touch).max_n() * std::hypot(1.0, 0.6);
  EXPECT_NEAR(slides_n, motors.allowed_n(), 0.01);
  // F1 also does not exceed the force that the device can render.
  EXPECT_LE(Pressing(paper(), {.max_force_n = 1.0}).max_n(), 0.9);
  // Even a weak device has a usable range.
  const Pressing weak(paper(), {.continuous_force_n = 1e-6});
  EXPECT_GT(weak.max_n(), 0.1);
  EXPECT_EQ(weak.of_force(0.1), 0.0);
  EXPECT_EQ(weak.of_force(1.0), 1.0);
}

// Beyond the user's force limit the surface yields and the depth no longer measures the force, so
// the line has its full width below this limit.
TEST(Pressing, R14_FullWidthIsWithinTheUsersForceLimit) {
  const Capabilities touch{.max_force_n = 3.3, .continuous_force_n = 0.88};
  for (const double limit_n : {0.25, 0.3, 0.4}) {
    const Capabilities limited = with_force_limit(touch, limit_n);
    const Pressing pressing(paper(), limited);
    EXPECT_LE(pressing.max_n() * std::hypot(1.0, 0.6), limit_n + 1e-12);
    EXPECT_EQ(pressing.of_force(limits_for(touch, limit_n).peak_force_n), 1.0);
    EXPECT_GT(pressing.max_n(), Pressing::kMinN);
    EXPECT_EQ(pressing.stiffness_n_per_m(), Pressing(paper(), touch).stiffness_n_per_m());
  }
  EXPECT_EQ(Pressing(paper(), with_force_limit(touch, 3.0)).max_n(),
            Pressing(paper(), touch).max_n());
}

TEST(Pressing, R18_ADeviceThatSensesPressureSaysIt) {
  const Pressing pressing(paper(), {.senses_pressure = true});
  PenSample s = at_depth(1.7);
  for (int k = 0; k <= 100; ++k) {
    s.pressure = 0.01 * k;
    EXPECT_EQ(pressing.of(s).value(), 0.01 * k);
  }
  s.pressure = 7.0;
  EXPECT_EQ(pressing.of(s).value(), 1.0);
  s.pressure = -1.0;
  EXPECT_EQ(pressing.of(s).value(), 0.0);
  // An invalid pressure is ignored, and the depth is used instead.
  s.pressure = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(pressing.of(s), pressing.of(at_depth(1.7)));
}

TEST(Pressing, R18_AMouseHasNone) {
  const Pressing pressing(paper(), {.sensed_axes = 2});
  EXPECT_FALSE(pressing.of(at_depth(1.0)));
}

}  // namespace
}  // namespace felt::pressing_test
