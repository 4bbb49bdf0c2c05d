#include "felt/tools/lasso/lasso_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "felt/geometry/polyline.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/tools/lasso/lasso_outline.h"

namespace felt::lasso_area_test {
namespace {

using testing::straight_stroke;

struct Grid {
  long x = 0, y = 0;
};

/// An even-odd test in integers, so that it is exact. Its ray runs along the other axis than in the
/// code under test. A point on an edge is inside.
bool is_inside(const std::vector<Grid>& polygon, Grid p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Grid a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const long side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    const bool within = std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
                        std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
    if (side == 0 && within) return true;
    // A ray along +y.
    if ((a.x <= p.x) != (b.x <= p.x) && (b.x > a.x ? side < 0 : side > 0)) inside = !inside;
  }
  return inside;
}

TEST(LassoArea, R31_IsEvenOddAndEdgesAreInside) {
  std::mt19937_64 random(31);
  const auto whole = [&](long a, long b) {
    return std::uniform_int_distribution<long>(a, b)(random);
  };
  int inside = 0, outside = 0;
  for (int round = 0; round < 3000; ++round) {
    std::vector<Grid> grid;
    std::vector<Point> outline;
    for (long n = whole(3, 14); n > 0; --n) {
      grid.push_back({whole(0, 12), whole(0, 12)});
      outline.push_back({static_cast<double>(grid.back().x), static_cast<double>(grid.back().y)});
    }
    const LassoArea area(outline);
    for (long x = -1; x <= 13; ++x) {
      for (long y = -1; y <= 13; ++y) {
        const bool expected = is_inside(grid, {x, y});
        ASSERT_EQ(area.contains({static_cast<double>(x), static_cast<double>(y)}), expected)
            << "polygon " << round << " at " << x << ", " << y;
        ++(expected ? inside : outside);
      }
    }
  }
  EXPECT_GT(inside, 50'000);
  EXPECT_GT(outside, 50'000);
}

TEST(LassoArea, R31_IsThatOfTheGeometry) {
  testing::RandomStroke random(4);
  for (int round = 0; round < 300; ++round) {
    std::vector<Point> outline;
    for (int n = random.pick(3, 400); n > 0; --n) {
      outline.push_back({random.uniform(-100, 300), random.uniform(-100, 300)});
    }
    const LassoArea area(outline);
    for (int k = 0; k < 200; ++k) {
      const std::size_t i = static_cast<std::size_t>(random.pick(0, 1 << 20)) % outline.size();
      const Point p =
          k % 3 == 0   ? outline[i]
          : k % 3 == 1 ? lerp(outline[i], outline[(i + 1) % outline.size()], random.uniform(0, 1))
                       : Point{random.uniform(-110, 310), random.uniform(-110, 310)};
      ASSERT_EQ(area.contains(p), contains(outline, p, FillRule::kEvenOdd)) << round << ", " << k;
    }
  }
}

TEST(LassoArea, R31_FewerThanThreePointsHoldNothing) {
  EXPECT_FALSE(LassoArea({}).contains({0, 0}));
  EXPECT_FALSE(LassoArea({{0, 0}, {10, 0}}).contains({5, 0}));
  EXPECT_FALSE(LassoArea({{0, 0}, {10, 0}, {5, 9}}).contains({std::nan(""), 1}));
}

TEST(LassoArea, TouchesWhatComesIn) {
  const LassoArea square({{10, 10}, {20, 10}, {20, 20}, {10, 20}});
  EXPECT_TRUE(square.touches(straight_stroke({0, 15}, {30, 15}, 1, 1))) << "through";
  EXPECT_TRUE(square.touches(straight_stroke({12, 12}, {13, 13}, 1, 1))) << "inside";
  EXPECT_TRUE(square.touches(straight_stroke({0, 0}, {10, 10}, 1, 1))) << "to the corner";
  EXPECT_TRUE(square.touches(straight_stroke({0, 29.8}, {29.8, 0}, 1, 1))) << "over a corner";
  EXPECT_FALSE(square.touches(straight_stroke({0, 9}, {30, 9}, 1, 1))) << "past";
  EXPECT_FALSE(square.touches(straight_stroke({9, 0}, {9, 30}, 1, 1))) << "past";
  // A thin area cuts a line between two sampled points.
  const LassoArea blade({{15.24, 0}, {15.26, 0}, {15.25, 40}});
  EXPECT_TRUE(blade.touches(straight_stroke({0, 15}, {100, 15}, 1, 1)));
}

TEST(LassoArea, AnEightEnclosesSomething) {
  const std::vector<Point> eight{{0, 0}, {10, 10}, {10, 0}, {0, 10}};
  EXPECT_NEAR(area(eight), 0.0, 1e-12);
  EXPECT_GT(swept_area_mm2(eight), 10.0);
  const std::vector<Point> line{{0, 0}, {50, 0}, {100, 0}, {20, 0}};
  EXPECT_EQ(swept_area_mm2(line), 0.0);
}

TEST(LassoOutline, R31_StaysWithinAQuarterMillimetreOfTheWay) {
  testing::RandomStroke random(9);
  for (int round = 0; round < 20; ++round) {
    LassoOutline outline;
    std::vector<Point> way{{0, 0}};
    outline.begin(way[0]);
    double heading = 0.0;
    for (int i = 0; i < 3000; ++i) {
      heading += random.uniform(-0.2, 0.2);
      way.push_back(way.back() +
                    random.uniform(0.0, 0.3) * Vec{std::cos(heading), std::sin(heading)});
      outline.add(way.back());
    }
    const std::vector<Point> simple = outline.finished();
    EXPECT_LT(simple.size(), way.size() / 4);
    EXPECT_LT(outline.points().size(), simple.size() + 120);
    for (const Point p : way) {
      double nearest = 1e9;
      for (std::size_t i = 1; i < simple.size(); ++i) {
        const Vec along = simple[i] - simple[i - 1];
        const double t = std::clamp(dot(p - simple[i - 1], along) / norm_squared(along), 0.0, 1.0);
        nearest = std::min(nearest, distance(p, simple[i - 1] + t * along));
      }
      ASSERT_LE(nearest, LassoOutline::kToleranceMm) << "round " << round;
    }
  }
}

}  // namespace
}  // namespace felt::lasso_area_test
