#include "felt/tools/snapping.h"

#include <gtest/gtest.h>

#include <cmath>

#include "felt/tools/testing/tool_fixture.h"

namespace felt::snapping_test {
namespace {

using testing::Fixture;
using testing::straight_stroke;
using testing::operator+;

const SnapOptions kDefault;

TEST(SnapFinder, FindsTheNearestEndWithinReach) {
  Fixture fixture;
  const StrokeId id = fixture.add(straight_stroke({0, 0}, {100, 0}, 1, 1));
  SnapFinder finder;
  EXPECT_FALSE(finder.update({0, 8.01}, kDefault, fixture.document, fixture.index));
  const auto target = finder.update({3, 4}, kDefault, fixture.document, fixture.index);
  ASSERT_TRUE(target);
  EXPECT_EQ(target->tip, (TipId{id, StrokeTip::kStart}));
  EXPECT_EQ(target->point, (Point{0, 0}));
  EXPECT_FALSE(finder.update({50, 0}, kDefault, fixture.document, fixture.index));
  EXPECT_EQ(finder.update({99, 0}, kDefault, fixture.document, fixture.index)->point,
            (Point{100, 0}));
  EXPECT_FALSE(finder.update({99, 0}, {.mode = SnapMode::kOff}, fixture.document, fixture.index));
}

TEST(SnapFinder, R43_KeepsItsTargetUntilAnotherIsNearerByOneMillimetre) {
  Fixture fixture;
  fixture.add(straight_stroke({0, 0}, {0, 50}, 1, 1));
  fixture.add(straight_stroke({6, 0}, {6, 50}, 1, 1));
  SnapFinder finder;
  finder.update({2, 0}, kDefault, fixture.document, fixture.index);
  int changes = 0;
  Point last = finder.target()->point;
  // The middle is at x = 3; a pen that trembles around it keeps its target.
  for (int k = 0; k < 1000; ++k) {
    finder.update({3 + 0.49 * std::sin(k), 0}, kDefault, fixture.document, fixture.index);
    changes += finder.target()->point != last ? 1 : 0;
    last = finder.target()->point;
  }
  EXPECT_EQ(changes, 0);
  finder.update({3.49, 0}, kDefault, fixture.document, fixture.index);
  EXPECT_EQ(finder.target()->point.x, 0);
  finder.update({3.51, 0}, kDefault, fixture.document, fixture.index);
  EXPECT_EQ(finder.target()->point.x, 6);
  finder.update({2.51, 0}, kDefault, fixture.document, fixture.index);
  EXPECT_EQ(finder.target()->point.x, 6);
  finder.update({2.49, 0}, kDefault, fixture.document, fixture.index);
  EXPECT_EQ(finder.target()->point.x, 0);
}

TEST(SnapFinder, LetsGoOfATargetBeyondReachOrGone) {
  Fixture fixture;
  fixture.add(straight_stroke({0, 0}, {0, 50}, 1, 1));
  fixture.add(straight_stroke({15.8, 0}, {15.8, 50}, 1, 1));
  SnapFinder finder;
  finder.update({7, 0}, kDefault, fixture.document, fixture.index);
  ASSERT_TRUE(finder.target());
  // The end is 8.1 mm from the first target and 7.7 mm from the second, so the first no longer
  // attracts.
  EXPECT_EQ(finder.update({8.1, 0}, kDefault, fixture.document, fixture.index)->point.x, 15.8);
  fixture.undo();
  EXPECT_FALSE(finder.update({8.1, 0}, kDefault, fixture.document, fixture.index));
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
  EXPECT_EQ(well.rim_mm, 2.0);
  EXPECT_NEAR(well.force_at_n(4.0), 0.6, 1e-12);
  // The well is never stiffer than 240 N/m, whatever the options are.
  for (const double reach : {1.0, 3.0, 8.0, 40.0}) {
    for (const double force : {0.1, 0.3, 0.6, 1.0}) {
      EXPECT_LE(well_of({.reach_mm = reach, .force_n = force}).core_slope_n_per_m(), 240.001);
    }
  }
}

}  // namespace
}  // namespace felt::snapping_test
