#include "felt/tools/snapping.h"

#include <gtest/gtest.h>

#include <cmath>

#include "felt/tools/desk.h"

namespace felt {
namespace {

using testing::Desk;
using testing::straight_stroke;
using testing::operator+;

const SnapOptions kDefault;

TEST(SnapFinder, FindsTheNearestEndWithinReach) {
  Desk desk;
  const StrokeId id = desk.add(straight_stroke({0, 0}, {100, 0}, 1, 1));
  SnapFinder finder;
  EXPECT_FALSE(finder.update({0, 8.01}, kDefault, desk.document, desk.index));
  const auto target = finder.update({3, 4}, kDefault, desk.document, desk.index);
  ASSERT_TRUE(target);
  EXPECT_EQ(target->tip, (TipId{id, StrokeTip::kStart}));
  EXPECT_EQ(target->point, (Point{0, 0}));
  EXPECT_FALSE(finder.update({50, 0}, kDefault, desk.document, desk.index));
  EXPECT_EQ(finder.update({99, 0}, kDefault, desk.document, desk.index)->point, (Point{100, 0}));
  EXPECT_FALSE(finder.update({99, 0}, {.mode = SnapMode::kOff}, desk.document, desk.index));
}

TEST(SnapFinder, R43_KeepsItsTargetUntilAnotherIsNearerByOneMillimetre) {
  Desk desk;
  desk.add(straight_stroke({0, 0}, {0, 50}, 1, 1));
  desk.add(straight_stroke({6, 0}, {6, 50}, 1, 1));
  SnapFinder finder;
  finder.update({2, 0}, kDefault, desk.document, desk.index);
  int changes = 0;
  Point last = finder.target()->point;
  // The middle is at x = 3; a pen that trembles about it does not change its target.
  for (int k = 0; k < 1000; ++k) {
    finder.update({3 + 0.49 * std::sin(k), 0}, kDefault, desk.document, desk.index);
    changes += finder.target()->point != last ? 1 : 0;
    last = finder.target()->point;
  }
  EXPECT_EQ(changes, 0);
  finder.update({3.49, 0}, kDefault, desk.document, desk.index);
  EXPECT_EQ(finder.target()->point.x, 0);
  finder.update({3.51, 0}, kDefault, desk.document, desk.index);
  EXPECT_EQ(finder.target()->point.x, 6);
  finder.update({2.51, 0}, kDefault, desk.document, desk.index);
  EXPECT_EQ(finder.target()->point.x, 6);
  finder.update({2.49, 0}, kDefault, desk.document, desk.index);
  EXPECT_EQ(finder.target()->point.x, 0);
}

TEST(SnapFinder, LetsGoOfATargetBeyondReachOrGone) {
  Desk desk;
  desk.add(straight_stroke({0, 0}, {0, 50}, 1, 1));
  desk.add(straight_stroke({15.8, 0}, {15.8, 50}, 1, 1));
  SnapFinder finder;
  finder.update({7, 0}, kDefault, desk.document, desk.index);
  ASSERT_TRUE(finder.target());
  // 8.1 mm from the first, 7.7 mm from the second: the first feels nothing any more.
  EXPECT_EQ(finder.update({8.1, 0}, kDefault, desk.document, desk.index)->point.x, 15.8);
  desk.undo();
  EXPECT_FALSE(finder.update({8.1, 0}, kDefault, desk.document, desk.index));
}

TEST(SnapFinder, R44_TheOwnStartCountsOnlyAfterLeavingReachAndThreeReaches) {
  Desk desk;
  // Inside the circle: whatever the path, never.
  SnapFinder finder;
  finder.begin({0, 0}, std::nullopt);
  for (int k = 0; k < 100000; ++k) {
    const double a = 0.01 * k;
    finder.update({7.9 * std::cos(a), 7.9 * std::sin(a)}, kDefault, desk.document, desk.index);
    ASSERT_FALSE(finder.is_armed());
    ASSERT_FALSE(finder.target());
  }
  // Out and straight back, 2 x 8.5 mm of path: not yet.
  finder.begin({0, 0}, std::nullopt);
  for (const Point p : testing::way({0, 0}, {8.5, 0}) + testing::way({8.5, 0}, {0, 0})) {
    finder.update(p, kDefault, desk.document, desk.index);
    ASSERT_FALSE(finder.is_armed());
  }
  // Out far enough: the way back ends at the start.
  finder.begin({0, 0}, std::nullopt);
  for (const Point p : testing::way({0, 0}, {13, 0}) + testing::way({13, 0}, {1, 0})) {
    finder.update(p, kDefault, desk.document, desk.index);
  }
  EXPECT_TRUE(finder.is_armed());
  ASSERT_TRUE(finder.target());
  EXPECT_TRUE(finder.target()->is_own_start());
  EXPECT_EQ(finder.target()->point, (Point{0, 0}));
}

TEST(SnapFinder, R44_ATremblingPenAtRestDoesNotTravel) {
  Desk desk;
  SnapFinder finder;
  finder.begin({0, 0}, std::nullopt);
  testing::RandomStroke random(1);
  for (const Point p : testing::way({0, 0}, {8.1, 0})) {
    finder.update(p, kDefault, desk.document, desk.index);
  }
  // A minute at 1 kHz, 0.03 mm of noise: 1.5 m of sums of noise.
  for (int k = 0; k < 60000; ++k) {
    finder.update({8.1 + random.uniform(-.03, .03), random.uniform(-.03, .03)}, kDefault,
                  desk.document, desk.index);
    ASSERT_FALSE(finder.is_armed());
  }
}

TEST(SnapFinder, TheEndThatTheLineBeganOnIsNoTarget) {
  Desk desk;
  const StrokeId id = desk.add(straight_stroke({0, 0}, {0, 50}, 1, 1));
  SnapFinder finder;
  finder.begin({0, 0}, TipId{id, StrokeTip::kStart});
  EXPECT_FALSE(finder.update({1, 0}, kDefault, desk.document, desk.index));
  EXPECT_EQ(finder.update({1, 49}, kDefault, desk.document, desk.index)->point, (Point{0, 50}));
}

TEST(WellOf, R43_IsZeroAtBothEndsAndContinuous) {
  for (const double reach : {1.0, 8.0, 40.0}) {
    const SnapOptions options{.reach_mm = reach};
    const WellShape well = well_of(options);
    EXPECT_EQ(well.force_at_n(0.0), 0.0);
    EXPECT_EQ(well.force_at_n(reach), 0.0);
    EXPECT_EQ(well.force_at_n(2 * reach), 0.0);
    double last = 0.0;
    for (int k = 0; k <= 10000; ++k) {
      const double f = well.force_at_n(reach * k / 9000);
      EXPECT_NEAR(f, last, 0.6 * 8 / 9000 * 1.01);
      last = f;
    }
  }
  const WellShape well = well_of({});
  EXPECT_EQ(well.core_mm, 2.0);
  EXPECT_EQ(well.rim_mm, 2.0);
  EXPECT_EQ(well.force_at_n(4.0), 0.6);
}

}  // namespace
}  // namespace felt
