#include "felt/haptics/force_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace felt::force_law_test {
namespace {

TEST(ForceLaw, R29_BetweenAFifthAndOneNewtonStrictlyIncreasingAndNeverSteep) {
  for (const ForceLaw& law : {kEditLaw, kTransformLaw}) {
    double last_d = 0.0;
    double last_level = 0.0;
    double last_force = 0.0;
    for (int i = 0; i < 10'000; ++i) {
      const double d = std::pow(10.0, -6.0 + 10.0 * i / 9999.0);
      const double level = law.level_n(d);
      const double force = law.force_n(d);
      ASSERT_GT(level, last_level) << d;
      ASSERT_GT(force, last_force) << d;
      ASSERT_LE(force - last_force, 0.3 * (d - last_d) * (1 + 1e-9) + 1e-15) << d;
      ASSERT_LT(force, 1.0);
      if (d >= 0.667) {
        ASSERT_GE(force, 0.2) << d;
      }
      last_d = d;
      last_level = level;
      last_force = force;
    }
    EXPECT_EQ(law.force_n(0.0), 0.0);
    EXPECT_EQ(law.force_n(-1.0), 0.0);
    EXPECT_EQ(law.force_n(std::numeric_limits<double>::quiet_NaN()), 0.0);
    EXPECT_DOUBLE_EQ(law.max_slope_n_per_m(), 300.0);
  }
}

TEST(ForceLaw, IsThatOfTheSpecification) {
  EXPECT_DOUBLE_EQ(kEditLaw.level_n(10.0), 0.6);  // l(D) = 0.2 + 0.8/2
  EXPECT_DOUBLE_EQ(kEditLaw.force_n(0.5), 0.15);  // the spring: 300 N/m
  EXPECT_DOUBLE_EQ(kTransformLaw.level_n(10.0), 0.36);
}

TEST(ForceLaw, ThePotentialIsTheIntegral) {
  for (const ForceLaw& law :
       {kEditLaw, kTransformLaw, ForceLaw{.spread_mm = 3.0, .cap_n_per_m = 150.0, .gain = 0.5}}) {
    double integral = 0.0;
    double last = 0.0;
    constexpr double kStep = 0.001;
    for (int i = 1; i <= 50'000; ++i) {
      integral += kStep * law.force_n((i - 0.5) * kStep);
      const double potential = law.potential_mj(i * kStep);
      ASSERT_GT(potential, last);
      if (i % 997 == 0) {
        ASSERT_NEAR(potential, integral, 1e-6) << i * kStep;
      }
      last = potential;
    }
  }
}

TEST(ForceLaw, TheFormOfThePaperIsEquation9WithoutARamp) {
  for (ForceLaw law : {kEditLaw, kTransformLaw}) {
    law.form = LawForm::kPaper;
    EXPECT_EQ(law.force_n(0.0), 0.0) << "without a direction";
    double last = 0.2;
    for (double d = 1e-6; d < 1e5; d *= 1.3) {
      const double force = law.force_n(d);
      EXPECT_DOUBLE_EQ(force, 0.2 + 0.8 * d / (d + law.spread_mm));
      EXPECT_GT(force, last);
      EXPECT_LT(force, 1.0);
      EXPECT_EQ(law.softened(0.3).force_n(d), force);
      last = force;
    }
    EXPECT_NEAR(law.potential_mj(7.0) - law.potential_mj(6.99), 0.01 * law.force_n(6.995), 1e-9);
  }
}

TEST(ForceLaw, AWeakerDeviceGetsTheSameShape) {
  ForceLaw law = kEditLaw;
  law.gain = 0.5;
  for (const double d : {0.1, 1.0, 10.0, 100.0}) {
    EXPECT_DOUBLE_EQ(law.force_n(d), 0.5 * kEditLaw.force_n(d));
  }
  EXPECT_DOUBLE_EQ(law.max_slope_n_per_m(), 150.0);
}

}  // namespace
}  // namespace felt::force_law_test
