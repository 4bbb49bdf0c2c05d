#include "felt/stroke/stroke.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "felt/base/constants.h"
#include "felt/stroke/outline/outline.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::stroke_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Returns a stroke of two segments with a smooth joint and three width breakpoints.
StrokeData wave() {
  return {.points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}, {5, -2}, {7, -2}, {8, 0}},
          .joints = {JointKind::kSmooth},
          .closed = false,
          .widths = {{0.0, 0.5}, {0.75, 1.0}, {2.0, 0.25}}};
}

TEST(Stroke, RandomValidStrokesPass) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const auto ok = check_invariants(testing::RandomStroke(seed).make());
    EXPECT_TRUE(ok) << "seed " << seed << ": " << (ok ? "" : ok.error().message);
  }
}

struct Damage {
  const char* what;
  const char* invariant;
  const char* place;
  std::function<void(StrokeData&)> apply;
};

class BrokenInvariant : public ::testing::TestWithParam<Damage> {};

TEST_P(BrokenInvariant, IsNamedWithItsPlace) {
  StrokeData data = wave();
  ASSERT_TRUE(check_invariants(data));
  GetParam().apply(data);
  const auto result = Stroke::create(data);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kInvalidData);
  EXPECT_THAT(result.error().message, StartsWith(GetParam().invariant));
  EXPECT_THAT(result.error().message, HasSubstr(GetParam().place));
}

INSTANTIATE_TEST_SUITE_P(
    Each, BrokenInvariant,
    ::testing::Values(
        Damage{"NotJoined", "I1", "6 control points", [](auto& d) { d.points.pop_back(); }},
        Damage{"NoPoints", "I1", "0 control points", [](auto& d) { d.points.clear(); }},
        Damage{"ClosedWithGap", "I1", "(8, 0)",
               [](auto& d) {
                 d.closed = true;
                 d.joints.push_back(JointKind::kCorner);
               }},
        Damage{"KinkAtSmoothJoint", "I2", "joint 1 at (4, 0)",
               [](auto& d) { d.points[4].x += 1e-6; }},
        Damage{"Reversal", "I2", "180 degrees", [](auto& d) { d.points[4] = d.points[2]; }},
        Damage{"KinkBehindZeroHandle", "I2", "joint 1", [](auto& d) { d.points[4] = d.points[3]; }},
        Damage{"TooManyJoints", "I2", "2 joint kinds for 2 segments",
               [](auto& d) { d.joints.push_back(JointKind::kCorner); }},
        Damage{"EndInside", "I2", "joint 1", [](auto& d) { d.joints[0] = JointKind::kEnd; }},
        Damage{"NanPoint", "I3", "control point 5", [](auto& d) { d.points[5].y = kNan; }},
        Damage{"InfiniteWidth", "I3", "width breakpoint 1",
               [](auto& d) { d.widths[1].width_mm = kInf; }},
        Damage{"NanParameter", "I3", "width breakpoint 2", [](auto& d) { d.widths[2].u = kNan; }},
        Damage{"TooThin", "I4", "width breakpoint 1 has W = 0.04",
               [](auto& d) { d.widths[1].width_mm = 0.04; }},
        Damage{"NegativeWidth", "I4", "breakpoint 0", [](auto& d) { d.widths[0].width_mm = -1; }},
        Damage{"ShortSegment", "I5", "segment 1",
               [](auto& d) {
                 d.joints[0] = JointKind::kCorner;
                 for (std::size_t i = 4; i < 7; ++i) d.points[i] = {4.01, 0};
               }},
        Damage{"NanTone", "I3", "width breakpoint 1", [](auto& d) { d.widths[1].tone = kNan; }},
        Damage{"NegativeTone", "I7", "breakpoint 1 has tone -0.5",
               [](auto& d) { d.widths[1].tone = -0.5; }},
        Damage{"TooMuchTone", "I7", "breakpoint 2 has tone 1.01",
               [](auto& d) { d.widths[2].tone = 1.01; }},
        Damage{"NoWidths", "I6", "there are none", [](auto& d) { d.widths.clear(); }},
        Damage{"WidthsStartLate", "I6", "0.1", [](auto& d) { d.widths[0].u = 0.1; }},
        Damage{"WidthsEndEarly", "I6", "1.9", [](auto& d) { d.widths[2].u = 1.9; }},
        Damage{"WidthsRepeat", "I6", "breakpoint 1", [](auto& d) { d.widths[1].u = 0.0; }}),
    [](const auto& damage) { return damage.param.what; });

TEST(Stroke, ZeroHandlesTakeTheTangentOfTheNextControlPoint) {
  StrokeData d = wave();
  d.points[2] = d.points[3];  // now the tangent before the joint is (1,2) -> (4,0)
  d.points[4] = d.points[3];
  d.points[5] = {7, -2};
  EXPECT_TRUE(check_invariants(d)) << check_invariants(d).error().message;
}

TEST(Stroke, SmallestDotIsLegalAnywhere) {
  for (double x : {0.0, 1.0 / 3.0, 1234.567, 9e5}) {
    const Cubic c = straight({x, x}, {x + kMinSegmentMm, x});
    EXPECT_TRUE(Stroke::create({.points = {c.p.begin(), c.p.end()},
                                .joints = {},
                                .closed = false,
                                .widths = {{0.0, 0.3}, {1.0, 0.3}}}))
        << x;
  }
}

TEST(Stroke, AKnotWithoutAToneHasThatOfItsWidth) {
  static_assert(WidthKnot{0.0, 0.3}.tone == 0.0 && WidthKnot{0.0, 6.0}.tone == 1.0);
  static_assert(WidthKnot{0.0, 0.1}.tone == 0.0 && WidthKnot{0.0, 60.0}.tone == 1.0);
  const Stroke s = Stroke::create(wave()).value();
  for (const WidthKnot& k : s.widths()) EXPECT_EQ(k.tone, tone_of_width(k.width_mm));
}

TEST(Stroke, ToneIsLinearLikeTheWidth) {
  StrokeData d = wave();
  d.widths = {{0.0, 0.5, 1.0}, {0.75, 1.0, 0.2}, {2.0, 0.25, 0.7}};
  const Stroke s = Stroke::create(d).value();
  EXPECT_EQ(s.tone(-1.0), 1.0);
  EXPECT_EQ(s.tone(0.75), 0.2);
  EXPECT_NEAR(s.tone(0.375), 0.6, 1e-12);
  EXPECT_EQ(s.tone(9.0), 0.7);
}

TEST(Stroke, DabsCarryTheTone) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    std::vector<Dab> dabs, part;
    flatten(s, 0.01, dabs);
    EXPECT_EQ(dabs.front().tone, s.widths().front().tone);
    EXPECT_EQ(dabs.back().tone, s.widths().back().tone);
    for (const Dab& dab : dabs) EXPECT_TRUE(dab.tone >= 0.0 && dab.tone <= 1.0) << dab.tone;
    for (const WidthKnot& k : s.widths()) {
      const Point at = s.position(k.u);
      EXPECT_TRUE(std::any_of(dabs.begin(), dabs.end(), [&](const Dab& dab) {
        return distance(dab.center, at) < 1e-9 && std::fabs(dab.tone - k.tone) < 1e-9;
      })) << k.u;
    }
    const int last = s.segment_count() - 1;
    flatten(s, last, last + 1, 0.01, part);
    ASSERT_LE(part.size(), dabs.size());
    EXPECT_NEAR(part.front().tone, s.tone(last), 1e-12);
    EXPECT_TRUE(std::equal(part.rbegin(), part.rend() - 1, dabs.rbegin()));
  }
}

TEST(Stroke, PositionAndWidthAreClampedToTheStroke) {
  const Stroke s = Stroke::create(wave()).value();
  EXPECT_EQ(s.position(-1.0), (Point{0, 0}));
  EXPECT_EQ(s.position(1.0), (Point{4, 0}));
  EXPECT_EQ(s.position(2.5), (Point{8, 0}));
  EXPECT_EQ(s.position(kNan), (Point{0, 0}));
  EXPECT_EQ(s.width_mm(-1.0), 0.5);
  EXPECT_EQ(s.width_mm(0.75), 1.0);
  EXPECT_NEAR(s.width_mm(0.375), 0.75, 1e-12);
  EXPECT_NEAR(s.width_mm(1.375), 0.625, 1e-12);
  EXPECT_EQ(s.width_mm(9.0), 0.25);
}

TEST(Stroke, JointsAtTheEnds) {
  StrokeData d = wave();
  EXPECT_EQ(Stroke::create(d)->joint(0), JointKind::kEnd);
  EXPECT_EQ(Stroke::create(d)->joint(1), JointKind::kSmooth);
  EXPECT_EQ(Stroke::create(d)->joint(2), JointKind::kEnd);
  d.points.back() = d.points.front();
  d.closed = true;
  d.joints.push_back(JointKind::kCorner);
  const Stroke ring = Stroke::create(d).value();
  EXPECT_EQ(ring.joint(0), JointKind::kCorner);
  EXPECT_EQ(ring.joint(2), JointKind::kCorner);
}

TEST(Stroke, BoundsContainEveryDab) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Stroke s = testing::random_stroke(seed);
    const Rect box = s.bounds().inflated(1e-9);
    for (int k = 0; k <= 200; ++k) {
      const double u = s.segment_count() * k / 200.0;
      const Point p = s.position(u);
      const double r = 0.5 * s.width_mm(u);
      EXPECT_TRUE(box.contains({p.x - r, p.y - r}) && box.contains({p.x + r, p.y + r})) << seed;
    }
  }
}

}  // namespace
}  // namespace felt::stroke_test
