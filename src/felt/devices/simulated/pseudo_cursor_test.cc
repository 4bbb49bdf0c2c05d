#include "felt/devices/simulated/pseudo_cursor.h"

#include <limits>

#include <gtest/gtest.h>

#include "felt/base/random.h"

namespace felt::pseudo_cursor_test {
namespace {

using Use = PseudoCursor::Use;
constexpr double kFrameS = 0.008;

TEST(PseudoCursor, ShowsABoundedPartOfTheDisplacement) {
  PseudoCursor cursor({.gain = 0.5});
  EXPECT_EQ(cursor.update({10, 10}, {12, 10}, Use::kFeeling, kFrameS), (Point{11, 10}));
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const Point hand{random.between(0, 100), random.between(0, 100)};
    const Point pen{random.between(0, 100), random.between(0, 100)};
    const Point shown = cursor.update(hand, pen, Use::kFeeling, kFrameS);
    EXPECT_LE(distance(shown, hand), 3.0 + 1e-12);
    EXPECT_GT(dot(shown - hand, pen - hand), 0.0);
  }
}

TEST(PseudoCursor, IsOffWhileInkFlowsOnATablet) {
  PseudoCursor cursor;
  cursor.update({10, 10}, {12, 10}, Use::kFeeling, kFrameS);
  EXPECT_EQ(cursor.update({10, 10}, {12, 10}, Use::kTabletInk, kFrameS), (Point{10, 10}));
  EXPECT_EQ(cursor.update({10, 10}, {12, 10}, Use::kInAir, kFrameS), (Point{10, 10}));
}

TEST(PseudoCursor, IsReleasedEvenlyOnLift) {
  PseudoCursor cursor({.release_s = 0.05});
  const Point hand{20, 20};
  Point last = cursor.update(hand, {40, 20}, Use::kFeeling, kFrameS);
  EXPECT_EQ(last, (Point{23, 20}));
  for (int ms = 1; ms <= 50; ++ms) {
    const Point next = cursor.update(hand, {40, 20}, Use::kInAir, 0.001);
    EXPECT_NEAR(distance(last, next), 0.06, 1e-9);
    last = next;
  }
  EXPECT_NEAR(distance(last, hand), 0.0, 1e-9);
}

TEST(PseudoCursor, CanBeSwitchedOff) {
  PseudoCursor cursor({.on = false});
  EXPECT_EQ(cursor.update({1, 2}, {9, 9}, Use::kFeeling, kFrameS), (Point{1, 2}));
}

TEST(PseudoCursor, ShowsTheHandWhereNumbersFail) {
  PseudoCursor cursor;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cursor.update({1, 2}, {nan, 9}, Use::kFeeling, kFrameS), (Point{1, 2}));
  cursor.update({0, 0}, {9, 9}, Use::kFeeling, kFrameS);
  EXPECT_TRUE(is_finite(cursor.update({1, 2}, {9, 9}, Use::kInAir, nan)));
}

}  // namespace
}  // namespace felt::pseudo_cursor_test
