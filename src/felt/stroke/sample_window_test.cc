#include "felt/stroke/sample_window.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "felt/stroke/test_ink.h"

namespace felt {
namespace {

using testing::InkShape;
using testing::kAllShapes;
using testing::TestInk;

constexpr double kToleranceMm = 0.15, kSpacingMm = 0.02;

SampleWindow filled(const std::vector<Point>& ink, std::size_t capacity = 64) {
  SampleWindow window(kToleranceMm, kSpacingMm, capacity);
  for (const Point p : ink) window.add(p);
  return window;
}

class WindowOf : public ::testing::TestWithParam<InkShape> {};
INSTANTIATE_TEST_SUITE_P(AllInk, WindowOf, ::testing::ValuesIn(kAllShapes),
                         ::testing::PrintToStringParamName());

TEST_P(WindowOf, R3KeptSamplesAreTheSpacingApart) {
  const SampleWindow w = filled(TestInk(1).draw(GetParam(), 3000));
  for (std::size_t i = 1; i < w.size(); ++i) {
    ASSERT_GT(distance(w.point(i - 1), w.point(i)), kSpacingMm) << "sample " << i;
  }
}

TEST_P(WindowOf, R8EverySampleIsKeptOrWithinTheSpacingOfTheOneThatStandsForIt) {
  const std::vector<Point> ink = TestInk(2).draw(GetParam(), 3000);
  const SampleWindow w = filled(ink);
  std::size_t next = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    EXPECT_EQ(w.point(i), ink[next]);
    double slack = 0.0;
    for (std::size_t k = 0; k < w.sample_count(i); ++k) {
      slack = std::max(slack, distance(ink[next++], w.point(i)));
    }
    ASSERT_LE(slack, kSpacingMm * (1.0 + 1e-12));
    const double limit = w.tolerance_mm() - slack;
    ASSERT_NEAR(w.inverse_limit()[i] * limit * limit, 1.0, 1e-12);
  }
  EXPECT_EQ(next, ink.size());
  EXPECT_EQ(w.newest(), ink.back());
}

TEST_P(WindowOf, PathIsTheLengthAlongKeptSamples) {
  const SampleWindow w = filled(TestInk(3).draw(GetParam(), 500));
  double path = 0.0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (i > 0) path += distance(w.point(i - 1), w.point(i));
    ASSERT_NEAR(w.path_mm(i), path, 1e-12 * path);
  }
}

TEST(SampleWindow, R8SpeedDropsNothing) {
  SampleWindow w(kToleranceMm, 0.25, 64);  // 500 mm/s at 1 kHz, d = 0.25 mm
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(w.add({0.5 * i, 0.0}));
  EXPECT_EQ(w.size(), 1000u);
}

TEST(SampleWindow, DroppingTheFrontMovesTheRestDown) {
  const std::vector<Point> ink = TestInk(4).draw(InkShape::kResting, 500);
  const SampleWindow whole = filled(ink);
  SampleWindow w = filled(ink);
  const std::size_t drop = whole.size() / 3;
  w.set_turn(drop + 2, 1.5);
  w.set_corner(drop + 2);
  w.drop_front(drop);
  ASSERT_EQ(w.size(), whole.size() - drop);
  for (std::size_t i = 0; i < w.size(); ++i) {
    EXPECT_EQ(w.point(i), whole.point(i + drop));
    EXPECT_EQ(w.path_mm(i), whole.path_mm(i + drop));
    EXPECT_EQ(w.sample_count(i), whole.sample_count(i + drop));
    EXPECT_EQ(w.inverse_limit()[i], whole.inverse_limit()[i + drop]);
    EXPECT_EQ(w.turn(i), i == 2 ? 1.5 : 0.0);
    EXPECT_EQ(w.is_corner(i), i == 2);
  }
}

TEST(SampleWindow, ClearedAndReusedItForgetsMarks) {
  SampleWindow w(kToleranceMm, kSpacingMm, 8);
  w.add({0.0, 0.0});
  w.add({0.01, 0.0});
  w.set_corner(0);
  w.set_turn(0, 2.0);
  w.clear();
  w.add({5.0, 5.0});
  EXPECT_EQ(w.size(), 1u);
  EXPECT_EQ(w.sample_count(0), 1u);
  EXPECT_EQ(w.path_mm(0), 0.0);
  EXPECT_EQ(w.turn(0), 0.0);
  EXPECT_FALSE(w.is_corner(0));
}

}  // namespace
}  // namespace felt
