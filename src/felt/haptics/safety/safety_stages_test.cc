#include "felt/haptics/safety/safety_stages.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "felt/base/constants.h"

namespace felt::safety_stages_test {
namespace {

double number(double largest) {
  return largest * (*rc::gen::inRange(-1'000'000, 1'000'001)) * 1e-6;
}
Force any_force(double largest) {
  return {number(largest), number(largest), number(largest)};
}

RC_GTEST_PROP(ClampLength, R49_NeverLongerAndTheSameDirection, ()) {
  const Force f = std::pow(10.0, *rc::gen::inRange(-300, 300)) * any_force(1.0);
  const double limit = 3.0 * (*rc::gen::inRange(0, 1000)) * 1e-3;
  const Force c = clamp_length(f, limit);
  RC_ASSERT(is_finite(c));
  RC_ASSERT(norm(c) <= limit * (1.0 + 1e-12));
  const double largest = std::max({std::abs(f.x), std::abs(f.y), std::abs(f.z)});
  if (largest > 0.0) RC_ASSERT(dot(c, (1.0 / largest) * f) >= 0.0);
  if (limit > 0.0 && largest < 1e100 && norm(f) <= limit) RC_ASSERT(c == f);
}

TEST(ClampLength, TakesWhatDoublesCanHold) {
  constexpr double kMax = std::numeric_limits<double>::max();
  EXPECT_NEAR(norm(clamp_length({kMax, -kMax, kMax}, 3.0)), 3.0, 1e-12);
  const Force tiny{5e-324, 0, 0};
  EXPECT_EQ(clamp_length(tiny, 3.0), tiny);
  EXPECT_EQ(clamp_length({1, 1, 1}, 0.0), Force{});
  EXPECT_EQ(clamp_length({1, 1, 1}, -1.0), Force{});
}

RC_GTEST_PROP(LimitRise, FallingIsFreeAndGrowingTurningReversingAreNot, ()) {
  const Force previous = any_force(3.0);
  const Force wanted = any_force(3.0);
  const double step = 0.3 * (*rc::gen::inRange(0, 1000)) * 1e-3;
  const Force next = limit_rise(previous, wanted, step);
  RC_ASSERT(norm(next) <= std::max(norm(previous), norm(wanted)) * (1.0 + 1e-12));
  // The distance to the segment from 0 to `previous`, found by search.
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 3000; ++i) nearest = std::min(nearest, norm(next - (i / 3000.0) * previous));
  RC_ASSERT(nearest <= step + 0.002);
  RC_ASSERT(norm(wanted - next) <= norm(wanted - previous) * (1.0 + 1e-12));
}

TEST(LimitRise, Examples) {
  EXPECT_EQ(limit_rise({0, 0, 3}, {0, 0, 0.5}, 0.3), (Force{0, 0, 0.5}));  // falls immediately
  EXPECT_EQ(limit_rise({0, 0, 0}, {0, 0, 3}, 0.3), (Force{0, 0, 0.3}));    // grows by 0.3
  EXPECT_EQ(limit_rise({0, 0, 3}, {0, 0, -3}, 0.3), (Force{0, 0, -0.3}));  // reverses to 0.3 N
  EXPECT_EQ(limit_rise({2, 0, 0}, {0, 2, 0}, 0.3), (Force{0, 0.3, 0}));    // turns via 0
  EXPECT_EQ(limit_rise({0, 0, 1}, {0, 0, 2}, 0.0), (Force{0, 0, 1}));      // time stands still
}

TEST(Brake, GrowsFrom600MillimetresPerSecond) {
  const SafetyLimits limits;
  EXPECT_EQ(brake_damping(limits, 0.0), 0.0);
  EXPECT_EQ(brake_damping(limits, 0.6), 0.0);
  EXPECT_NEAR(brake_damping(limits, 0.8), 1.0, 1e-12);
  EXPECT_EQ(brake_damping(limits, 1.0), 2.0);
  EXPECT_EQ(brake_damping(limits, 1e300), 2.0);
  SafetyLimits weak;
  weak.max_damping_n_s_per_m = 0.5;
  EXPECT_EQ(brake_damping(weak, 1.0), 0.5);
  const Force f = damping_force(2.0, {1000.0, 0, 0}, 3.0);
  EXPECT_EQ(f, (Force{-2.0, 0, 0}));  // N s/m times mm/s is mN
  EXPECT_NEAR(norm(damping_force(2.0, {1e300, -1e300, 1e300}, 3.0)), 3.0, 1e-12);
}

TEST(Budget, R56_900UpTo2Milliseconds600At3AndInProportionBeyond) {
  const auto budget = [](int delay_ticks, std::int64_t period_ns) {
    SafetyLimits limits;
    limits.delay_ticks = delay_ticks;
    limits.period_ns = period_ns;
    return stiffness_budget_n_per_m(limits);
  };
  EXPECT_EQ(budget(0, 1'000'000), 900.0);
  EXPECT_DOUBLE_EQ(budget(1, 1'000'000), 900.0);
  EXPECT_DOUBLE_EQ(budget(2, 1'000'000), 600.0);
  EXPECT_DOUBLE_EQ(budget(5, 1'000'000), 300.0);
  EXPECT_DOUBLE_EQ(budget(0, 4'000'000), 450.0);
  EXPECT_EQ(budget(2, 200'000), 900.0);  // docs/design/forces.md: 5 kHz is clean up to two ticks
}

RC_GTEST_PROP(Budget, R56_TheSumOfSlopesKeepsToIt, ()) {
  SafetyLimits limits;
  limits.delay_ticks = *rc::gen::inRange(0, 10);
  limits.max_stiffness_n_per_m = *rc::gen::inRange(0, 2000);
  const Slopes slopes{std::abs(number(3000)), std::abs(number(3000)), std::abs(number(3000))};
  const StiffnessScale s = share_budget(limits, slopes);
  const double budget = stiffness_budget_n_per_m(limits) * (1.0 + 1e-12);
  RC_ASSERT(s.lateral * slopes.lateral_n_per_m + s.friction * slopes.friction_n_per_m <= budget);
  RC_ASSERT(s.normal * slopes.normal_n_per_m <= budget);
  for (double share : {s.normal, s.lateral, s.friction}) RC_ASSERT(share >= 0.0 && share <= 1.0);
  if (s.lateral < 1.0) RC_ASSERT(s.friction * slopes.friction_n_per_m <= 1e-9);
}

TEST(Budget, R55_ThePlaneStaysUnderNineTenthsOfTheDevicesStiffness) {
  const SafetyLimits touch = limits_for({.max_force_n = 3.3, .max_stiffness_n_per_m = 400.0});
  EXPECT_DOUBLE_EQ(share_budget(touch, {800.0, 0, 0}).normal * 800.0, 360.0);
  EXPECT_EQ(share_budget(touch, {300.0, 0, 0}).normal, 1.0);
}

TEST(Budget, SlopesThatAreNoNumbersGetNoShare) {
  for (double odd : {kNan, -1.0, kInf}) {
    const StiffnessScale s = share_budget({}, {odd, odd, odd});
    EXPECT_EQ(s, (StiffnessScale{0.0, 0.0, 0.0})) << odd;
  }
}

}  // namespace
}  // namespace felt::safety_stages_test
