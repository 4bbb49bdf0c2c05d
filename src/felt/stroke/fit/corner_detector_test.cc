#include "felt/stroke/fit/corner_detector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "felt/stroke/testing/test_ink.h"

namespace felt::corner_detector_test {
namespace {

using testing::InkShape;
using testing::kAllShapes;
using testing::TestInk;

constexpr double kToleranceMm = 0.15, kSpacingMm = 0.01875;
constexpr double kDeg = std::numbers::pi / 180.0;

KeptSamples kept_of(const std::vector<Point>& ink) {
  KeptSamples kept(kToleranceMm, kSpacingMm);
  for (const Point p : ink) kept.add(p);
  return kept;
}

std::vector<std::size_t> marked(const KeptSamples& kept) {
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept.is_corner(i)) corners.push_back(i);
  }
  return corners;
}

std::vector<std::size_t> corners_of(const std::vector<Point>& ink) {
  KeptSamples kept = kept_of(ink);
  CornerDetector().finish(kept);
  return marked(kept);
}

// Returns two legs of `leg_mm` that meet at sample leg_mm / step_mm.
std::vector<Point> two_legs(double turn_deg, double step_mm, double leg_mm = 10.0) {
  const Vec out{std::cos(turn_deg * kDeg), std::sin(turn_deg * kDeg)};
  const int steps = static_cast<int>(std::lround(leg_mm / step_mm));
  std::vector<Point> ink;
  for (int i = -steps; i <= steps; ++i) {
    ink.push_back(i < 0 ? Point{step_mm * i, 0.0} : Point{} + step_mm * i * out);
  }
  return ink;
}

std::vector<Point> circle(double radius_mm, double step_mm, double sigma, std::uint64_t seed) {
  TestInk random(seed);
  std::vector<Point> ink;
  for (double path = 0.0; path < 4.0 * std::numbers::pi * radius_mm; path += step_mm) {
    const double a = path / radius_mm;
    ink.push_back(Point{} + radius_mm * Vec{std::cos(a), std::sin(a)} + random.noise(sigma));
  }
  return ink;
}

TEST(CornerDetector, R5SharpTurnsAreCornersAtTheirSample) {
  for (const double step : {0.05, 0.1, 0.25, 0.5, 1.0, 3.0}) {
    for (const double turn : {65.0, 90.0, 120.0, 150.0, 179.0}) {
      const auto corners = corners_of(two_legs(turn, step));
      ASSERT_EQ(corners.size(), 1u) << "turn " << turn << ", step " << step;
      EXPECT_EQ(corners[0], static_cast<std::size_t>(std::lround(10.0 / step)));
    }
  }
}

TEST(CornerDetector, R5GentleTurnsAreNone) {
  for (const double step : {0.05, 0.25, 1.0}) {
    for (const double turn : {0.0, 20.0, 45.0, 55.0}) {
      EXPECT_TRUE(corners_of(two_legs(turn, step)).empty()) << turn << ", step " << step;
    }
  }
}

TEST(CornerDetector, R5RoundShapesHaveNone) {
  for (const double radius : {0.6, 1.0, 2.0, 5.0, 20.0}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      EXPECT_TRUE(corners_of(circle(radius, 0.1, 0.01, seed)).empty())
          << "radius " << radius << ", seed " << seed;
    }
  }
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    TestInk random(seed);
    EXPECT_TRUE(corners_of(random.draw(InkShape::kSmooth, 500)).empty()) << seed;
    EXPECT_TRUE(corners_of(random.draw(InkShape::kDense, 2000)).empty()) << seed;
  }
}

// The noise of the sensor turns by any angle, but its steps are smaller than the scale of a corner.
TEST(CornerDetector, R5ARestingPenHasNone) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto ink = TestInk(seed).draw(InkShape::kResting, 3000);
    EXPECT_TRUE(corners_of(ink).empty()) << seed;
  }
}

TEST(CornerDetector, R5ARestInACornerLeavesItOneCorner) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    TestInk random(seed);
    std::vector<Point> ink = two_legs(100.0, 0.1);
    const std::size_t middle = ink.size() / 2;
    std::vector<Point> rest;
    for (int i = 0; i < 60; ++i) rest.push_back(ink[middle] + random.noise(0.02));
    ink.insert(ink.begin() + static_cast<std::ptrdiff_t>(middle), rest.begin(), rest.end());
    const KeptSamples kept = kept_of(ink);
    const auto corners = corners_of(ink);
    ASSERT_EQ(corners.size(), 1u) << "seed " << seed;
    EXPECT_LE(distance(kept.point(corners[0]), Point{}), kToleranceMm) << "seed " << seed;
  }
}

TEST(CornerDetector, R5NoneWithinAMillimetreOfAnEnd) {
  for (const double leg : {0.1, 0.3, 0.6, 0.9, 1.0}) {
    std::vector<Point> ink = two_legs(120.0, 0.05, leg);
    EXPECT_TRUE(corners_of(ink).empty()) << leg;
  }
  EXPECT_EQ(corners_of(two_legs(120.0, 0.05, 1.2)).size(), 1u);
}

TEST(CornerDetector, AnyInkTurnsAtItsCorners) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const KeptSamples kept = kept_of(TestInk(seed).draw_any(600));
    KeptSamples judged = kept;
    CornerDetector().finish(judged);
    for (const std::size_t k : marked(judged)) {
      ASSERT_GE(k, 2u);
      ASSERT_LT(k + 2, kept.size());
      EXPECT_GE(judged.turn(k), CornerDetector::kCornerDeg * kDeg) << seed;
    }
  }
}

class CornersOf : public ::testing::TestWithParam<InkShape> {};
INSTANTIATE_TEST_SUITE_P(AllInk, CornersOf, ::testing::ValuesIn(kAllShapes),
                         ::testing::PrintToStringParamName());

TEST_P(CornersOf, R7StreamingAndInOneGoAreTheSame) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto ink = TestInk(seed).draw(GetParam(), 600);
    KeptSamples kept(kToleranceMm, kSpacingMm);
    CornerDetector detector;
    std::size_t decided = 0;
    std::vector<std::size_t> early;  // corners before `decided`
    for (const Point p : ink) {
      kept.add(p);
      detector.update(kept);
      for (; decided < detector.decided(); ++decided) {
        if (kept.is_corner(decided)) early.push_back(decided);
      }
    }
    for (const std::size_t k : marked(kept)) EXPECT_LT(k, decided);
    detector.finish(kept);
    EXPECT_EQ(detector.decided(), kept.size());
    for (; decided < kept.size(); ++decided) {
      if (kept.is_corner(decided)) early.push_back(decided);
    }
    EXPECT_EQ(early, marked(kept)) << "a decision was changed, seed " << seed;
    EXPECT_EQ(marked(kept), corners_of(ink)) << "seed " << seed;
  }
}

TEST(CornerDetector, EmptyAndShortStrokesHaveNone) {
  EXPECT_TRUE(corners_of({}).empty());
  EXPECT_TRUE(corners_of({{0.0, 0.0}}).empty());
  EXPECT_TRUE(corners_of({{0.0, 0.0}, {5.0, 0.0}, {0.0, 0.1}}).empty());
}

}  // namespace
}  // namespace felt::corner_detector_test
