#include "felt/geometry/nearest.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "felt/base/constants.h"
#include "felt/geometry/testing/nearest_cases.h"

namespace felt::nearest_test {
namespace {

// bench_nearest --check runs the same comparison over 10^6 cases.
TEST(Nearest, R19_IsNeverFartherThanDenseSamplingOnAnyKindOfCubic) {
  constexpr int kPerKind = 2500;
  for (int k = 0; k < kCaseKinds; ++k) {
    const double size = static_cast<CaseKind>(k) == CaseKind::kTiny ? 1e-6 : 100.0;
    std::mt19937_64 random(static_cast<unsigned>(k));
    for (int i = 0; i < kPerKind; ++i) {
      const NearestCase c = make_case(static_cast<CaseKind>(k), random);
      const Nearest hit = nearest(c.curve, c.query);
      const double truth = sampled_distance(c.curve, c.query, 1000);
      ASSERT_LE(std::sqrt(hit.distance_squared), truth + 1e-12 * size + 2e-14 * truth)
          << "kind " << k << ", case " << i << " of seed " << k;
      ASSERT_TRUE(hit.t >= 0.0 && hit.t <= 1.0);
      ASSERT_EQ(hit.point, evaluate(c.curve, hit.t));
      ASSERT_NEAR(distance(hit.point, c.query), std::sqrt(hit.distance_squared),
                  2e-11 + 2e-14 * truth);
    }
  }
}

RC_GTEST_PROP(Nearest, ALimitDoesNotChangeTheAnswer, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const auto kind = static_cast<CaseKind>(*rc::gen::inRange(0, kCaseKinds));
  const NearestCase c = make_case(kind, random);
  const Nearest free = nearest(c.curve, c.query);
  const auto wide = nearest_within(c.curve, c.query, 1.001 * free.distance_squared + 1e-20);
  RC_ASSERT(wide.has_value());
  const double distance = std::sqrt(free.distance_squared);
  RC_ASSERT(std::fabs(std::sqrt(wide->distance_squared) - distance) <= 1e-12 + 1e-13 * distance);
  RC_ASSERT(!nearest_within(c.curve, c.query, 0.999 * free.distance_squared - 1e-20));
}

RC_GTEST_PROP(Nearest, WorkStaysSmall, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const auto kind = static_cast<CaseKind>(*rc::gen::inRange(0, kCaseKinds));
  const NearestCase c = make_case(kind, random);
  int pieces_left = 1000;
  (void)nearest_within(c.curve, c.query, HUGE_VAL, pieces_left);
  RC_ASSERT(1000 - pieces_left <= 100);
}

TEST(Nearest, OutOfWorkStillAnswers) {
  const Cubic loop{{Point{0, 0}, {40, 30}, {-20, 30}, {20, 0}}};
  const Point q{10, 14};
  int pieces_left = 2;
  const auto rough = nearest_within(loop, q, HUGE_VAL, pieces_left);
  EXPECT_EQ(pieces_left, 0);
  ASSERT_TRUE(rough);
  EXPECT_GE(rough->distance_squared, nearest(loop, q).distance_squared);
}

TEST(Nearest, OfEqualDistancesTheLowestT) {
  const Cubic point{{Point{1, 1}, {1, 1}, {1, 1}, {1, 1}}};
  EXPECT_EQ(nearest(point, {4, 5}).t, 0.0);
  EXPECT_EQ(nearest(point, {4, 5}).distance_squared, 25.0);
  const Cubic closed{{Point{0, 0}, {10, 10}, {-10, 10}, {0, 0}}};
  EXPECT_EQ(nearest(closed, {0, -1}).t, 0.0);
  // The curve is symmetric about x = 5, so that the points at t and 1 - t are equally near.
  const Cubic arch{{Point{0, 0}, {0, 10}, {10, 10}, {10, 0}}};
  for (double y = -3.0; y < 6.0; y += 0.1) EXPECT_LE(nearest(arch, {5, y}).t, 0.5);
  // The curve goes forward and back along a line, and passes the point twice.
  const Cubic fold{{Point{0, 0}, {8, 0}, {8, 0}, {0, 0}}};
  EXPECT_LT(nearest(fold, {3, 0}).t, 0.5);
}

TEST(Nearest, FindsEndsJointsAndCusps) {
  const Cubic c{{Point{0, 0}, {1, 1}, {0, 1}, {1, 0}}};  // a cusp at t = 1/2, (0.5, 0.75)
  EXPECT_EQ(nearest(c, {0, 0}).t, 0.0);
  EXPECT_EQ(nearest(c, {1, 0}).t, 1.0);
  EXPECT_EQ(nearest(c, {1, 0}).distance_squared, 0.0);
  EXPECT_NEAR(nearest(c, {0.5, 2}).t, 0.5, 1e-7);
  EXPECT_NEAR(std::sqrt(nearest(c, {0.5, 2}).distance_squared), 1.25, 1e-14);
}

TEST(Nearest, InputThatIsNotFiniteIsInfinitelyFar) {
  const Cubic c = straight({1, 2}, {3, 4});
  for (const Point q : {Point{kNan, 0}, Point{0, HUGE_VAL}, Point{1e200, 0}}) {
    const Nearest hit = nearest(c, q);
    EXPECT_EQ(hit.t, 0.0);
    EXPECT_EQ(hit.point, c.p[0]);
    EXPECT_TRUE(std::isinf(hit.distance_squared));
    EXPECT_FALSE(nearest_within(c, q, HUGE_VAL));
  }
  for (unsigned i = 0; i < 4; ++i) {
    Cubic broken = c;
    broken.p[i].y = kNan;
    EXPECT_TRUE(std::isinf(nearest(broken, {0, 0}).distance_squared)) << i;
  }
  EXPECT_FALSE(nearest_within(c, {0, 0}, kNan));
  EXPECT_FALSE(nearest_within(c, {0, 0}, -1.0));
}

TEST(Nearest, TheLimitItselfIsNearEnough) {
  const Cubic c = straight({0, 0}, {10, 0});
  EXPECT_TRUE(nearest_within(c, {-3, 4}, 25.0));
  EXPECT_FALSE(nearest_within(c, {-3, 4}, 24.99));
}

}  // namespace
}  // namespace felt::nearest_test
