#include "felt/devices/evdev/effect_plan.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace felt::effect_plan_test {
namespace {

StickForces stick(std::initializer_list<std::uint16_t> effects) {
  StickForces forces;
  for (const std::uint16_t effect : effects) forces.effects[effect] = true;
  return forces;
}

/// Returns the force in N of a device that renders the spring effect of `plan`, along `axis` at
/// position `x_mm`.
double spring_n(const EffectPlan& plan, std::size_t axis, double x_mm, const StickForces& stick) {
  if (!plan.plays[EffectPlan::kSpring]) return 0.0;
  const EvdevCondition& c = plan.effects[EffectPlan::kSpring].conditions[axis];
  const double off = c.center / 32767.0 - x_mm / stick.half_way_mm;
  const double largest = c.right_saturation / 65535.0;
  return stick.full_force_n * std::clamp(c.right_coefficient / 32767.0 * off, -largest, largest);
}

const StickForces kAll =
    stick({evdev::kFfSpring, evdev::kFfFriction, evdev::kFfDamper, evdev::kFfConstant});

TEST(EffectPlan, ASpringIsASpring) {
  const AxisFit x{.position_mm = 10.0, .force_n = 0.5, .stiffness_n_per_mm = 0.1};
  const EffectPlan plan = plan_effects(std::array{x, AxisFit{}}, kAll, 1.5);
  EXPECT_EQ(plan.plays.to_string(), "001");
  EXPECT_EQ(plan.effects[EffectPlan::kSpring].length_ms, kEffectMs);
  EXPECT_NEAR(spring_n(plan, 0, 10.0, kAll), 0.5, 0.005);
  EXPECT_NEAR(spring_n(plan, 0, 11.0, kAll), 0.4, 0.005);
  EXPECT_NEAR(spring_n(plan, 0, 15.0, kAll), 0.0, 0.005);
  EXPECT_NEAR(spring_n(plan, 0, -40.0, kAll), 0.55, 0.005) << "saturated";
  EXPECT_EQ(spring_n(plan, 1, 20.0, kAll), 0.0);
}

TEST(EffectPlan, AForceThatStaysIsASaturatedSpringToTheEnd) {
  for (const double force : {0.7, -0.7}) {
    const AxisFit y{.position_mm = -20.0, .force_n = force};
    const EffectPlan plan = plan_effects(std::array{AxisFit{}, y}, kAll, 1.5);
    EXPECT_EQ(plan.plays.to_string(), "001");
    for (const double at : {-30.0, -20.0, 0.0, 30.0}) {
      EXPECT_NEAR(spring_n(plan, 1, at, kAll), force, 0.005);
    }
  }
}

TEST(EffectPlan, FrictionBrakesByWhatTheDeviceHas) {
  const AxisFit x{.friction_n = 0.4};
  const EffectPlan plan = plan_effects(std::array{x, AxisFit{}}, kAll, 1.5);
  EXPECT_EQ(plan.plays.to_string(), "010");
  EXPECT_EQ(plan.effects[EffectPlan::kFriction].type, evdev::kFfFriction);
  EXPECT_NEAR(plan.effects[EffectPlan::kFriction].conditions[0].right_coefficient, 0.04 * 32767, 2);
  const StickForces damped = stick({evdev::kFfSpring, evdev::kFfDamper});
  const EffectPlan damper = plan_effects(std::array{x, AxisFit{}}, damped, 1.5);
  EXPECT_EQ(damper.effects[EffectPlan::kFriction].type, evdev::kFfDamper);
  EXPECT_NEAR(damper.effects[EffectPlan::kFriction].conditions[0].left_saturation, 0.04 * 65535, 2);
  EXPECT_EQ(damper.effects[EffectPlan::kFriction].conditions[1].right_coefficient, 0);
}

TEST(EffectPlan, WithoutSpringsItPushesConstantly) {
  const StickForces wheel = stick({evdev::kFfConstant});
  const auto direction = [&](double x, double y) {
    const EffectPlan plan =
        plan_effects(std::array{AxisFit{.force_n = x}, AxisFit{.force_n = y}}, wheel, 1.5);
    EXPECT_EQ(plan.plays.to_string(), "100");
    EXPECT_NEAR(plan.effects[EffectPlan::kConstant].level, std::hypot(x, y) / 10.0 * 32767, 1);
    return plan.effects[EffectPlan::kConstant].direction;
  };
  // The kernel's documentation: 0 down, 0x4000 left, 0x8000 up, 0xC000 right.
  EXPECT_EQ(direction(0.0, 1.0), 0x0000);
  EXPECT_EQ(direction(-1.0, 0.0), 0x4000);
  EXPECT_EQ(direction(0.0, -1.0), 0x8000);
  EXPECT_EQ(direction(1.0, 0.0), 0xC000);
}

TEST(EffectPlan, AWheelHasOneAxis) {
  StickForces wheel = kAll;
  wheel.has_y = false;
  const AxisFit fit{.force_n = 0.5, .friction_n = 0.2};
  const EffectPlan plan = plan_effects(std::array{fit, fit}, wheel, 1.5);
  for (const std::size_t kind : {std::size_t{0}, std::size_t{1}}) {
    EXPECT_EQ(plan.effects[kind].conditions[1], EvdevCondition{}) << kind;
  }
}

TEST(EffectPlan, NoForceIsNoEffect) {
  EXPECT_TRUE(plan_effects(std::array{AxisFit{}, AxisFit{}}, kAll, 1.5).plays.none());
  const AxisFit some{.force_n = 1.0};
  EXPECT_TRUE(plan_effects(std::array{some, some}, kAll, 0.0).plays.none());
  const AxisFit nan{.force_n = std::nan("")};
  EXPECT_TRUE(plan_effects(std::array{nan, some}, kAll, 1.5).plays.none());
}

/// The force stays within the limit at any position of the grip and for any fit.
RC_GTEST_PROP(EffectPlan, NeverAsksForMoreThanTheBound, ()) {
  StickForces forces = *rc::gen::element(
      kAll, stick({evdev::kFfSpring}), stick({evdev::kFfConstant}),
      stick({evdev::kFfConstant, evdev::kFfDamper}), stick({evdev::kFfSpring, evdev::kFfFriction}));
  forces.full_force_n = *rc::gen::element(0.5, 3.0, 10.0, 60.0);
  const auto some_fit = [] {
    return AxisFit{.position_mm = 0.1 * *rc::gen::inRange(-600, 600),
                   .force_n = 0.01 * *rc::gen::inRange(-1000, 1000),
                   .stiffness_n_per_mm = 0.001 * *rc::gen::inRange(0, 2000),
                   .friction_n = 0.01 * *rc::gen::inRange(0, 500)};
  };
  const double max_n = 0.01 * *rc::gen::inRange(0, 300);
  const EffectPlan plan = plan_effects(std::array{some_fit(), some_fit()}, forces, max_n);
  RC_ASSERT(strongest_n(plan, plan, forces) <= max_n * (1.0 + 1e-9));
  const double x = spring_n(plan, 0, 0.1 * *rc::gen::inRange(-450, 450), forces);
  const double y = spring_n(plan, 1, 0.1 * *rc::gen::inRange(-450, 450), forces);
  RC_ASSERT(std::hypot(x, y) <= max_n * (1.0 + 1e-9));
}

}  // namespace
}  // namespace felt::effect_plan_test
