#include "felt/stroke/fit/kept_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "felt/stroke/fit/curve_fitter.h"
#include "felt/stroke/testing/test_ink.h"

namespace felt::kept_samples_test {
namespace {

using testing::InkShape;
using testing::kAllShapes;
using testing::TestInk;

// The tolerance of pens, and what the fit keeps at it.
constexpr double kPenToleranceMm = CurveFitOptions{}.tolerance_mm;
constexpr double kMergedMm = CurveFitter::spacing_mm(kPenToleranceMm);

KeptSamples filled(const std::vector<Point>& ink) {
  KeptSamples kept(kPenToleranceMm, kMergedMm);
  for (const Point p : ink) kept.add(p);
  return kept;
}

class KeptSamplesOf : public ::testing::TestWithParam<InkShape> {};
INSTANTIATE_TEST_SUITE_P(AllInk, KeptSamplesOf, ::testing::ValuesIn(kAllShapes),
                         ::testing::PrintToStringParamName());

TEST_P(KeptSamplesOf, R3KeptSamplesAreTheSpacingApart) {
  const KeptSamples w = filled(TestInk(1).draw(GetParam(), 3000));
  for (std::size_t i = 1; i < w.size(); ++i) {
    ASSERT_GT(distance(w.point(i - 1), w.point(i)), kMergedMm) << "sample " << i;
  }
}

TEST_P(KeptSamplesOf, R8EverySampleIsKeptOrWithinTheSpacingOfTheOneThatStandsForIt) {
  const std::vector<Point> ink = TestInk(2).draw(GetParam(), 3000);
  const KeptSamples w = filled(ink);
  std::size_t next = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    double slack = 0.0;
    bool is_one_of_them = false;
    for (std::size_t k = 0; k < w.sample_count(i); ++k, ++next) {
      slack = std::max(slack, distance(ink[next], w.point(i)));
      is_one_of_them = is_one_of_them || ink[next] == w.point(i);
    }
    ASSERT_TRUE(is_one_of_them);
    ASSERT_LE(slack, kMergedMm * (1.0 + 1e-12));
    const double limit = w.tolerance_mm() - slack;
    ASSERT_NEAR(w.inverse_limit(i) * limit * limit, 1.0, 1e-12);
  }
  EXPECT_EQ(next, ink.size());
  EXPECT_EQ(w.newest(), ink.back());
}

TEST(KeptSamples, R8TheNearerOfTwoKeptSamplesStandsForWhatLiesBetween) {
  const KeptSamples w = filled({{0.0, 0.0}, {0.01, 0.0}, {0.028, 0.0}, {0.035, 0.0}});
  ASSERT_EQ(w.size(), 2u);
  EXPECT_EQ(w.sample_count(0), 2u);
  EXPECT_EQ(w.sample_count(1), 2u);
  EXPECT_NEAR(1.0 / std::sqrt(w.inverse_limit(0)), w.tolerance_mm() - 0.01, 1e-12);
  EXPECT_NEAR(1.0 / std::sqrt(w.inverse_limit(1)), w.tolerance_mm() - 0.007, 1e-12);
}

TEST_P(KeptSamplesOf, PathIsTheLengthAlongKeptSamples) {
  const KeptSamples w = filled(TestInk(3).draw(GetParam(), 500));
  double path = 0.0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (i > 0) path += distance(w.point(i - 1), w.point(i));
    ASSERT_NEAR(w.path_mm(i), path, 1e-12 * path);
  }
}

TEST(KeptSamples, R8SpeedDropsNothing) {
  KeptSamples w(kPenToleranceMm, CurveFitter::kDataPointMm);  // 500 mm/s at 1 kHz
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(w.add({0.5 * i, 0.0}));
  EXPECT_EQ(w.size(), 1000u);
}

TEST(KeptSamples, ClearedAndReusedItForgetsMarks) {
  KeptSamples w(kPenToleranceMm, kMergedMm);
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
}  // namespace felt::kept_samples_test
