#include "felt/stroke/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "felt/stroke/random_stroke.h"

namespace felt {
namespace {

/// How often the contours wind round q.
int winding(const Outline& outline, Point q) {
  int count = 0;
  for (std::size_t k = 0; k < outline.contour_count(); ++k) {
    const auto c = outline.contour(k);
    Point a = c.back();
    for (Point b : c) {
      const double side = cross(b - a, q - a);
      if (a.y <= q.y && b.y > q.y && side > 0) ++count;
      if (a.y > q.y && b.y <= q.y && side < 0) --count;
      a = b;
    }
  }
  return count;
}

/// How far q is outside the ink: min over the stroke of |q - c| - r, by dense dabs. Too large by
/// at most the gap between dabs.
double depth(const std::vector<Dab>& dabs, Point q) {
  double best = std::numeric_limits<double>::infinity();
  for (const Dab& d : dabs) best = std::min(best, distance(d.center, q) - d.radius_mm);
  return best;
}

/// Points of the plane that the outline puts on the wrong side, or that it winds the wrong way.
void expect_outline_is_the_union_of_dabs(const Stroke& s, double tolerance, std::uint64_t seed) {
  const Outline outline = outline_of(s, tolerance);
  ASSERT_EQ(outline.contour_count(), s.closed() ? 2u : 1u);
  std::vector<Dab> dense;
  flatten(s, 1e-5, dense);
  testing::RandomStroke random(seed);
  const Rect box = s.bounds().inflated(0.5);
  const double gap = 1e-4;
  for (int k = 0; k < 400; ++k) {
    Point q{random.uniform(box.x0, box.x1), random.uniform(box.y0, box.y1)};
    if (k % 2 == 0) {  // near an edge, where errors are
      const Dab d =
          dense[static_cast<std::size_t>(random.pick(0, static_cast<int>(dense.size()) - 1))];
      const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
      const double r = d.radius_mm + random.uniform(-3.0, 3.0) * tolerance;
      q = d.center + r * Vec{std::cos(angle), std::sin(angle)};
    }
    const double outside = depth(dense, q);
    const int w = winding(outline, q);
    EXPECT_LE(w, 0) << "wound the wrong way at " << q.x << ", " << q.y;
    if (outside < -tolerance) {
      EXPECT_NE(w, 0) << "hole at " << q.x << ", " << q.y;
    }
    if (outside > tolerance + gap) {
      EXPECT_EQ(w, 0) << "ink at " << q.x << ", " << q.y;
    }
  }
}

TEST(Outline, IsTheUnionOfDabsOnRandomStrokes) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    expect_outline_is_the_union_of_dabs(s, seed % 2 == 0 ? 0.05 : 0.005, seed);
    if (::testing::Test::HasFailure()) break;
  }
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
  for (Dab& d : ring) d.radius_mm = 5.5;  // the hole is grown over
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
}  // namespace felt
