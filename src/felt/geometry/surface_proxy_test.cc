#include "felt/geometry/surface_proxy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "felt/geometry/triangle_tree.h"

namespace felt::surface_proxy_test {
namespace {

constexpr int kCells = 48;           // of 1 mm, along each side
constexpr double kTickMoveMm = 0.5;  // 0.5 m/s at 1 kHz

// Hills with a rim, so that the proxy cannot leave over the side of this open surface.
double height_of(int x, int y) {
  if (x <= 0 || y <= 0 || x >= kCells || y >= kCells) return 30.0;
  return 3.0 * std::sin(0.5 * x) * std::cos(0.37 * y) + ((x * 7 + y * 3) % 5) * 0.4;
}
Vec3 corner(int x, int y) {
  return {double(x), double(y), height_of(x, y)};
}

// Two triangles a cell; `without` is left out.
std::vector<Triangle3> hills(std::size_t without = std::numeric_limits<std::size_t>::max()) {
  std::vector<Triangle3> all;
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x) {
      all.push_back({corner(x, y), corner(x + 1, y), corner(x + 1, y + 1)});
      all.push_back({corner(x, y), corner(x + 1, y + 1), corner(x, y + 1)});
    }
  }
  if (without < all.size()) all.erase(all.begin() + static_cast<std::ptrdiff_t>(without));
  return all;
}

// The height of the hills, without the tree.
double surface_at(const Vec3& p) {
  const int x = std::clamp(int(std::floor(p.x)), 0, kCells - 1);
  const int y = std::clamp(int(std::floor(p.y)), 0, kCells - 1);
  const double u = p.x - x;
  const double v = p.y - y;
  const double a = height_of(x, y);
  const double d = height_of(x + 1, y + 1);
  return u >= v ? a + u * (height_of(x + 1, y) - a) + v * (d - height_of(x + 1, y))
                : a + v * (height_of(x, y + 1) - a) + u * (d - height_of(x, y + 1));
}

int number_of(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::atoi(text) : otherwise;
}

// Moves a pen at random at 0.5 m/s and returns the tick at which the proxy is below the surface.
template <class Step>
std::optional<int> fall(Step step, Vec3& place) {
  std::mt19937_64 random(static_cast<std::uint64_t>(number_of("TOUCH_SEED", 1)));
  std::normal_distribution<double> turn(0.0, 0.15);
  const int ticks = number_of("TOUCH_TICKS", 200'000);
  Vec3 pen{24.0, 24.0, 10.0};
  Vec3 heading{0.0, 0.0, -1.0};
  place = pen;
  for (int i = 0; i < ticks; ++i) {
    heading += Vec3{turn(random), turn(random), turn(random)};
    heading = (1.0 / norm(heading)) * heading;
    pen += kTickMoveMm * heading;
    pen = {std::clamp(pen.x, 4.0, 44.0), std::clamp(pen.y, 4.0, 44.0),
           std::clamp(pen.z, -6.0, 8.0)};
    step(pen, i);
    if (place.z < surface_at(place) - 1e-9) return i;
  }
  return std::nullopt;
}

std::optional<int> fall_of_proxy(const TriangleTree& body) {
  SurfaceProxy proxy;
  proxy.reset({24.0, 24.0, 10.0});
  Vec3 place{};
  return fall(
      [&](const Vec3& pen, int tick) { place = proxy.step(body, pen, 0.25 * (tick / 1000 % 4)); },
      place);
}

TEST(SurfaceProxy, FallsThroughNothingAtHalfAMetreASecond) {
  EXPECT_EQ(fall_of_proxy(TriangleTree(hills())), std::nullopt);
}

TEST(SurfaceProxy, TheSameTestFindsAMissingTriangle) {
  EXPECT_NE(fall_of_proxy(TriangleTree(hills(2 * (24 * kCells + 24)))), std::nullopt);
}

TEST(SurfaceProxy, TheSameTestFindsAStepThatIsNotSweptWhole) {
  const TriangleTree body(hills());
  Vec3 place{};
  const auto half_swept = [&](const Vec3& pen, int) {
    if (!body.sweep(lerp(place, pen, 0.5), pen)) place = pen;
  };
  EXPECT_NE(fall(half_swept, place), std::nullopt);
}

// A valley along y whose sides rise by `slope`.
TriangleTree valley(double slope) {
  const auto at = [slope](double x, double y) { return Vec3{x, y, slope * std::abs(x)}; };
  const std::vector<Triangle3> sides{{at(0, -200), at(200, -200), at(200, 200)},
                                     {at(0, -200), at(200, 200), at(0, 200)},
                                     {at(-200, -200), at(0, -200), at(0, 200)},
                                     {at(-200, -200), at(0, 200), at(-200, 200)}};
  return TriangleTree(sides);
}

// Starts 3e-16 mm behind one side, where a proxy came to rest after 269,951 random ticks.
TEST(SurfaceProxy, FallsThroughNoValleyInWhichRoundingPutItBehindASide) {
  SurfaceProxy proxy;
  proxy.reset({-4.2632564145606011e-14, 46.218571849086977, 4.2188474935755949e-14});
  const Vec3 place = proxy.step(valley(1.0), {3.886431706113723, 45.793657918837326, -4.0}, 0.0);
  EXPECT_GE(place.z, std::abs(place.x) - 1e-9);
}

// On the left side at its gap, near the bottom: the first sweep hits the left side, the second the
// right one, and only the right one may hold the proxy.
TEST(SurfaceProxy, AFlatValleyDoesNotHoldASlidingProxy) {
  const TriangleTree body = valley(0.005);
  for (int i = 1; i <= 100; ++i) {
    SurfaceProxy proxy;
    const double x = -0.002 * i;
    proxy.reset({x, 0, 0.005 * -x + SurfaceProxy::kGapMm});
    EXPECT_NEAR(proxy.step(body, {1.0, 0, -0.25}, 0.0).x, 1.0, 0.01) << x;
  }
}

TEST(SurfaceProxy, AProxyRestsAtTheBottomOfASteepValley) {
  const TriangleTree body = valley(4.0);
  SurfaceProxy proxy;
  proxy.reset({0.5, 0, 9});
  for (int i = 0; i < 50; ++i) proxy.step(body, {0.1, 3, -2}, 0.0);
  EXPECT_NEAR(norm(proxy.place() - Vec3{0, 3, 0}), 0.0, 0.01);
}

TEST(SurfaceProxy, FrictionHoldsInsideTheConeAndSlidesOutside) {
  const std::vector<Triangle3> floor{{{-50, -50, 0}, {50, -50, 0}, {0, 80, 0}}};
  const TriangleTree body(floor);
  SurfaceProxy proxy;
  proxy.reset({0, 0, 1});
  proxy.step(body, {0, 0, -2}, 0.5);
  ASSERT_TRUE(proxy.touches());
  EXPECT_NEAR(proxy.step(body, {0.9, 0, -2}, 0.5).x, 0.0, 1e-3);
  EXPECT_NEAR(proxy.step(body, {3.0, 0, -2}, 0.5).x, 2.0, 2e-3);
  EXPECT_NEAR(proxy.place().z, SurfaceProxy::kGapMm, 1e-9);
  proxy.step(body, {3.0, 0, 1}, 0.5);
  EXPECT_FALSE(proxy.touches());
}

TEST(SurfaceProxy, APenThatIsNotFiniteMovesNothing) {
  const TriangleTree body(hills());
  SurfaceProxy proxy;
  proxy.reset({24, 24, 10});
  EXPECT_EQ(proxy.step(body, {std::nan(""), 0, 0}, 0.0), (Vec3{24, 24, 10}));
  proxy.reset({-1e308, 0, 10});
  EXPECT_EQ(proxy.step(body, {1e308, 0, 10}, 0.0), (Vec3{-1e308, 0, 10}));
}

TEST(TriangleTree, ASweepThatNeedsTooManyNodesStopsAtItsStart) {
  const std::optional<SweepHit> hit = TriangleTree(hills()).sweep({1, 1, 20}, {47, 47, -20});
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->t, 0.0);
}

}  // namespace
}  // namespace felt::surface_proxy_test
