#include "felt/haptics/safety/safety_limits.h"

#include <gtest/gtest.h>

#include <limits>

#include "felt/base/constants.h"

namespace felt::safety_limits_test {
namespace {

TEST(SafetyLimits, R14_R49_ADeviceWithinTheUsersLimitHasTheSameLimits) {
  const Capabilities touch{.max_force_n = 3.3, .continuous_force_n = 0.88};
  const Capabilities advised{.max_force_n = 22.0, .advised_force_n = 2.0};
  for (const Capabilities& device : {touch, advised}) {
    for (const double limit_n : {0.1, 0.3, 1.0, 1.999, 2.5, 3.0, 9.0}) {
      EXPECT_EQ(limits_for(with_force_limit(device, limit_n)).peak_force_n,
                limits_for(device, limit_n).peak_force_n)
          << limit_n;
    }
    for (const double limit_n : {3.0, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
      EXPECT_EQ(with_force_limit(device, limit_n), device) << "as it is said to sessions";
    }
  }
  EXPECT_EQ(with_force_limit({}, 0.5), Capabilities{}) << "a mouse";
}

TEST(SafetyLimits, R49_ThePeakIsTheSmallestOfUserAdviceAndNineTenthsOfTheDevice) {
  EXPECT_DOUBLE_EQ(limits_for({.max_force_n = 22.0}).peak_force_n, 3.0);
  EXPECT_DOUBLE_EQ(limits_for({.max_force_n = 22.0}, 1.2).peak_force_n, 1.2);
  EXPECT_DOUBLE_EQ(limits_for({.max_force_n = 22.0}, 9.0).peak_force_n, 3.0);
  EXPECT_DOUBLE_EQ(limits_for({.max_force_n = 3.3}).peak_force_n, 0.9 * 3.3);
  EXPECT_DOUBLE_EQ(limits_for({.max_force_n = 3.3, .advised_force_n = 2.5}).peak_force_n, 2.5);
}

TEST(SafetyLimits, R55_ReadsTheDevicesCaps) {
  const SafetyLimits limits = limits_for({.max_force_n = 3.3,
                                          .continuous_force_n = 0.88,
                                          .max_stiffness_n_per_m = 400.0,
                                          .max_damping_n_s_per_m = 4.0,
                                          .period_ns = 500'000,
                                          .delay_ticks = 2});
  EXPECT_DOUBLE_EQ(limits.continuous_force_n, 0.8 * 0.88);
  EXPECT_DOUBLE_EQ(limits.max_stiffness_n_per_m, 0.9 * 400.0);
  EXPECT_DOUBLE_EQ(limits.max_damping_n_s_per_m, 2.0);
  EXPECT_EQ(limits.period_ns, 500'000);
  EXPECT_EQ(limits.delay_ticks, 2);
  EXPECT_EQ(limits_for({}).peak_force_n, 0.0) << "a mouse gets no force";
}

TEST(SafetyLimits, NonsenseFromADeviceMeansNoForce) {
  for (double odd : {kNan, -1.0, kInf}) {
    const SafetyLimits limits = limits_for({.max_force_n = odd});
    EXPECT_TRUE(is_sound(limits));
    EXPECT_EQ(limits.peak_force_n, 0.0) << odd;
    EXPECT_EQ(limits_for({.max_force_n = 5.0, .advised_force_n = odd}).peak_force_n, 0.0) << odd;
    EXPECT_EQ(limits_for({.max_force_n = 5.0}, odd).peak_force_n, 0.0) << odd;
  }
  EXPECT_TRUE(is_sound(limits_for({.max_force_n = 5.0,
                                   .continuous_force_n = kNan,
                                   .max_stiffness_n_per_m = kInf,
                                   .max_damping_n_s_per_m = kNan,
                                   .period_ns = -5,
                                   .delay_ticks = -7})));
}

// The defaults are upper bounds. No number may be greater or missing.
TEST(SafetyLimits, TheSelfTestFindsEveryNumberThatIsNoneOrTooBold) {
  EXPECT_TRUE(is_sound(SafetyLimits{}));
  double SafetyLimits::*const numbers[] = {&SafetyLimits::peak_force_n,
                                           &SafetyLimits::continuous_force_n,
                                           &SafetyLimits::rms_window_s,
                                           &SafetyLimits::rms_fade_s,
                                           &SafetyLimits::max_damping_n_s_per_m,
                                           &SafetyLimits::max_stiffness_n_per_m,
                                           &SafetyLimits::rise_n_per_ms,
                                           &SafetyLimits::engage_rise_n_per_ms,
                                           &SafetyLimits::soft_fall_n_per_ms,
                                           &SafetyLimits::engage_below_n,
                                           &SafetyLimits::engage_s,
                                           &SafetyLimits::brake_from_m_per_s,
                                           &SafetyLimits::brake_n_s_per_m,
                                           &SafetyLimits::cut_m_per_s,
                                           &SafetyLimits::cut_now_m_per_s,
                                           &SafetyLimits::jump_mm_per_ms,
                                           &SafetyLimits::jump_hold_s,
                                           &SafetyLimits::silent_damp_s,
                                           &SafetyLimits::silent_stop_s,
                                           &SafetyLimits::silent_damping_n_s_per_m,
                                           &SafetyLimits::late_s,
                                           &SafetyLimits::very_late_s,
                                           &SafetyLimits::soft_fault_window_s,
                                           &SafetyLimits::budget_fast_n_per_m,
                                           &SafetyLimits::budget_slow_n_per_m};
  for (double SafetyLimits::*const number : numbers) {
    for (double odd : {kNan, kInf, -kInf, -1.0, 1e9}) {
      SafetyLimits limits;
      limits.*number = odd;
      EXPECT_FALSE(is_sound(limits)) << odd;
    }
  }
  for (int odd : {-1, 0, 4}) {
    SafetyLimits limits;
    limits.soft_faults = odd;
    EXPECT_FALSE(is_sound(limits)) << odd;
  }
}

TEST(SafetyLimits, WithAScaleNoBoundIsHigherAtTheHand) {
  Capabilities device;
  device.max_force_n = 3.3;
  const SafetyLimits plain = limits_for(device);
  for (double s : {0.5, 0.75, 1.0, 1.3, 2.0}) {
    SCOPED_TRACE(s);
    device.page_scale = s;
    const SafetyLimits l = limits_for(device);
    EXPECT_TRUE(is_sound(l));
    EXPECT_EQ(l.peak_force_n, plain.peak_force_n);
    // At the hand, stiffness and damping are multiplied by s and speeds divided by s.
    const double e = 1.0 + 1e-12;
    EXPECT_LE(l.budget_fast_n_per_m * s, plain.budget_fast_n_per_m * e);
    EXPECT_LE(l.budget_slow_n_per_m * s, plain.budget_slow_n_per_m * e);
    EXPECT_LE(l.brake_n_s_per_m * s, plain.brake_n_s_per_m * e);
    EXPECT_LE(l.silent_damping_n_s_per_m * s, plain.silent_damping_n_s_per_m * e);
    EXPECT_LE(l.brake_from_m_per_s / s, plain.brake_from_m_per_s * e);
    EXPECT_LE(l.cut_m_per_s / s, plain.cut_m_per_s * e);
    EXPECT_LE(l.cut_now_m_per_s / s, plain.cut_now_m_per_s * e);
    EXPECT_LE(l.jump_mm_per_ms / s, plain.jump_mm_per_ms * e);
  }
  for (double odd : {kNan, kInf, -1.0, 0.0, 0.4, 2.1}) {
    device.page_scale = odd;
    EXPECT_EQ(limits_for(device).peak_force_n, 0.0) << odd;
  }
}

}  // namespace
}  // namespace felt::safety_limits_test
