#include "felt/stroke/edit/join.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/stroke/testing/test_ink.h"

namespace felt::join_test {
namespace {

constexpr double kRadian = 180.0 / std::numbers::pi;

/// Returns open strokes: drawn ones of any shape, and hand-made ones.
std::vector<Stroke> open_strokes(int count) {
  std::vector<Stroke> result;
  for (std::uint64_t seed = 0; static_cast<int>(result.size()) < count; ++seed) {
    if (seed % 2 == 0) {
      const Stroke s = testing::random_stroke(seed);
      if (!s.closed()) result.push_back(s);
      continue;
    }
    testing::TestInk ink(seed);
    InkFitter fitter({});
    for (const Point p : ink.draw_any(600)) fitter.push({p, ink.uniform(0, 1), std::nullopt});
    fitter.end();
    result.push_back(fitter.stroke().value());
  }
  return result;
}

double length_of(const Stroke& s) {
  double length = 0.0;
  for (int i = 0; i < s.segment_count(); ++i) length += arc_length(s.segment(i), 1e-6);
  return length;
}

Point end_of(const Stroke& s) {
  return tip_point(s, StrokeTip::kEnd);
}

/// Both return a straight stroke of 40 mm. One ends in the origin, the other starts there at an
/// angle.
Stroke arriving() {
  return testing::straight_stroke({-40, 0}, {0, 0}, 1.0, 2.0);
}
Stroke leaving(double deg) {
  const double a = deg / kRadian;
  return testing::straight_stroke({0, 0}, {40 * std::cos(a), 40 * std::sin(a)}, 3.0, 4.0);
}

TEST(WithTipAt, TheEndLiesExactlyThereAndTheInvariantsHold) {
  int moved = 0;
  std::uint64_t seed = 0;
  for (const Stroke& s : open_strokes(400)) {
    SCOPED_TRACE(++seed);
    testing::RandomStroke random(seed);
    for (const StrokeTip tip : {StrokeTip::kStart, StrokeTip::kEnd}) {
      const double reach = std::min(25.0, 0.5 * length_of(s));
      const double far = reach / 1.5 * random.uniform(0.0, 0.99);
      const double angle = random.uniform(0.0, 7.0);
      const Point target = tip_point(s, tip) + far * Vec{std::cos(angle), std::sin(angle)};
      const auto result = with_tip_at(s, tip, target);
      if (!result) {
        EXPECT_EQ(result.error().code, ErrorCode::kInvalidData) << result.error().message;
        continue;
      }
      ++moved;
      EXPECT_EQ(tip_point(*result, tip), target);
      EXPECT_EQ(tip_point(*result, opposite(tip)), tip_point(s, opposite(tip)));
      EXPECT_EQ(result->widths().front(), s.widths().front());
      EXPECT_EQ(result->widths().back().width_mm, s.widths().back().width_mm);
      EXPECT_EQ(result->widths().back().tone, s.widths().back().tone);
      // The tangent at the moved end is kept if its handle is not zero.
      const auto& points = s.data().points;
      const Point handle = tip == StrokeTip::kStart ? points[1] : points[points.size() - 2];
      if (handle == tip_point(s, tip)) continue;
      EXPECT_LE(angle_between(tip_direction(*result, tip), tip_direction(s, tip)) * kRadian, 1e-3);
    }
  }
  EXPECT_GT(moved, 700);
}

TEST(WithTipAt, WhatIsFartherThanTheFadeStaysBitForBit) {
  for (const Stroke& s : open_strokes(200)) {
    const auto result = with_tip_at(s, StrokeTip::kEnd, end_of(s) + Vec{0.01, 0.02});
    if (!result) continue;
    const double whole = length_of(s), reach = std::min(25.0, 0.5 * whole);
    double along = 0.0;
    for (int i = 0; i < s.segment_count(); ++i) {
      along += arc_length(s.segment(i), 1e-6);
      if (along > whole - reach - 0.2) break;
      EXPECT_EQ(result->segment(i), s.segment(i));
    }
  }
}

TEST(WithTipAt, TheShiftFadesEvenly) {
  // A line of ten segments, 200 mm long: exactly 25 mm move, and the shift decreases to 0.
  StrokeData data = testing::straight_stroke({0, 0}, {20, 0}, 1, 1).data();
  for (int i = 1; i < 10; ++i) {
    const Cubic c = straight({20.0 * i, 0}, {20.0 * (i + 1), 0});
    data.points.insert(data.points.end(), c.p.begin() + 1, c.p.end());
    data.joints.push_back(JointKind::kSmooth);
  }
  data.widths.back().u = 10;
  const Stroke s = Stroke::create(data).value();
  const auto moved = with_tip_at(s, StrokeTip::kEnd, {200, 3});
  ASSERT_TRUE(moved);
  ASSERT_EQ(moved->segment_count(), 11);
  double last = 0.0;
  for (int k = 0; k <= 1000; ++k) {
    const Point p = moved->position(11.0 * k / 1000.0);
    if (p.x <= 174.999) {
      EXPECT_EQ(p.y, 0.0);
    }
    EXPECT_GE(p.y, last - 1e-12);
    last = p.y;
  }
  EXPECT_EQ(last, 3.0);
}

TEST(WithTipAt, RefusesWhatWouldFold) {
  const Stroke s = arriving();
  EXPECT_FALSE(with_tip_at(s, StrokeTip::kEnd, {0, 14}));
  EXPECT_TRUE(with_tip_at(s, StrokeTip::kEnd, {0, 13}));
  EXPECT_FALSE(with_tip_at(s, StrokeTip::kEnd, {std::numeric_limits<double>::quiet_NaN(), 0}));
  EXPECT_EQ(with_tip_at(s, StrokeTip::kEnd, {0, 0}).value(), s);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Stroke t = testing::random_stroke(seed);
    if (t.closed()) {
      EXPECT_FALSE(with_tip_at(t, StrokeTip::kEnd, {0, 0}));
    }
  }
}

TEST(Joined, R45_SmoothBelowThirtyDegreesElseCorner) {
  for (const auto& [deg, kind] :
       {std::pair(10.0, JointKind::kSmooth), std::pair(29.0, JointKind::kSmooth),
        std::pair(31.0, JointKind::kCorner), std::pair(90.0, JointKind::kCorner)}) {
    for (const double sign : {-1.0, 1.0}) {
      SCOPED_TRACE(sign * deg);
      const auto one = joined(arriving(), leaving(sign * deg));
      ASSERT_TRUE(one);
      ASSERT_EQ(one->segment_count(), 2);
      EXPECT_EQ(one->joint(1), kind);
      const Vec in = tangent(one->segment(0), 1.0), out = tangent(one->segment(1), 0.0);
      const double turn = angle_between(in, out) * kRadian;
      if (kind == JointKind::kSmooth) {
        EXPECT_LE(turn, kSmoothJointMaxDeg);
        // The tangent has the average direction.
        EXPECT_NEAR(std::atan2(in.y, in.x) * kRadian, sign * deg / 2, 1e-9);
      } else {
        EXPECT_NEAR(turn, deg, 1e-9);
      }
      // Handles keep their lengths.
      EXPECT_NEAR(distance(one->segment(0).p[2], {0, 0}), 40.0 / 3.0, 1e-9);
      EXPECT_NEAR(distance(one->segment(1).p[1], {0, 0}), 40.0 / 3.0, 1e-9);
    }
  }
}

TEST(Closed, R45_SmoothBelowThirtyDegreesElseCorner) {
  for (const auto& [deg, kind] :
       {std::pair(10.0, JointKind::kSmooth), std::pair(29.0, JointKind::kSmooth),
        std::pair(31.0, JointKind::kCorner), std::pair(90.0, JointKind::kCorner)}) {
    SCOPED_TRACE(deg);
    const double a = deg / kRadian;
    const Vec in{1, 0}, out{std::cos(a), std::sin(a)};
    const Point o{};
    const Stroke loop =
        Stroke::create({.points = {o, o + 20 * out, {30, 60}, {0, 60}, {-30, 60}, o - 20 * in, o},
                        .joints = {JointKind::kCorner},
                        .closed = false,
                        .widths = {{0, 1}, {2, 1.5}}})
            .value();
    const auto ring = closed(loop);
    ASSERT_TRUE(ring);
    EXPECT_TRUE(ring->closed());
    EXPECT_EQ(ring->joint(0), kind);
    EXPECT_EQ(ring->joint(2), kind);
    EXPECT_EQ(ring->joint(1), JointKind::kCorner);
  }
}

TEST(Joined, AnyTwoStrokesMakeOneWithTheInvariantsAndTheirWidths) {
  const auto strokes = open_strokes(300);
  int smooth = 0;
  for (std::size_t i = 1; i < strokes.size(); ++i) {
    SCOPED_TRACE(i);
    const Stroke& a = strokes[i - 1];
    // Moves the second stroke to the end of the first.
    StrokeData moved = strokes[i].data();
    const Vec by = end_of(a) - moved.points.front();
    for (Point& p : moved.points) p += by;
    moved.points.front() = end_of(a);
    const auto b = Stroke::create(moved);
    if (!b) continue;  // rounding made a smooth joint invalid
    const auto one = joined(a, *b, i % 3 == 0 ? 180.0 : kSmoothJoinBelowDeg);
    ASSERT_TRUE(one) << one.error().message;
    const int n = a.segment_count();
    EXPECT_EQ(one->segment_count(), n + b->segment_count());
    smooth += one->joint(n) == JointKind::kSmooth ? 1 : 0;
    EXPECT_EQ(one->position(n), end_of(a));
    for (int k = 0; k < n - 1; ++k) EXPECT_EQ(one->segment(k), a.segment(k));
    for (int k = 1; k < b->segment_count(); ++k) EXPECT_EQ(one->segment(n + k), b->segment(k));
    for (int k = 0; k <= 100; ++k) {
      const double u = 0.01 * k;
      EXPECT_NEAR(one->width_mm(u * n), a.width_mm(u * n), 1e-9);
      EXPECT_NEAR(one->tone(u * n), a.tone(u * n), 1e-9);
      if (k > 0) {
        EXPECT_NEAR(one->width_mm(n + u * b->segment_count()), b->width_mm(u * b->segment_count()),
                    1e-9);
        EXPECT_NEAR(one->tone(n + u * b->segment_count()), b->tone(u * b->segment_count()), 1e-9);
      }
    }
  }
  EXPECT_GT(smooth, 50);
}

TEST(Closed, AnyStrokeWhoseEndsMeet) {
  int rings = 0;
  for (const Stroke& s : open_strokes(300)) {
    const auto met = with_tip_at(s, StrokeTip::kEnd, s.data().points.front());
    if (!met) continue;
    const auto ring = closed(*met, 180.0);
    ASSERT_TRUE(ring) << ring.error().message;
    EXPECT_TRUE(ring->closed());
    EXPECT_FALSE(closed(*ring));
    EXPECT_FALSE(joined(*ring, s));
    ++rings;
  }
  EXPECT_GT(rings, 30);
}

TEST(Joined, RefusesStrokesThatDoNotMeet) {
  EXPECT_FALSE(joined(leaving(10), arriving()));
  EXPECT_FALSE(closed(arriving()));
}

}  // namespace
}  // namespace felt::join_test
