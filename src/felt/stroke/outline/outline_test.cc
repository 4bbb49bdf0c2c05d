#include "felt/stroke/outline/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "felt/stroke/testing/ink_oracle.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::outline_test {
namespace {

using testing::winding;

TEST(Outline, IsTheUnionOfDabsOnRandomStrokes) {
  StrokeOutliner outliner;
  for (std::uint64_t seed = 0; seed < 250; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    const double tolerance = seed % 2 == 0 ? 0.05 : 0.005;
    const Outline& outline = outliner.trace(s, tolerance);
    ASSERT_EQ(outline.contour_count(), s.closed() ? 2u : 1u);
    testing::expect_outline_is_the_ink(outline, s, tolerance, seed, 200);
    if (::testing::Test::HasFailure()) break;
  }
}

TEST(Flatten, TellsTheEndsOfSegments) {
  std::vector<Dab> dabs;
  std::vector<std::size_t> ends;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Stroke s = testing::random_stroke(seed);
    const int first = s.segment_count() / 3;
    flatten(s, first, s.segment_count(), 0.01, dabs, ends);
    ASSERT_EQ(ends.size(), static_cast<std::size_t>(s.segment_count() - first));
    EXPECT_EQ(ends.back(), dabs.size() - 1);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      EXPECT_EQ(dabs[ends[i]].center, s.segment(first + static_cast<int>(i)).p[3]);
      EXPECT_GT(ends[i], i == 0 ? 0 : ends[i - 1]);
    }
  }
  // The first segment passes through its end (12, 0) at t = 1/2 already, where a width
  // breakpoint makes a dab.
  const Stroke turns =
      Stroke::create({.points = {{0, 0}, {20, 0}, {8, 0}, {12, 0}, {12, 3}, {12, 6}, {12, 9}},
                      .joints = {JointKind::kCorner},
                      .closed = false,
                      .widths = {{0.0, 1.0}, {0.5, 1.5}, {2.0, 1.0}}})
          .value();
  flatten(turns, 0, 2, 0.01, dabs, ends);
  const auto is_end = [](const Dab& dab) { return dab.center == Point{12, 0}; };
  ASSERT_LT(std::find_if(dabs.begin(), dabs.end(), is_end) - dabs.begin(),
            static_cast<std::ptrdiff_t>(ends[0]));
  EXPECT_EQ(dabs[ends[0] + 1].center.x, 12.0);
  EXPECT_GT(dabs[ends[0] + 1].center.y, 0.0);
}

TEST(Outline, TaperedCapsuleTouchesBothDabs) {
  const Stroke s = testing::straight_stroke({0, 0}, {10, 0}, 2.0, 6.0);
  const Outline outline = outline_of(s, 1e-3);
  // The common tangent of the end circles: sin of its slope is (3 - 1) / 10.
  const double sine = 0.2, cosine = std::sqrt(1.0 - sine * sine);
  double nearest = 1.0;
  for (Point p : outline.points) nearest = std::min(nearest, distance(p, {-sine, cosine}));
  EXPECT_LE(nearest, 1e-9);
}

TEST(Outline, DabThatSwallowsTheRest) {
  const std::vector<Dab> dabs = {{{0, 0}, 0.2}, {{1, 0}, 3.0}, {{2, 0.5}, 0.1}, {{9, 0}, 0.1}};
  StrokeOutliner outliner;
  const Outline& outline = outliner.trace(dabs, false, 0.001);
  EXPECT_NE(winding(outline, {-1.9, 0.0}), 0);
  EXPECT_NE(winding(outline, {1.0, 2.9}), 0);
  EXPECT_NE(winding(outline, {1.0, -2.9}), 0);
  EXPECT_NE(winding(outline, {3.9, 0.0}), 0);
  EXPECT_NE(winding(outline, {8.0, 0.07}), 0);
  EXPECT_EQ(winding(outline, {-2.1, 0.0}), 0);
  EXPECT_EQ(winding(outline, {8.0, 0.2}), 0);
}

TEST(Outline, WidthThatJumpsOnTheSpot) {
  const std::vector<Dab> dabs = {{{0, 0}, 0.2}, {{5, 0}, 0.2}, {{5, 0}, 2.0}, {{9, 0}, 2.0}};
  StrokeOutliner outliner;
  const Outline& outline = outliner.trace(dabs, false, 0.001);
  EXPECT_NE(winding(outline, {3.1, 0.1}), 0);
  EXPECT_NE(winding(outline, {5.0, 1.95}), 0);
  EXPECT_NE(winding(outline, {5.0, -1.95}), 0);
  EXPECT_EQ(winding(outline, {3.2, 1.2}), 0);
}

TEST(Outline, ExactReversalKeepsItsRoundEnd) {
  const std::vector<Dab> dabs = {{{0, 0}, 1.0}, {{5, 0}, 1.0}, {{1, 0}, 1.0}};
  StrokeOutliner outliner;
  const Outline& outline = outliner.trace(dabs, false, 0.001);
  EXPECT_NE(winding(outline, {5.95, 0.0}), 0);
  EXPECT_NE(winding(outline, {5.6, 0.7}), 0);
  EXPECT_NE(winding(outline, {5.6, -0.7}), 0);
}

TEST(Outline, RingHasAHole) {
  std::vector<Dab> ring;
  for (int k = 0; k < 60; ++k) {
    const double a = 2.0 * std::numbers::pi * k / 60;
    ring.push_back({{5 * std::cos(a), 5 * std::sin(a)}, 1.0});
  }
  StrokeOutliner outliner;
  for (int turn = 0; turn < 2; ++turn) {
    const Outline& outline = outliner.trace(ring, true, 0.01);
    EXPECT_EQ(winding(outline, {0, 0}), 0);
    EXPECT_EQ(winding(outline, {0, 3.9}), 0);
    EXPECT_NE(winding(outline, {0, 4.1}), 0);
    EXPECT_NE(winding(outline, {5.9, 0}), 0);
    EXPECT_EQ(winding(outline, {6.1, 0}), 0);
    std::reverse(ring.begin(), ring.end());
  }
  for (Dab& d : ring) d.radius_mm = 5.5;  // the ink covers the hole
  EXPECT_NE(winding(outliner.trace(ring, true, 0.01), {0, 0}), 0);
}

TEST(Outline, DotIsADisc) {
  const Stroke dot = testing::straight_stroke({3, 3}, {3.05, 3}, 1.0, 1.0);
  const Outline outline = outline_of(dot, 0.001);
  for (Point p : outline.points) EXPECT_NEAR(distance(p, {3.025, 3}), 0.5, 0.03);
  StrokeOutliner outliner;
  EXPECT_EQ(outliner.trace(std::vector<Dab>{{{1, 1}, 2.0}}, false, 0.01).contour_count(), 1u);
  EXPECT_EQ(outliner.trace(std::vector<Dab>{}, false, 0.01).contour_count(), 0u);
}

TEST(Flatten, AbsurdStrokesStayWithinMemory) {
  StrokeData d = testing::straight_stroke({0, 0}, {1, 0}, 1, 1).data();
  constexpr int kSegments = 20'000;
  for (int i = 1; i < kSegments; ++i) {
    const double x = i % 2 == 0 ? 1.0 : 1e300;
    d.points.insert(d.points.end(), {{x, 3e299}, {0, x}, {x, 7}});
    d.joints.push_back(JointKind::kCorner);
  }
  d.widths.back().u = kSegments;
  std::vector<Dab> dabs;
  flatten(Stroke::create(std::move(d)).value(), 1e-3, dabs);
  EXPECT_LE(dabs.size(), static_cast<std::size_t>(kMaxStrokeSteps) + 1);
}

TEST(Flatten, StaysWithinTheToleranceAtTheSameParameter) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Stroke s = testing::random_stroke(seed);
    std::vector<Dab> coarse;
    flatten(s, 0.02, coarse);
    const int n = s.segment_count();
    for (int k = 0; k <= 300; ++k) {
      const Point p = s.position(n * k / 300.0);
      double best = 1.0;
      for (std::size_t i = 0; i + 1 < coarse.size(); ++i) {
        const Vec way = coarse[i + 1].center - coarse[i].center;
        const double t = std::clamp(
            dot(p - coarse[i].center, way) / std::max(1e-300, norm_squared(way)), 0.0, 1.0);
        best = std::min(best, distance(p, lerp(coarse[i].center, coarse[i + 1].center, t)));
      }
      EXPECT_LE(best, 0.02) << seed;
    }
  }
}

}  // namespace
}  // namespace felt::outline_test
