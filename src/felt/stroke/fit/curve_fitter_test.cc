#include "felt/stroke/fit/curve_fitter.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "felt/stroke/testing/fit_oracle.h"
#include "felt/stroke/testing/test_ink.h"

namespace felt::curve_fitter_test {
namespace {

using testing::fit_online;
using testing::TestInk;

constexpr int kStrokes = 200;

TEST(CurveFitter, R2EverySampleIsWithinTheToleranceOfItsPlace) {
  for (std::uint64_t seed = 0; seed < kStrokes; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    const double tolerance = random.tolerance();
    const std::vector<Point> ink = random.draw_any(300);
    const FittedCurve curve = fit_online(ink, tolerance);
    ASSERT_TRUE(testing::has_all_places(curve, ink.size()));
    EXPECT_LE(testing::worst_error(curve, ink), tolerance);
  }
}

TEST(CurveFitter, R4SmoothJointsAreG1) {
  for (std::uint64_t seed = 0; seed < kStrokes; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    const double tolerance = random.tolerance();
    EXPECT_LE(testing::worst_smooth_turn_deg(fit_online(random.draw_any(300), tolerance)),
              kSmoothJointMaxDeg);
  }
}

TEST(CurveFitter, R2NoLoopOrSpikeBetweenSamples) {
  for (std::uint64_t seed = 0; seed < kStrokes / 2; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    const double tolerance = random.tolerance();
    const std::vector<Point> ink = random.draw_any(150);
    EXPECT_LE(testing::worst_overshoot(fit_online(ink, tolerance), ink), 4.0 * tolerance);
  }
}

TEST(CurveFitter, R5AZigzagKeepsItsCorners) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    std::vector<Point> ink, turns;
    for (int leg = 0; leg < 12; ++leg) {
      const Point from{5.0 * leg, leg % 2 == 0 ? 0.0 : 8.0};
      const Point to{5.0 * (leg + 1), leg % 2 == 0 ? 8.0 : 0.0};
      if (leg > 0) turns.push_back(from);
      for (int k = 0; k < 90; ++k) {
        const Point p = lerp(from, to, k / 90.0) + random.noise(0.01);
        ink.push_back({0.03 * std::round(p.x / 0.03), 0.03 * std::round(p.y / 0.03)});
      }
    }
    const std::vector<Point> corners = testing::corners_of(fit_online(ink, 0.15));
    EXPECT_GE(corners.size(), 10u);
    EXPECT_LE(corners.size(), 11u);
    for (const Point corner : corners) {
      const auto near_corner = [&](Point turn) { return distance(turn, corner) <= 0.5; };
      EXPECT_TRUE(std::any_of(turns.begin(), turns.end(), near_corner));
    }
  }
}

TEST(CurveFitter, R7ASegmentOnceCommittedNeverChanges) {
  TestInk random(11);
  const std::vector<Point> ink = random.draw(testing::InkShape::kDense, 3000);
  CurveFitter fitter({.tolerance_mm = 0.15});
  fitter.begin();
  std::vector<Cubic> seen;
  for (const Point p : ink) {
    fitter.push(p);
    for (int i = static_cast<int>(seen.size()); i < fitter.segment_count(); ++i) {
      seen.push_back(fitter.segment(i));
    }
  }
  fitter.end();
  ASSERT_GT(seen.size(), 10u);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(fitter.segment(static_cast<int>(i)), seen[i]) << i;
  }
}

TEST(CurveFitter, R7AReusedFitterGivesTheSameBytesAsAFreshOne) {
  CurveFitter reused({.tolerance_mm = 0.2});
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<Point> ink = TestInk(seed).draw_any(400);
    reused.begin();
    for (const Point p : ink) reused.push(p);
    reused.end();
    EXPECT_EQ(reused.curve(), fit_online(ink, 0.2));
  }
}

TEST(CurveFitter, TheLiveTailReachesTheNewestSample) {
  TestInk random(5);
  CurveFitter fitter({.tolerance_mm = 0.15});
  fitter.begin();
  std::vector<Cubic> tail;
  for (const Point p : random.draw(testing::InkShape::kSmooth, 500)) {
    fitter.push(p);
    tail.clear();
    fitter.append_live_tail(tail);
    if (!tail.empty()) {
      EXPECT_EQ(tail.back().p[3], p);
    }
  }
}

TEST(CurveFitter, R10DotsAndRestsAndNoSampleAtAll) {
  const Point p{12.0, 34.0};
  EXPECT_EQ(fit_online({}, 0.15).segment_count(), 0);
  for (const std::size_t count : {1u, 2u, 1000u}) {
    const FittedCurve dot = fit_online(std::vector<Point>(count, p), 0.15);
    EXPECT_EQ(dot.segment_count(), 1);
    EXPECT_EQ(dot.sample_u.size(), count);
    EXPECT_GE(control_length(dot.segment(0)), kMinSegmentMm);
  }
}

TEST(CurveFitter, TheEndsOfACurveAreTheEndsOfTheInk) {
  TestInk random(3);
  const std::vector<Point> ink = random.draw(testing::InkShape::kSmooth, 200);
  const FittedCurve curve = fit_online(ink, 0.15);
  EXPECT_EQ(curve.points.front(), ink.front());
  EXPECT_EQ(curve.points.back(), ink.back());
}

TEST(CurveFitter, AStraightLineIsFewSegments) {
  std::vector<Point> ink;
  for (int i = 0; i <= 100; ++i) ink.push_back({0.5 * i, 0.25 * i});
  EXPECT_EQ(fit_online(ink, 0.15).segment_count(), 1);
}

}  // namespace
}  // namespace felt::curve_fitter_test
