#include "felt/geometry/affine.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace felt::affine_test {
namespace {

double any_number() {
  return *rc::gen::inRange(-1000, 1000) * 0.0625;
}

Affine any_map() {
  const double a = any_number(), b = any_number(), c = any_number(), d = any_number();
  return {a, b, c, d, any_number(), any_number()};
}

TEST(Affine, MovesTurnsAndScalesAboutACentre) {
  const Point centre{2, 3};
  EXPECT_EQ(apply(translation({1, -1}), centre), (Point{3, 2}));
  const Point turned = apply(rotation(std::numbers::pi / 2, centre), Point{3, 3});
  EXPECT_NEAR(distance(turned, Point{2, 4}), 0.0, 1e-15) << "from +x to +y";
  EXPECT_EQ(apply(scaling(2.0, centre), Point{3, 5}), (Point{4, 7}));
  EXPECT_EQ(apply(scaling(-1.0, 1.0, centre), Point{3, 5}), (Point{1, 5}));
  EXPECT_EQ(apply(translation({5, 5}), Vec{1, 2}), (Vec{1, 2})) << "vectors do not move";
}

RC_GTEST_PROP(Affine, ThenAppliesInOrder, ()) {
  const Affine first = any_map(), second = any_map();
  const Point p{any_number(), any_number()};
  const Point both = apply(then(first, second), p), steps = apply(second, apply(first, p));
  RC_ASSERT(distance(both, steps) <= 1e-7);
}

RC_GTEST_PROP(Affine, InverseUndoes, ()) {
  const Affine m = any_map();
  RC_PRE(std::fabs(determinant(m)) > 1e-3);
  const auto back = inverse(m);
  RC_ASSERT(back.has_value());
  const Point p{any_number(), any_number()};
  RC_ASSERT(distance(apply(*back, apply(m, p)), p) <= 1e-5);
}

RC_GTEST_PROP(Affine, MapsTheCurveByItsControlPoints, ()) {
  const Affine m = any_map();
  Cubic c;
  for (Point& p : c.p) p = {any_number(), any_number()};
  const double t = *rc::gen::inRange(0, 100) / 100.0;
  RC_ASSERT(distance(evaluate(apply(m, c), t), apply(m, evaluate(c, t))) <= 1e-9);
}

TEST(Affine, SingularAndBrokenMapsHaveNoInverse) {
  EXPECT_FALSE(inverse(scaling(0.0)));
  EXPECT_FALSE(inverse(scaling(1.0, 0.0)));
  EXPECT_FALSE(inverse(Affine{0.1, 0.3, 0.2, 0.6, 0, 0})) << "singular up to rounding";
  EXPECT_FALSE(inverse(Affine{std::numeric_limits<double>::quiet_NaN(), 0, 0, 1, 0, 0}));
  EXPECT_FALSE(inverse(Affine{1, 0, 0, 1, HUGE_VAL, 0}));
  EXPECT_TRUE(inverse(scaling(1e-6)));
}

}  // namespace
}  // namespace felt::affine_test
