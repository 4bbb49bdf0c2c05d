#include "felt/geometry/roots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace felt::roots_test {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<double> list(const UnitRoots& roots) {
  return {roots.begin(), roots.end()};
}

double any_root() {
  return *rc::gen::inRange(-1 << 20, 1 << 21) * 0x1p-20;
}

// Expects that every given root in [0, 1] is found, and that each root found is close to a given
// root.
void check_roots(const UnitRoots& found, const std::vector<double>& given, double margin) {
  for (const double g : given) {
    if (g < margin || g > 1.0 - margin) continue;
    RC_ASSERT(std::any_of(found.begin(), found.end(),
                          [&](double f) { return std::fabs(f - g) < margin; }));
  }
  for (const double f : found) {
    RC_ASSERT(f >= 0.0 && f <= 1.0);
    RC_ASSERT(std::any_of(given.begin(), given.end(),
                          [&](double g) { return std::fabs(f - g) < margin; }));
  }
}

RC_GTEST_PROP(Roots, QuadraticFindsTheRootsItIsMadeOf, ()) {
  const double a = any_root(), b = any_root(), k = std::ldexp(1.0, *rc::gen::inRange(-30, 30));
  check_roots(quadratic_roots(k * a * b, -k * (a + b), k), {a, b}, 1e-7);
}

RC_GTEST_PROP(Roots, CubicFindsTheRootsItIsMadeOf, ()) {
  const double a = any_root(), b = any_root(), c = any_root();
  const double k = std::ldexp(1.0, *rc::gen::inRange(-30, 30));
  // Roots closer than this merge in rounding; a triple root is only known to eps^(1/3).
  const double near = std::min({std::fabs(a - b), std::fabs(b - c), std::fabs(c - a)});
  RC_PRE(near > 1e-3);
  check_roots(cubic_roots(-k * a * b * c, k * (a * b + b * c + c * a), -k * (a + b + c), k),
              {a, b, c}, 1e-7);
}

TEST(Roots, AreAscending) {
  EXPECT_THAT(
      list(cubic_roots(-6.0 / 64, 11.0 / 16, -6.0 / 4, 1.0)),
      ElementsAre(DoubleNear(0.25, 1e-12), DoubleNear(0.5, 1e-12), DoubleNear(0.75, 1e-12)));
}

TEST(Roots, EndsBelong) {
  EXPECT_THAT(list(quadratic_roots(0.0, -1.0, 1.0)), ElementsAre(0.0, 1.0));
  EXPECT_THAT(list(cubic_roots(0.0, 1.0, 0.0, -1.0)), ElementsAre(0.0, 1.0));
  EXPECT_THAT(list(linear_roots(0.0, 3.0)), ElementsAre(0.0));
}

TEST(Roots, MultipleRootsAreReportedOnce) {
  EXPECT_THAT(list(quadratic_roots(0.25, -1.0, 1.0)), ElementsAre(0.5));
  EXPECT_THAT(list(cubic_roots(-0.125, 0.75, -1.5, 1.0)), ElementsAre(DoubleNear(0.5, 1e-5)));
  // (t - 1/2)^2 (t - 2)
  EXPECT_THAT(list(cubic_roots(-0.5, 2.25, -3.0, 1.0)), ElementsAre(DoubleNear(0.5, 1e-7)));
}

TEST(Roots, DegreeDropsWithTheLeadingCoefficients) {
  EXPECT_THAT(list(cubic_roots(-1.0, 2.0, 0.0, 0.0)), ElementsAre(0.5));
  EXPECT_THAT(list(quadratic_roots(1.0, 0.0, 0.0)), IsEmpty());
  EXPECT_THAT(list(cubic_roots(0.0, 0.0, 0.0, 0.0)), IsEmpty());
}

TEST(Roots, InputThatIsNotFiniteHasNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(list(linear_roots(nan, 1.0)), IsEmpty());
  EXPECT_THAT(list(quadratic_roots(nan, 1.0, 1.0)), IsEmpty());
  EXPECT_THAT(list(quadratic_roots(1.0, HUGE_VAL, 1.0)), IsEmpty());
  EXPECT_THAT(list(cubic_roots(1.0, 1.0, 1.0, nan)), IsEmpty());
}

TEST(Roots, HugeCoefficientsDoNotOverflow) {
  EXPECT_THAT(list(quadratic_roots(0.25e300, -1e300, 1e300)), ElementsAre(DoubleNear(0.5, 1e-7)));
}

}  // namespace
}  // namespace felt::roots_test
