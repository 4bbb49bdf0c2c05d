#include "felt/driver/plane_calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace felt::plane_calibration_test {
namespace {

// A random rigid map: a rotation around any axis by any angle, an offset, and maybe a mirroring.
struct AnyMap {
  explicit AnyMap(std::uint32_t seed) : random(seed) {}

  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967295.0);
  }
  Vec3 place(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }

  PlaneCalibration map(bool mirrored) {
    Vec3 x = place(1.0), y = place(1.0);
    x = (1.0 / norm(x)) * x;
    y = y - dot(x, y) * x;
    y = (1.0 / norm(y)) * y;
    const Vec3 z{x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x};
    return *PlaneCalibration::from({x, y, mirrored ? -z : z}, place(300.0));
  }

  std::mt19937 random;
};

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(PlaneCalibration, ThereAndBackIsTheSamePlaceAndPowerIsKept) {
  for (std::uint32_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    AnyMap any(seed);
    const PlaneCalibration map = any.map(seed % 2 == 0);
    const Vec3 p = any.place(500.0), v = any.place(400.0), f = any.place(3.0);
    expect_near(map.to_device(map.to_page(p)), p, 1e-9);
    expect_near(map.turn_to_device(map.turn_to_page(v)), v, 1e-9);
    EXPECT_NEAR(norm(map.turn_to_page(v)), norm(v), 1e-9);
    // Work in the frame of the surface equals work in the frame of the device.
    const Force page_force{f.x, f.y, f.z};
    EXPECT_NEAR(work_mj(page_force, map.turn_to_page(v)),
                work_mj(map.turn_to_device(page_force), v), 1e-9);
    EXPECT_EQ(map.mirrors(), seed % 2 == 0);
  }
}

TEST(PlaneCalibration, FindsAnyPlaneFromTouchesThatAreExact) {
  for (std::uint32_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    AnyMap any(seed);
    const bool right_handed = seed % 3 != 0;
    const PlaneCalibration truth = any.map(right_handed);
    std::vector<PlaneTouch> touches;
    for (const Point at : {Point{10, 20}, {150, 25}, {15, 110}, {140, 120}, {80, 60}}) {
      if (touches.size() == 3 + seed % 3) break;
      touches.push_back({truth.to_device(Vec3{at.x, at.y, 0.0}), at});
    }
    const Result<PlaneFit> fit =
        fit_plane(touches, right_handed ? Handedness::kRight : Handedness::kLeft);
    ASSERT_TRUE(fit.has_value());
    EXPECT_LT(fit->worst_mm, 1e-6);
    for (int i = 0; i < 5; ++i) {
      const Vec3 p = any.place(200.0);
      expect_near(fit->calibration.to_page(p), truth.to_page(p), 1e-5);
    }
  }
}

TEST(PlaneCalibration, NoisyTouchesGiveTheirResidualAndAPlaneThatIsNoWorse) {
  double worst_tilt_mm = 0.0;
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    AnyMap any(seed);
    const PlaneCalibration truth = any.map(true);
    std::vector<PlaneTouch> touches;
    double truth_sum = 0.0;
    for (const Point at : {Point{0, 0}, {150, 0}, {0, 110}, {150, 110}, {75, 55}}) {
      const Vec3 noise = any.place(0.3);
      touches.push_back({truth.to_device(Vec3{at.x, at.y, 0.0}) + noise, at});
      truth_sum += norm_squared(noise);
    }
    const Result<PlaneFit> fit = fit_plane(touches);
    ASSERT_TRUE(fit.has_value());
    EXPECT_LE(fit->rms_mm, std::sqrt(truth_sum / 5.0) + 1e-9)
        << "least squares: truth is no better";
    EXPECT_GT(fit->rms_mm, 0.0);
    EXPECT_LE(fit->rms_mm, fit->worst_mm + 1e-12);
    const Vec3 middle = truth.to_device(Vec3{75, 55, 0});
    worst_tilt_mm =
        std::max(worst_tilt_mm, norm(fit->calibration.to_page(middle) - Vec3{75, 55, 0}));
  }
  EXPECT_LT(worst_tilt_mm, 0.6);
}

TEST(PlaneCalibration, ForcesPointTheRightWayOnEachAxis) {
  // A typical device on a desk: x right, y up (away from the desk), z towards the user. The page is
  // upright in front of it, like an easel.
  const auto corners = corner_touches({-60, 50, -20}, {60, 50, -20}, {-60, -40, -20}, {0, 0});
  const Result<PlaneFit> fit = fit_plane(corners);
  ASSERT_TRUE(fit.has_value());
  const PlaneCalibration& map = fit->calibration;
  EXPECT_TRUE(map.mirrors());
  expect_near(map.to_page(Vec3{-60, 50, -20}), {0, 0, 0}, 1e-9);
  expect_near(map.to_page(Vec3{60, -40, -15}), {120, 90, 5}, 1e-9);  // above the page: z > 0
  const auto device = [&](const Force& f) {
    const Force g = map.turn_to_device(f);
    return Vec3{g.x, g.y, g.z};
  };
  expect_near(device({1, 0, 0}), {1, 0, 0}, 1e-9);
  expect_near(device({0, 1, 0}), {0, -1, 0}, 1e-9);  // down the page
  expect_near(device({0, 0, 1}), {0, 0, 1}, 1e-9);   // out of the page, towards the user
}

TEST(PlaneCalibration, ASkewCornerIsTold) {
  const auto square = corner_touches({0, 0, 0}, {100, 0, 0}, {0, -80, 0}, {5, 5});
  EXPECT_LT(fit_plane(square)->worst_mm, 1e-9);
  const auto skew = corner_touches({0, 0, 0}, {100, 0, 0}, {10, -80, 0}, {5, 5});
  EXPECT_GT(fit_plane(skew)->worst_mm, 2.0);
}

TEST(PlaneCalibration, TouchesThatMeanNoPlaneAreRefused) {
  const auto touch = [](double x, double y, double z) { return PlaneTouch{{x, y, z}, {x, y}}; };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<std::vector<PlaneTouch>> bad{
      {},
      {touch(0, 0, 0), touch(100, 0, 0)},
      {touch(0, 0, 0), touch(100, 0, 0), touch(50, 1, 0)},    // all nearly on a line
      {touch(0, 0, 0), touch(100, 0, 0), touch(100, 10, 0)},  // two are too close
      {touch(0, 0, 0), touch(100, 0, 0), touch(0, nan, 0)},
      {touch(0, 0, 0), touch(inf, 0, 0), touch(0, 80, 0)},
      {touch(0, 0, 0), touch(2e6, 0, 0), touch(0, 80, 0)},
      {touch(0, 0, 0), touch(100, 0, 0), {{0, 80, 0}, {nan, 0}}},
  };
  for (const auto& touches : bad) EXPECT_FALSE(fit_plane(touches).has_value());
  // If all page positions coincide, the rotation is undefined, but nothing must break.
  const std::vector<PlaneTouch> heap{
      {{0, 0, 0}, {5, 5}}, {{100, 0, 0}, {5, 5}}, {{0, 80, 0}, {5, 5}}};
  if (const auto fit = fit_plane(heap)) {
    EXPECT_TRUE(std::isfinite(fit->rms_mm));
  }
}

TEST(PlaneCalibration, OnlyRigidMapsAreTakenFromStore) {
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_TRUE(PlaneCalibration::from({x, y, z}, {1, 2, 3}).has_value());
  EXPECT_FALSE(PlaneCalibration::from({2.0 * x, y, z}, {}).has_value());
  EXPECT_FALSE(PlaneCalibration::from({x, x, z}, {}).has_value());
  EXPECT_FALSE(PlaneCalibration::from({x, y, {0, 0, std::nan("")}}, {}).has_value());
  EXPECT_FALSE(PlaneCalibration::from({x, y, z}, {0, 1e7, 0}).has_value());
}

TEST(PlaneCalibration, TheWorkspaceHoldsAllThatTheDeviceReaches) {
  Capabilities device;
  device.max_force_n = 3.0;
  for (std::uint32_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    AnyMap any(seed);
    const PlaneCalibration map = any.map(true);
    const Capabilities mapped = map.to_page(device);
    EXPECT_EQ(mapped.max_force_n, device.max_force_n);
    const Vec3 inside{any.between(-80, 80), any.between(-60, 60), any.between(-35, 35)};
    const Vec3 p = map.to_page(inside);
    EXPECT_GE(p.x, mapped.workspace_min.x - 1e-9);
    EXPECT_LE(p.x, mapped.workspace_max.x + 1e-9);
    EXPECT_GE(p.z, mapped.workspace_min.z - 1e-9);
    EXPECT_LE(p.y, mapped.workspace_max.y + 1e-9);
  }
}

}  // namespace
}  // namespace felt::plane_calibration_test
