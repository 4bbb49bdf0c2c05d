#include "felt/geometry/cubic.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "felt/base/constants.h"
#include "felt/geometry/polyline.h"
#include "felt/geometry/testing/nearest_cases.h"

namespace felt::cubic_test {
namespace {

// Returns a cubic of one of the kinds, from one random number that RapidCheck prints if a case
// fails.
Cubic any_cubic() {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const auto kind = static_cast<CaseKind>(*rc::gen::inRange(0, kCaseKinds));
  return make_case(kind, random).curve;
}

double any_parameter() {
  return *rc::gen::inRange(0, 1 << 20) * 0x1p-20;
}

double size_of(const Cubic& c) {
  return 1.0 + std::fabs(c.p[0].x) + std::fabs(c.p[0].y) + control_length(c);
}

RC_GTEST_PROP(Cubic, R1_EvaluateIsTheBernsteinForm, ()) {
  const Cubic c = any_cubic();
  const double t = any_parameter();
  const Point at = evaluate(c, t);
  const auto bernstein = [t](const auto&... coordinates) {
    const auto wide = static_cast<long double>(t), rest = 1.0L - wide;
    const std::array<long double, 4> v{static_cast<long double>(coordinates)...};
    return static_cast<double>(rest * rest * rest * v[0] + 3 * wide * rest * rest * v[1] +
                               3 * wide * wide * rest * v[2] + wide * wide * wide * v[3]);
  };
  const double x = bernstein(c.p[0].x, c.p[1].x, c.p[2].x, c.p[3].x);
  const double y = bernstein(c.p[0].y, c.p[1].y, c.p[2].y, c.p[3].y);
  // The tolerance is absolute up to 1 m and relative beyond it: the hard cases reach 10 m, where an
  // ulp is already 2e-12.
  RC_ASSERT(std::fabs(x - at.x) <= 1e-12 * std::max(1.0, 1e-3 * std::fabs(x)));
  RC_ASSERT(std::fabs(y - at.y) <= 1e-12 * std::max(1.0, 1e-3 * std::fabs(y)));
  RC_ASSERT(evaluate(c, 0.0) == c.p[0]);
  RC_ASSERT(evaluate(c, 1.0) == c.p[3]);
}

RC_GTEST_PROP(Cubic, PartsAreOnTheCurveAndShareTheirEnds, ()) {
  const Cubic c = any_cubic();
  const double a = any_parameter(), b = any_parameter(), u = any_parameter();
  const Cubic part = sub_segment(c, a, b);
  RC_ASSERT(distance(evaluate(part, u), evaluate(c, a + u * (b - a))) <= 1e-13 * size_of(c));
  RC_ASSERT(sub_segment(c, 0.0, 1.0) == c);
  RC_ASSERT(sub_segment(c, 0.0, a).p[3] == sub_segment(c, a, 1.0).p[0]);
  RC_ASSERT(distance(evaluate(reversed(c), u), evaluate(c, 1.0 - u)) <= 1e-13 * size_of(c));
  const auto [left, right] = split(c, a);
  RC_ASSERT(left.p[3] == right.p[0]);
}

RC_GTEST_PROP(Cubic, BoundsAreTight, ()) {
  const Cubic c = any_cubic();
  const Rect box = bounds(c);
  Rect sampled;
  for (int i = 0; i <= 1000; ++i) sampled.extend(evaluate(c, i / 1000.0));
  const double rounding = 1e-15 * size_of(c), spacing = 1e-5 * control_length(c);
  const Rect grown = box.inflated(rounding);
  RC_ASSERT(grown.x0 <= sampled.x0 && grown.y0 <= sampled.y0);
  RC_ASSERT(grown.x1 >= sampled.x1 && grown.y1 >= sampled.y1);
  const Rect wide = sampled.inflated(spacing + rounding);
  RC_ASSERT(wide.x0 <= box.x0 && wide.y0 <= box.y0 && wide.x1 >= box.x1 && wide.y1 >= box.y1);
}

TEST(Cubic, BoundsOfInputThatIsNotFiniteAreEmpty) {
  EXPECT_TRUE(bounds(Cubic{{Point{0, 0}, {kNan, 0}, {1, 1}, {2, 2}}}).empty());
  EXPECT_TRUE(bounds(Cubic{{Point{0, 0}, {1, HUGE_VAL}, {1, 1}, {2, 2}}}).empty());
}

RC_GTEST_PROP(Cubic, FlatnessBoundsTheDistanceToTheChord, ()) {
  const Cubic c = any_cubic();
  const double bound = flatness(c);
  for (int i = 0; i <= 200; ++i) {
    const Point p = evaluate(c, i / 200.0);
    const double d = std::sqrt(nearest_on_line(c.p[0], c.p[3], p).distance_squared);
    RC_ASSERT(d <= bound + 1e-14 * size_of(c));
  }
}

TEST(Cubic, FlatnessOfALineIsZero) {
  EXPECT_EQ(flatness(straight({0, 0}, {8, 4})), 0.0);
}

TEST(Cubic, TangentFallsBackToTheNextDistinctControlPoint) {
  const Point a{0, 0}, b{0, 5}, d{3, 4};
  EXPECT_EQ(tangent(Cubic{{a, b, d, d}}, 0.0), (Vec{0, 1}));
  EXPECT_EQ(tangent(Cubic{{a, a, b, d}}, 0.0), (Vec{0, 1}));
  EXPECT_EQ(tangent(Cubic{{a, a, a, d}}, 0.0), (Vec{0.6, 0.8}));
  EXPECT_EQ(tangent(Cubic{{a, a, a, d}}, 1.0), (Vec{0.6, 0.8}));
  EXPECT_EQ(tangent(Cubic{{a, b, a, a}}, 1.0), (Vec{0, -1}));
  EXPECT_EQ(tangent(Cubic{{a, d, d, d}}, 1.0), (Vec{0.6, 0.8}));
  EXPECT_EQ(tangent(Cubic{{d, d, d, d}}, 0.5), Vec{});
}

TEST(Cubic, TangentAtACuspIsTheDirectionOfLeaving) {
  // The curve stops at t = 1/2 and leaves along -y.
  const Cubic c{{Point{0, 0}, {1, 1}, {0, 1}, {1, 0}}};
  ASSERT_NEAR(norm(derivative(c, 0.5)), 0.0, 1e-15);
  EXPECT_NEAR(distance(Point{} + tangent(c, 0.5), Point{0, -1}), 0.0, 1e-12);
}

TEST(Cubic, CurvatureOfAnArcIsOneOverItsRadius) {
  const double handle = 4.0 / 3.0 * std::tan(std::numbers::pi / 32.0);  // an eighth of a turn
  const double s = std::sin(std::numbers::pi / 8.0), k = std::cos(std::numbers::pi / 8.0);
  const Vec a{1, 0}, b{k, s};
  const Cubic arc{{Point{} + 5.0 * a, Point{} + 5.0 * (a + handle * perp(a)),
                   Point{} + 5.0 * (b - handle * perp(b)), Point{} + 5.0 * b}};
  EXPECT_NEAR(curvature(arc, 0.3), 0.2, 1e-4);
  EXPECT_NEAR(curvature(reversed(arc), 0.3), -0.2, 1e-4);
  EXPECT_EQ(curvature(straight({0, 0}, {8, 4}), 0.5), 0.0);
  EXPECT_EQ(curvature(Cubic{}, 0.5), 0.0);
}

// Length by sums of chords of 2^16 pieces, extrapolated once (Richardson).
double slow_length(const Cubic& c, double t0, double t1) {
  const auto chords = [&](int n) {
    double sum = 0.0;
    Point before = evaluate(c, t0);
    for (int i = 1; i <= n; ++i) {
      const Point now = evaluate(c, t0 + (t1 - t0) * i / n);
      sum += distance(before, now);
      before = now;
    }
    return sum;
  };
  const double coarse = chords(1 << 11), fine = chords(1 << 12);
  return fine + (fine - coarse) / 3.0;
}

RC_GTEST_PROP(Cubic, ArcLengthIsThatOfFineChords, ()) {
  const Cubic c = any_cubic();
  const double a = any_parameter(), b = any_parameter();
  const double length = arc_length(c, a, b);
  RC_ASSERT(std::fabs(length - slow_length(c, a, b)) <= 1e-6 * size_of(c));
  RC_ASSERT(arc_length(c) <= control_length(c) * (1.0 + 1e-14) + 1e-9);
  const double sum = arc_length(c, 0.0, a) + arc_length(c, a, 1.0);
  RC_ASSERT(std::fabs(sum - arc_length(c)) <= 3e-9 + 3e-14 * size_of(c));
}

RC_GTEST_PROP(Cubic, ParameterAtLengthUndoesArcLength, ()) {
  const Cubic c = any_cubic();
  const double whole = arc_length(c), wanted = any_parameter() * whole;
  const double t = parameter_at_length(c, wanted);
  RC_ASSERT(t >= 0.0 && t <= 1.0);
  RC_ASSERT(std::fabs(arc_length(c, 0.0, t) - wanted) <= 3e-9 + 3e-14 * size_of(c));
}

TEST(Cubic, LengthOfKnownCurves) {
  EXPECT_NEAR(arc_length(straight({0, 0}, {3, 4})), 5.0, 1e-12);
  EXPECT_EQ(arc_length(Cubic{}), 0.0);
  // The curve goes along x to 3/4 of the handle and back again.
  EXPECT_NEAR(arc_length(Cubic{{Point{0, 0}, {1, 0}, {1, 0}, {0, 0}}}, 1e-12), 1.5, 1e-12);
  // The parabola y = x^2 from 0 to 1, whose length has a closed form.
  const Cubic parabola{{Point{0, 0}, {1.0 / 3, 0}, {2.0 / 3, 1.0 / 3}, {1, 1}}};
  const double closed = std::sqrt(5.0) / 2 + std::asinh(2.0) / 4;
  EXPECT_NEAR(arc_length(parabola, 1e-13), closed, 1e-13);
  EXPECT_TRUE(std::isnan(arc_length(Cubic{{Point{kNan, 0}, {}, {}, {}}})));
}

TEST(Cubic, ParameterAtLengthIsClamped) {
  const Cubic c = straight({0, 0}, {10, 0});
  EXPECT_EQ(parameter_at_length(c, -1.0), 0.0);
  EXPECT_EQ(parameter_at_length(c, 10.5), 1.0);
  EXPECT_EQ(parameter_at_length(c, kNan), 1.0);
  EXPECT_NEAR(parameter_at_length(c, 2.5), 0.25, 1e-9);
  EXPECT_EQ(parameter_at_length(Cubic{}, 0.5), 1.0);
}

}  // namespace
}  // namespace felt::cubic_test
