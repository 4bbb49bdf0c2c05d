#include "felt/driver/page_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "felt/driver/open_device.h"
#include "felt/haptics/force.h"
#include "felt/haptics/safety/safety_limits.h"
#include "felt/rt/testing/scripted_device.h"

namespace felt::page_fit_test {
namespace {

constexpr Rect kPage{0, 0, 297, 210};

struct AnyPlane {
  explicit AnyPlane(std::uint32_t seed) : random(seed) {}

  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967295.0);
  }
  Vec3 place(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }
  PlaneCalibration plane(double scale) {
    const double a = between(-3, 3), b = between(-1.5, 1.5);
    const Vec3 x{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
    const Vec3 y{-std::sin(a), std::cos(a), 0};
    const Vec3 z{x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x};
    return *PlaneCalibration::from({x, y, z}, place(200), scale);
  }

  std::mt19937 random;
};

TEST(PageFit, TheMiddleLiesOnTheMiddleOfThePageAndThePlaneStaysWhereItIs) {
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    AnyPlane any(seed);
    const PlaneCalibration plane = any.plane(any.between(0.5, 2));
    const DrawingArea area{any.place(80), any.between(40, 300), any.between(40, 300)};
    const double wanted = any.between(0.5, 2);
    const PlaneCalibration fit = fit_to_page(plane, area, kPage, wanted);
    EXPECT_EQ(fit.scale(), wanted);
    EXPECT_EQ(fit.rows(), plane.rows());
    const Vec3 middle = fit.to_page(area.middle_mm);
    EXPECT_NEAR(middle.x, 148.5, 1e-9);
    EXPECT_NEAR(middle.y, 105.0, 1e-9);
    // Points on the page stay on the page.
    const Vec3 on_page = plane.to_device(Vec3{any.between(0, 300), any.between(0, 200), 0});
    EXPECT_NEAR(fit.to_page(on_page).z, 0.0, 1e-9);
    // A distance that the hand moves is multiplied by the scale on the page.
    const Vec3 a = any.place(60), b = any.place(60);
    EXPECT_NEAR(norm(fit.to_page(a) - fit.to_page(b)), wanted * norm(a - b), 1e-9);
    EXPECT_NEAR(norm(fit.to_device(fit.to_page(a)) - a), 0.0, 1e-9);
  }
}

TEST(PageFit, TheWholePageIsReachedWhereTheScaleAllowsIt) {
  const PlaneCalibration plane;
  EXPECT_NEAR(fit_to_page(plane, {{}, 160, 120}, kPage, {}).scale(), 297.0 / 160.0, 1e-12);
  EXPECT_NEAR(fit_to_page(plane, {{}, 297, 150}, kPage, {}).scale(), 1.4, 1e-12);
  EXPECT_EQ(fit_to_page(plane, {{}, 50, 50}, kPage, {}).scale(), 2.0);
  EXPECT_EQ(fit_to_page(plane, {{}, 5000, 5000}, kPage, {}).scale(), 0.5);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double odd : {nan, 0.0, -3.0}) {
    EXPECT_EQ(fit_to_page(plane, {{}, odd, odd}, kPage, {}).scale(), 1.0);
  }
  EXPECT_EQ(fit_to_page(plane, {{}, 100, 100}, kPage, nan).scale(), 1.0);
  EXPECT_EQ(fit_to_page(plane, {{nan, 0, 0}, 100, 100}, kPage, 1.0), plane);
}

TEST(PageFit, ReachIsWhatAStraightWayThroughTheMiddleHas) {
  Capabilities device;
  device.workspace_min = {-80, 0, -35};
  device.workspace_max = {80, 120, 35};
  const auto upright = *PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}, {});
  const DrawingArea area = reach_of(upright, device);
  EXPECT_EQ(area, (DrawingArea{{0, 60, 0}, 160, 120}));
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    AnyPlane any(seed);
    const PlaneCalibration plane = any.plane(1.0);
    const DrawingArea reach = reach_of(plane, device);
    for (const double side : {-0.5, 0.5}) {
      const Vec3 x = reach.middle_mm + (side * reach.width_mm) * plane.rows()[0];
      const Vec3 y = reach.middle_mm + (side * reach.height_mm) * plane.rows()[1];
      for (const Vec3& p : {x, y}) {
        EXPECT_LE(std::fabs(p.x), 80 + 1e-9);
        EXPECT_LE(std::fabs(p.y - 60), 60 + 1e-9);
        EXPECT_LE(std::fabs(p.z), 35 + 1e-9);
      }
    }
  }
}

// Measures the relations in plane_calibration.h at the device, through OpenDevice.
TEST(ScaledPage, ForceStiffnessDampingAndWorkAreWhatTheHeaderSays) {
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    AnyPlane any(seed);
    const double s = any.between(0.5, 2);
    const PlaneCalibration plane = any.plane(s);
    ScriptedDevice inner;
    OpenDevice device(inner, plane);
    const double stiffness = any.between(100, 900), damping = any.between(0, 3);
    // A spring and a damper on the page, around (100, 80, 0).
    const auto force_at = [&](const Vec3& hand_mm, const Vec3& hand_mm_per_s) {
      inner.sample.position = hand_mm;
      inner.sample.velocity = hand_mm_per_s;
      const PenSample pen = *device.read(1);
      const Vec3 f = (-1e-3 * stiffness) * (pen.position - Vec3{100, 80, 0}) +
                     (-1e-3 * damping) * pen.velocity;
      EXPECT_TRUE(device.write({f.x, f.y, f.z}).has_value());
      EXPECT_NEAR(norm(inner.force), norm(f), 1e-12) << "a newton is a newton";
      EXPECT_NEAR(work_mj(inner.force, hand_mm_per_s) * s,
                  work_mj(Force{f.x, f.y, f.z}, pen.velocity), 1e-9);
      return Vec3{inner.force.x, inner.force.y, inner.force.z};
    };
    const Vec3 at = plane.to_device(Vec3{100, 80, 0});
    const Vec3 way = any.place(5), speed = any.place(300);
    const Vec3 spring = force_at(at + way, {});
    EXPECT_NEAR(norm(spring - (-1e-3 * stiffness * s) * way), 0.0, 1e-9);
    const Vec3 brake = force_at(at, speed);
    EXPECT_NEAR(norm(brake - (-1e-3 * damping * s) * speed), 0.0, 1e-9);
  }
}

TEST(ScaledPage, NoCapOfTheDeviceIsExceededAtTheHand) {
  Capabilities touch;
  touch.max_force_n = 3.3;
  touch.continuous_force_n = 0.88;
  touch.advised_force_n = 2.5;
  touch.max_stiffness_n_per_m = 1e9;  // so high that the stiffness budget is the limit
  touch.max_damping_n_s_per_m = 4;
  touch.position_step_mm = 0.055;
  const SafetyLimits plain = limits_for(touch);
  for (const double s : {0.5, 0.8, 1.0, 1.25, 2.0}) {
    SCOPED_TRACE(s);
    const auto plane = *PlaneCalibration::from({Vec3{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}, {}, s);
    const Capabilities mapped = plane.to_page(touch);
    const SafetyLimits limits = limits_for(mapped);
    EXPECT_TRUE(is_sound(limits));
    EXPECT_EQ(limits.peak_force_n, plain.peak_force_n);
    EXPECT_EQ(limits.continuous_force_n, plain.continuous_force_n);
    EXPECT_LE(s * limits.budget_fast_n_per_m, 900.0 + 1e-9);
    EXPECT_LE(s * limits.max_damping_n_s_per_m, plain.max_damping_n_s_per_m + 1e-9);
    EXPECT_NEAR(mapped.max_damping_n_s_per_m * s, touch.max_damping_n_s_per_m, 1e-9);
    EXPECT_NEAR(mapped.position_step_mm, s * 0.055, 1e-12);
    EXPECT_LE(limits.cut_m_per_s / s, plain.cut_m_per_s + 1e-12);
    Capabilities soft = touch;
    soft.max_stiffness_n_per_m = 400;
    EXPECT_NEAR(s * limits_for(plane.to_page(soft)).max_stiffness_n_per_m, 360.0, 1e-9);
  }
}

TEST(ScaledPage, AScaleOutOfBoundsIsNoMap) {
  const std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  for (const double odd : {0.0, -1.0, 0.49, 2.01, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(PlaneCalibration::from(rows, {}, odd).has_value()) << odd;
  }
}

}  // namespace
}  // namespace felt::page_fit_test
