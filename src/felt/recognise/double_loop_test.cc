#include "felt/recognise/double_loop.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <limits>

#include "felt/base/constants.h"
#include "felt/recognise/testing/drawn_shapes.h"

namespace felt::double_loop_test {
namespace {

using testing::ellipse_part;
using testing::joined;
using testing::unsteady;

double any(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
}

RC_GTEST_PROP(DoubleLoop, FindsTwoTurnsOfAnySizeAndDirection, ()) {
  const double a = any(8.0, 60.0), turns = any(1.9, 2.1) * (*rc::gen::arbitrary<bool>() ? 1 : -1);
  const Point center{any(-100, 100), any(-100, 100)};
  const auto path =
      unsteady(ellipse_part(center, a, any(0.6, 1.0) * a, any(0, 6.3), turns * kTau, any(0, 6.3)),
               0.02 * a, *rc::gen::inRange<std::uint64_t>(1, 1'000'000));
  const auto loop = DoubleLoop::find(path);
  RC_ASSERT(loop.has_value());
  RC_ASSERT(loop->encloses(joined({center, center + Vec{0.3 * a, 0.0}})));
  RC_ASSERT(!loop->encloses(joined({center, center + Vec{3.0 * a, 0.0}})));
  RC_ASSERT(!loop->encloses(joined({center + Vec{3.0 * a, 0.0}, center + Vec{4.0 * a, 0.0}})));
}

TEST(DoubleLoop, OneTurnThreeTurnsAndSpiralsAreInk) {
  for (const double turns : {0.5, 1.0, 1.3, 3.0, 4.0}) {
    EXPECT_FALSE(DoubleLoop::find(ellipse_part({0, 0}, 20, 15, 0.0, turns * kTau))) << turns;
  }
  std::vector<Point> spiral = ellipse_part({0, 0}, 20, 20, 0.0, 2.0 * kTau);
  for (std::size_t i = 0; i < spiral.size(); ++i) {
    spiral[i] = lerp({0, 0}, spiral[i], 0.2 + 0.8 * static_cast<double>(i) / 90.0);
  }
  EXPECT_FALSE(DoubleLoop::find(spiral));
  EXPECT_FALSE(DoubleLoop::find(ellipse_part({0, 0}, 2, 2, 0.0, 2.0 * kTau))) << "a thick dot";
  std::vector<Point> eight = ellipse_part({10, 0}, 10, 10, 3.14, kTau);
  const auto other = ellipse_part({-10, 0}, 10, 10, 0.0, -kTau);
  eight.insert(eight.end(), other.begin(), other.end());
  EXPECT_FALSE(DoubleLoop::find(eight)) << "an 8";
}

TEST(DoubleLoop, ItIsAboutWhatItCirclesClosely) {
  const auto loop = DoubleLoop::find(ellipse_part({0, 0}, 30, 30, 0.0, 2.0 * kTau));
  ASSERT_TRUE(loop);
  EXPECT_TRUE(loop->is_about({-15, -15, 15, 15}));
  EXPECT_FALSE(loop->is_about({-1, -1, 1, 1}));
}

TEST(DoubleLoop, DegeneratePathsAreInk) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<Point>& path : {std::vector<Point>{},
                                         {{1, 1}},
                                         {{1, 1}, {1, 1}},
                                         {{nan, 1}, {2, nan}},
                                         {{0, 0}, {5, 0}, {0, 0}}}) {
    EXPECT_FALSE(DoubleLoop::find(path));
  }
}

}  // namespace
}  // namespace felt::double_loop_test
