#include "felt/driver/force_gate.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <deque>
#include <limits>
#include <random>

#include "felt/base/constants.h"
#include "felt/driver/device_models.h"
#include "felt/haptics/safety/safety_limits.h"

namespace felt::force_gate_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double any_double() {
  // Every bit pattern can occur: also denormals, NaN and infinities.
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

const DeviceModel& any_model() {
  const auto models = device_models();
  return models[*rc::gen::inRange<std::size_t>(0, models.size())];
}

// Repeats a request until the force has risen as far as allowed.
ForceGate::Passed pass_long(ForceGate& gate, const Force& asked, std::int64_t from_ns = 0) {
  ForceGate::Passed passed;
  // Long enough to rise to any model's force at 0.3 N/ms.
  for (int i = 0; i < 100; ++i) passed = gate.pass(asked, from_ns + i * kMs);
  return passed;
}

RC_GTEST_PROP(ForceGate, NothingEverComesOutLongerThanAllowed, ()) {
  const DeviceModel& model = any_model();
  const Capabilities& device = model.capabilities;
  ForceGate gate(device);
  RC_ASSERT(gate.max_n() > 0.0);
  RC_ASSERT(gate.max_n() <= 0.9 * device.max_force_n);
  RC_ASSERT(gate.max_n() <= device.advised_force_n);
  for (int i = 0; i < 20; ++i) {
    const Force asked{any_double(), any_double(), any_double()};
    const ForceGate::Passed passed = gate.pass(asked, *rc::gen::arbitrary<std::int64_t>());
    RC_ASSERT(is_finite(passed.force));
    RC_ASSERT(norm(passed.force) <= gate.max_n());
    RC_ASSERT(passed.was_finite == is_finite(asked));
  }
}

RC_GTEST_PROP(ForceGate, TheDirectionIsKept, ()) {
  ForceGate gate(any_model().capabilities);
  const auto part = [] { return 0.001 * *rc::gen::inRange(-100'000, 100'000); };
  const double scale = std::pow(10.0, *rc::gen::inRange(-3, 300));
  const Force asked{scale * part(), scale * part(), scale * part()};
  const Force sent = pass_long(gate, asked).force;
  // Relative to the largest component, because squares may overflow.
  const double largest = std::max({std::abs(asked.x), std::abs(asked.y), std::abs(asked.z)});
  RC_PRE(largest > 0.0);
  const Force wanted{asked.x / largest, asked.y / largest, asked.z / largest};
  const double share = norm(sent) / norm(wanted);
  RC_ASSERT(norm(sent - share * wanted) <= 1e-12 * norm(sent));
}

RC_GTEST_PROP(ForceGate, WhatIsAllowedPassesToTheBit, ()) {
  ForceGate gate(any_model().capabilities);
  const auto part = [&] { return 1e-6 * gate.max_n() * *rc::gen::inRange(-577'000, 577'000); };
  const Force asked{part(), part(), part()};
  const ForceGate::Passed passed = pass_long(gate, asked);
  RC_ASSERT(passed.force == asked);
  RC_ASSERT(passed.was_finite && !passed.was_cut);
}

TEST(ForceGate, NotANumberIsNoForceAndSaysSo) {
  ForceGate gate(find_device_model("omega.3")->capabilities);
  for (double bad : {kNan, kInfinity, -kInfinity}) {
    for (const Force& asked : {Force{bad, 0, 0}, Force{0, bad, 1}, Force{1, 1, bad}}) {
      const ForceGate::Passed passed = gate.pass(asked, 0);
      EXPECT_FALSE(passed.was_finite);
      EXPECT_EQ(passed.force, Force{});
    }
  }
  EXPECT_TRUE(gate.pass({0.1, 0, 0}, 0).was_finite) << "and forgets it";
}

TEST(ForceGate, TheLargestFiniteForceIsCut) {
  ForceGate gate(find_device_model("touch")->capabilities);
  const double huge = std::numeric_limits<double>::max();
  const ForceGate::Passed passed = pass_long(gate, {huge, -huge, huge});
  EXPECT_TRUE(passed.was_cut);
  EXPECT_NEAR(norm(passed.force), 2.5, 1e-9);
  EXPECT_NEAR(passed.force.x, -passed.force.y, 1e-12);
  EXPECT_GT(passed.force.x, 1.0);
}

TEST(ForceGate, ADeviceThatSaysNonsenseGetsNoForce) {
  for (double bad : {kNan, kInfinity, -1.0, 0.0}) {
    ForceGate gate({.max_force_n = bad, .continuous_force_n = 1.0});
    EXPECT_EQ(gate.pass({1, 2, 3}, 0).force, Force{}) << bad;
  }
  for (double bad : {kNan, kInfinity, -1.0}) {
    ForceGate gate({.max_force_n = 5.0, .advised_force_n = bad});
    EXPECT_EQ(gate.pass({1, 2, 3}, 0).force, Force{}) << bad;
  }
  ForceGate none({.actuated_axes = 0, .max_force_n = 5.0});
  EXPECT_EQ(none.pass({1, 2, 3}, 0).force, Force{});
}

TEST(ForceGate, WithoutAdviceNineTenthsOfTheNominalForce) {
  EXPECT_DOUBLE_EQ(ForceGate({.max_force_n = 5.0}).max_n(), 4.5);
}

TEST(ForceGate, RmsOverAnyTenSecondsIsWithinTheRating) {
  for (const DeviceModel& model : device_models()) {
    for (double on_s : {0.5, 3.0, 1e9}) {
      for (std::int64_t tick_ns : {kMs / 4, kMs, 4 * kMs}) {
        ForceGate gate(model.capabilities);
        const auto window_ticks = static_cast<std::size_t>(10'000 * kMs / tick_ns);
        std::deque<double> window;
        double sum = 0.0;
        double worst = 0.0;
        for (std::int64_t t = 0; t < 25'000 * kMs; t += tick_ns) {
          const bool is_on = std::fmod(1e-9 * static_cast<double>(t), on_s + 1.0) < on_s;
          const double sent = norm(gate.pass({is_on ? 1e6 : 0.0, 0, 0}, t).force);
          window.push_back(sent * sent);
          sum += window.back();
          if (window.size() > window_ticks) {
            sum -= window.front();
            window.pop_front();
          }
          worst = std::max(worst, sum / static_cast<double>(window_ticks));
        }
        EXPECT_LE(std::sqrt(worst), model.capabilities.continuous_force_n * (1.0 + 1e-9))
            << model.id << ", " << on_s << " s on, tick " << tick_ns;
      }
    }
  }
}

TEST(ForceGate, NeverBindsBeforeTheChainsMotorGuard) {
  const unsigned seed = 20260731;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const DeviceModel& model : device_models()) {
    const SafetyLimits limits = limits_for(model.capabilities);
    MotorGuard chain(limits);
    ForceGate gate(model.capabilities);
    ASSERT_GE(gate.max_n(), limits.peak_force_n) << model.id;
    double wish = 0.0, last = 0.0, step_ms = 0.0;
    std::int64_t now_ns = 0;
    for (int i = 0; i < 120'000; ++i) {
      if (i % 500 == 0) wish = share(random) < 0.7 ? 5.0 : 5.0 * share(random);
      const double allowed = std::min(
          {wish, limits.peak_force_n, chain.allowed_n(), last + limits.rise_n_per_ms * step_ms});
      last = allowed;
      const ForceGate::Passed passed = gate.pass({0, allowed, 0}, now_ns);
      ASSERT_FALSE(passed.was_cut) << model.id << " at tick " << i;
      const std::int64_t step_ns = kMs / 4 + static_cast<std::int64_t>(share(random) * 1e6);
      chain.heat(allowed, 1e-9 * static_cast<double>(step_ns));
      step_ms = 1e-6 * static_cast<double>(std::min(step_ns, 2 * model.capabilities.period_ns));
      now_ns += step_ns;
    }
  }
}

TEST(ForceGate, WhatWasLetGoHeatsNoMotor) {
  Capabilities device = find_device_model("touch")->capabilities;
  ForceGate held(device);
  ForceGate release(device);
  pass_long(held, {2.5, 0, 0});
  pass_long(release, {2.5, 0, 0});
  release.release();
  EXPECT_LT(norm(pass_long(held, {2.5, 0, 0}, 60'000 * kMs).force), 0.901);
  EXPECT_NEAR(norm(pass_long(release, {2.5, 0, 0}, 60'000 * kMs).force), 2.5, 1e-9);
}

// docs/safety.md, "rise". It holds for any requested force and any rate of calls.
TEST(ForceGate, TheForceRisesByThreeTenthsOfANewtonAMillisecond) {
  for (const std::int64_t tick_ns : {kMs / 5, kMs, 2 * kMs, 7 * kMs, 500 * kMs}) {
    ForceGate gate(find_device_model("inverse3")->capabilities);
    double last = norm(gate.pass({}, 0).force);
    const double step_n = 0.3 * std::min(1e-6 * static_cast<double>(tick_ns), 2.0);
    for (std::int64_t t = tick_ns; t < 30 * tick_ns; t += tick_ns) {
      const double sent = norm(gate.pass({0, 0, 3}, t).force);
      EXPECT_LE(sent, last + step_n + 1e-8) << tick_ns;
      if (tick_ns < 10 * kMs) {  // before the motors are warm
        EXPECT_GE(sent, std::min(3.0, last + step_n) - 1e-8) << tick_ns;
      }
      last = sent;
    }
  }
}

TEST(ForceGate, FallingIsFreeTurningIsNot) {
  ForceGate gate(find_device_model("inverse3")->capabilities);
  pass_long(gate, {0, 0, 2});
  EXPECT_EQ(gate.pass({0, 0, 0.5}, 100 * kMs).force, (Force{0, 0, 0.5}));
  pass_long(gate, {0, 0, 2}, 101 * kMs);
  EXPECT_NEAR(gate.pass({0, 0, -2}, 201 * kMs).force.z, -0.3, 1e-8) << "a reversal begins at zero";
  gate.release();
  EXPECT_EQ(gate.held(), Force{});
  EXPECT_NEAR(gate.pass({0, 2, 0}, 202 * kMs).force.y, 0.3, 1e-8);
}

TEST(ForceGate, AClockThatStandsStillOrRunsBackwardsAddsNoForceAndTheNextTickDoes) {
  ForceGate gate(find_device_model("inverse3")->capabilities);
  const double first = norm(gate.pass({0, 0, 3}, 3'600'000 * kMs).force);
  for (int i = 0; i < 100; ++i) gate.pass({0, 0, 3}, 3'600'000 * kMs);
  EXPECT_NEAR(norm(gate.held()), first, 1e-6);
  EXPECT_NEAR(norm(gate.pass({0, 0, 3}, 0).force), first, 1e-6) << "set back by an hour";
  EXPECT_NEAR(norm(gate.pass({0, 0, 3}, kMs).force), first + 0.3, 1e-6);
}

}  // namespace
}  // namespace felt::force_gate_test
