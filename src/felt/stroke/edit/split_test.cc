#include "felt/stroke/edit/split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/stroke/testing/random_stroke.h"

namespace felt::split_test {
namespace {

/// Converts u of the part [u0, u1] of a stroke to u of the whole stroke.
double original_u(double u0, double u1, double u) {
  const double first = std::floor(u0), last = std::max(first, std::ceil(u1) - 1.0);
  const double i = std::min(first + std::floor(u), last);
  const double t = u - (i - first);
  const double t0 = i == first ? u0 - first : 0.0, t1 = i == last ? u1 - last : 1.0;
  return i + t0 + t * (t1 - t0);
}

void expect_same_ink(const Stroke& whole, const Stroke& part, double u0, double u1) {
  const int n = whole.segment_count();
  for (int k = 0; k <= 64; ++k) {
    const double u = part.segment_count() * k / 64.0;
    const double v = original_u(u0, u1, u);
    const double lap = v > n ? v - n : v;
    EXPECT_LE(distance(part.position(u), whole.position(lap)), 1e-9);
    // Widths step at the seam of a random closed stroke.
    if (std::fabs(v - n) > 1e-6) {
      EXPECT_NEAR(part.width_mm(u), whole.width_mm(lap), 1e-9);
      EXPECT_NEAR(part.tone(u), whole.tone(lap), 1e-9);
    }
  }
}

TEST(Split, PartsTraceTheSameCurveAndWidth) {
  int cuts = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    testing::RandomStroke random(seed + 7);
    const double u = random.uniform(0.0, s.segment_count());
    const auto parts = split(s, u);
    if (s.closed()) {
      EXPECT_FALSE(parts);
      continue;
    }
    if (!parts) continue;  // a sliver
    ++cuts;
    EXPECT_EQ(parts->first.data().points.back(), parts->second.data().points.front());
    EXPECT_EQ(parts->first.widths().back().width_mm, parts->second.widths().front().width_mm);
    EXPECT_EQ(parts->first.widths().back().tone, parts->second.widths().front().tone);
    EXPECT_NEAR(parts->first.widths().back().width_mm, s.width_mm(u), 1e-9);
    expect_same_ink(s, parts->first, 0.0, u);
    expect_same_ink(s, parts->second, u, s.segment_count());
  }
  EXPECT_GT(cuts, 250);
}

TEST(Split, WhatIsNotCutIsCopiedBitForBit) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Stroke s = testing::random_stroke(seed);
    if (s.closed() || s.segment_count() < 3) continue;
    const auto parts = split(s, 1.5);
    if (!parts) continue;
    const int n = s.segment_count();
    EXPECT_EQ(parts->first.segment(0), s.segment(0));
    for (int i = 2; i < n; ++i) EXPECT_EQ(parts->second.segment(i - 1), s.segment(i));
    for (const WidthKnot& k : s.widths()) {
      if (k.u < 1.0) {
        const auto w = parts->first.widths();
        EXPECT_NE(std::find(w.begin(), w.end(), k), w.end());
      }
    }
  }
}

TEST(Split, AtAJointOnlyDividesTheLists) {
  const Stroke s = testing::random_stroke(3);
  ASSERT_FALSE(s.closed());
  ASSERT_GE(s.segment_count(), 2);
  const auto parts = split(s, 1.0);
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->first.segment_count(), 1);
  EXPECT_EQ(parts->first.segment(0), s.segment(0));
  EXPECT_EQ(parts->second.segment(0), s.segment(1));
}

TEST(Split, RefusesSliversAndNonsense) {
  const Stroke s = testing::straight_stroke({0, 0}, {10, 0}, 1, 2);
  EXPECT_FALSE(split(s, 1e-4));
  EXPECT_FALSE(split(s, 0.0));
  EXPECT_FALSE(split(s, 1.0));
  EXPECT_FALSE(split(s, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(sub_stroke(s, 0.5, 0.5));
  EXPECT_EQ(*sub_stroke(s, -3.0, 7.0), s);
}

TEST(SubStroke, InsideOneSegment) {
  const auto part = sub_stroke(testing::straight_stroke({0, 0}, {10, 0}, 1, 2), 0.25, 0.75);
  ASSERT_TRUE(part);
  EXPECT_NEAR(part->position(0.0).x, 2.5, 1e-12);
  EXPECT_NEAR(part->position(1.0).x, 7.5, 1e-12);
  EXPECT_NEAR(part->width_mm(0.0), 1.25, 1e-12);
  EXPECT_NEAR(part->width_mm(1.0), 1.75, 1e-12);
  EXPECT_EQ(part->widths().size(), 2u);
}

TEST(SubStroke, ClosedStrokesRunThroughTheSeam) {
  int rings = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    if (!s.closed()) continue;
    testing::RandomStroke random(seed + 1);
    const double u = random.uniform(0.0, s.segment_count());
    const auto opened = sub_stroke(s, u, u);
    if (!opened) continue;
    ++rings;
    EXPECT_FALSE(opened->closed());
    EXPECT_LE(distance(opened->position(0.0), opened->position(1e9)), 1e-9);
    expect_same_ink(s, *opened, u, u + s.segment_count());
  }
  EXPECT_GT(rings, 50);
}

TEST(Reversed, IsTheSameInkBackwards) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Stroke s = testing::random_stroke(seed);
    const Stroke back = reversed(s);
    EXPECT_TRUE(check_invariants(back.data()));
    for (int k = 0; k <= 40; ++k) {
      const double u = s.segment_count() * k / 40.0, v = s.segment_count() - u;
      EXPECT_LE(distance(back.position(u), s.position(v)), 1e-9);
      EXPECT_NEAR(back.width_mm(u), s.width_mm(v), 1e-9);
      EXPECT_NEAR(back.tone(u), s.tone(v), 1e-9);
    }
    for (int i = 0; i <= s.segment_count(); ++i) {
      EXPECT_EQ(back.joint(i), s.joint(s.segment_count() - i));
    }
    EXPECT_EQ(reversed(back).data().points, s.data().points);
  }
}

}  // namespace
}  // namespace felt::split_test
