#include "felt/rt/servo.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/rt/testing/scripted_device.h"
#include "felt/rt/virtual_clock.h"

namespace felt::servo_test {
namespace {

struct Constant {
  Force force;
  Slopes claimed;
  Force operator()(const PenSample&, ForceMemory& memory) const noexcept {
    memory.terms.add("constant", force);
    return force;
  }
  [[nodiscard]] Slopes slopes() const noexcept { return claimed; }
};

// A brick whose force is the content of its bristle. It shows which memory a model uses.
struct Remembering {
  double adds = 0.0;
  Force operator()(const PenSample&, ForceMemory& memory) const noexcept {
    memory.bristle.x += adds;
    return {memory.bristle.x, 0.0, 0.0};
  }
  [[nodiscard]] static Slopes slopes() noexcept { return {}; }
};

// A brick that outputs the values that the loop passes to it as a force.
struct Telling {
  Force operator()(const PenSample&, ForceMemory& memory) const noexcept {
    return {memory.dt_s, memory.period_s, memory.material_cap_n_per_m};
  }
  [[nodiscard]] static Slopes slopes() noexcept { return {}; }
};
struct TellingScale {
  Slopes claimed;
  Force operator()(const PenSample&, ForceMemory& memory) const noexcept {
    return {memory.scale.friction, memory.scale.lateral, memory.scale.normal};
  }
  [[nodiscard]] Slopes slopes() const noexcept { return claimed; }
};

/// A brick that outputs the time of its sample as a force, s.
struct TellingTime {
  Force operator()(const PenSample& sample, ForceMemory&) const noexcept {
    return {1e-9 * static_cast<double>(sample.time_ns), 0.0, 0.0};
  }
  [[nodiscard]] static Slopes slopes() noexcept { return {}; }
};

template <class F>
ForceModel model_of(const F& functor, std::uint32_t fade_id = 0) {
  ForceModel model(functor);
  model.set_fade_id(fade_id);
  return model;
}

struct Loop {
  explicit Loop(ServoOptions options = {}) : servo(std::make_unique<Servo>(device, options)) {}

  const TickReport& run(int ticks) {
    for (int i = 1; i < ticks; ++i) clock.tick();
    return clock.tick();
  }
  // Arms and waits until the ramp is over.
  void engage() {
    servo->arm();
    run(700);
    ASSERT_EQ(servo->latest().safety.state, SafetyState::kActive);
  }

  ScriptedDevice device;
  std::unique_ptr<Servo> servo;
  VirtualClock clock{*servo};
};

TEST(Servo, R49_NoForceUntilTheUserAllowsIt) {
  Loop loop;
  loop.servo->publish(model_of(Constant{{0.1, 0.0, 0.0}, {}}));
  for (int i = 0; i < 100; ++i) {
    const TickReport& report = loop.run(1);
    EXPECT_EQ(report.asked, (Force{0.1, 0.0, 0.0}));
    EXPECT_EQ(report.sent, Force{});
    EXPECT_EQ(loop.device.force, Force{});
  }
  loop.engage();
  EXPECT_EQ(loop.device.force, (Force{0.1, 0.0, 0.0}));
}

TEST(Servo, R49_WhateverIsAskedIsLimitedBeforeTheDevice) {
  Loop loop;
  loop.engage();
  loop.servo->publish(model_of(Constant{{60.0, -80.0, 0.0}, {}}));
  double last = 0.0;
  for (int i = 0; i < 200; ++i) {
    const TickReport& report = loop.run(1);
    EXPECT_EQ(loop.device.force, report.sent);
    EXPECT_LE(norm(report.sent), 3.0 + 1e-9);
    EXPECT_LE(norm(report.sent), last + 0.3 + 1e-9);
    last = norm(report.sent);
  }
  EXPECT_GT(last, 2.0);
}

TEST(Servo, R49_ADeviceThatCannotBeReadGetsZeroInThisTickAndIsLatched) {
  Loop loop;
  loop.servo->publish(model_of(Constant{{0.15, 0.0, 0.0}, {}}));
  loop.engage();
  ASSERT_NE(loop.device.force, Force{});
  const PenSample last_good = loop.servo->latest().sample;
  loop.device.read_fault = DeviceFault::kDisconnected;
  const TickReport& report = loop.run(1);
  EXPECT_EQ(loop.device.force, Force{});
  EXPECT_EQ(report.sent, Force{});
  EXPECT_FALSE(report.sample_ok);
  EXPECT_EQ(report.sample, last_good);
  EXPECT_EQ(report.safety.state, SafetyState::kLatched);
  EXPECT_EQ(report.safety.fault, SafetyFault::kDeviceError);
  loop.device.read_fault.reset();
  EXPECT_EQ(norm(loop.run(2000).sent), 0.0);
  loop.engage();
  EXPECT_GT(norm(loop.device.force), 0.1);
}

TEST(Servo, R49_ADeviceThatCannotBeWrittenIsStopped) {
  Loop loop;
  loop.servo->publish(model_of(Constant{{0.15, 0.0, 0.0}, {}}));
  loop.engage();
  loop.device.write_fault = DeviceFault::kForcesOff;
  const TickReport& report = loop.run(1);
  EXPECT_EQ(report.sent, Force{});
  EXPECT_EQ(loop.device.force, Force{});
  EXPECT_EQ(loop.device.stops, 1);
  loop.device.write_fault.reset();
  EXPECT_EQ(loop.run(100).safety.state, SafetyState::kLatched);
  EXPECT_EQ(loop.device.force, Force{});
}

// The device is opened ten seconds after the session began.
TEST(Servo, R30_ModelsSeeTheTimeOfTheSession) {
  Loop loop;
  loop.servo->set_session_offset(10'000 * kMs);
  loop.servo->publish(model_of(TellingTime{}));
  const TickReport& report = loop.run(50);
  EXPECT_DOUBLE_EQ(report.asked.x, 1e-9 * static_cast<double>(report.sample.time_ns) + 10.0);
  // The queued samples have the loop's time.
  EXPECT_LE(report.sample.time_ns, 50 * kMs);
}

// The curve continues to yield between two publications, whenever the session began.
TEST(Servo, R30_TheForceOfASweepAgesWhenTheLoopBeganLater) {
  const auto asked_n = [](std::int64_t offset_ns) {
    Loop loop;
    loop.servo->set_session_offset(offset_ns);
    loop.device.sample.position = {0, 5, -1};
    loop.run(1);
    const std::int64_t session_ns = loop.servo->latest().sample.time_ns + offset_ns;
    const CurveNear curve{.pen = {0, 5}, .curve = {0, 0}, .normal = {0, 1}, .time_ns = session_ns};
    ForceModel model(SweepSpring{curve});
    loop.servo->publish(model);
    return norm(loop.run(100).asked);
  };
  const double expected_n = kEditLaw.force_n(5.0 * std::exp(-0.100 / 0.050));
  EXPECT_NEAR(asked_n(0), expected_n, 1e-6);
  EXPECT_NEAR(asked_n(10'000 * kMs), expected_n, 1e-6);
}

TEST(Servo, R49_TheReportSaysWhatTheDeviceHolds) {
  Loop loop;
  loop.servo->publish(model_of(Constant{{0.15, 0.0, 0.0}, {}}));
  loop.engage();
  loop.device.holds = Force{0.05, 0.0, 0.0};
  EXPECT_EQ(loop.run(1).sent, (Force{0.05, 0.0, 0.0}));
  loop.device.holds.reset();
  EXPECT_EQ(loop.run(1).sent, loop.device.force);
}

// With forces on or off, no line is drawn to a position that the arm cannot have reached.
TEST(Servo, R49_AnArmThatLeapsEndsItsStroke) {
  ScriptedDevice device;
  device.has_arm = true;
  const auto servo = std::make_unique<Servo>(device, ServoOptions{});
  std::int64_t now_ns = 0;
  const auto run = [&](int ticks, const Vec3& at) {
    device.sample.position = at;
    for (int i = 0; i < ticks; ++i) servo->step(now_ns += 1'000'000);
  };
  run(50, {10, 20, -1});
  run(500, {1010, 20, -1});
  std::optional<PenSample> last;
  int leaps = 0;
  for (PenSample sample; servo->for_edit().pop(sample); last = sample) {
    if (!last || sample.position.x == last->position.x) continue;
    EXPECT_FALSE(in_contact(*last)) << "the stroke is over";
    ++leaps;
  }
  EXPECT_EQ(leaps, 1) << "steady for long enough, the pen draws on there";
  EXPECT_EQ(servo->latest().ink_cuts, 1u);
}

TEST(Servo, R49_ASampleThatIsNotANumberGivesZeroAndNoInk) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Loop loop;
    loop.servo->publish(model_of(Constant{{0.15, 0.0, 0.0}, {}}));
    loop.engage();
    loop.device.sample.position.y = bad;
    const std::size_t ink = loop.servo->for_edit().size();
    const TickReport& report = loop.run(1);
    EXPECT_EQ(loop.device.force, Force{});
    EXPECT_FALSE(report.sample_ok);
    EXPECT_EQ(loop.servo->for_edit().size(), ink);
    EXPECT_EQ(loop.servo->for_autosave().size(), ink);
  }
}

TEST(Servo, R49_AModelThatMakesNoNumberGivesZero) {
  Loop loop;
  loop.engage();
  loop.servo->publish(model_of(Constant{{std::nan(""), 0.0, 0.0}, {}}));
  EXPECT_EQ(loop.run(1).sent, Force{});
  EXPECT_EQ(loop.device.force, Force{});
  EXPECT_EQ(loop.run(100).sent, Force{});
}

TEST(Servo, OffIsNeverLostAndOnAfterItEngagesFromZero) {
  Loop loop;
  loop.servo->publish(model_of(Constant{{0.15, 0.0, 0.0}, {}}));
  loop.engage();
  loop.servo->disarm();
  loop.servo->arm();
  EXPECT_LE(norm(loop.run(1).sent), 0.01);
  loop.engage();
  loop.servo->arm();
  loop.servo->disarm();
  EXPECT_EQ(loop.run(1).safety.state, SafetyState::kOff);
  EXPECT_EQ(loop.run(1000).sent, Force{});
}

TEST(Servo, ASilentEditSideIsNoticed) {
  Loop loop;
  loop.servo->publish(model_of(Constant{{0.15, 0.0, 0.0}, {}}));
  loop.engage();
  loop.clock.set_heartbeat(false);
  EXPECT_NE(loop.run(400).sent, Force{});
  EXPECT_EQ(loop.run(200).safety.state, SafetyState::kSilent);
  EXPECT_EQ(loop.run(2000).sent, Force{});
}

TEST(Servo, AModelOfTheSameFeelReplacesAtOnce) {
  Loop loop;
  loop.servo->publish(model_of(Constant{{0.1, 0.0, 0.0}, {}}, 5));
  loop.run(50);
  loop.servo->publish(model_of(Constant{{0.2, 0.0, 0.0}, {}}, 5));
  EXPECT_EQ(loop.run(1).asked, (Force{0.2, 0.0, 0.0}));
}

TEST(Servo, AnotherFeelIsCrossFadedOver20Ms) {
  Loop loop;
  loop.servo->publish(model_of(Constant{{0.1, 0.0, 0.0}, {}}, 1));
  loop.run(50);
  loop.servo->publish(model_of(Constant{{0.3, 0.0, 0.0}, {}}, 2));
  for (int i = 0; i <= 20; ++i) {
    EXPECT_NEAR(loop.run(1).asked.x, 0.1 + 0.01 * i, 1e-9) << "tick " << i;
  }
  EXPECT_DOUBLE_EQ(loop.run(1).asked.x, 0.3);
  ASSERT_EQ(loop.servo->latest().terms.size(), 1U);
  EXPECT_EQ(loop.servo->latest().terms[0].force.x, 0.3);
}

TEST(Servo, AThirdFeelWaitsForTheFadeAndTheNewestWins) {
  Loop loop;
  const auto at = [](double x, std::uint32_t id) { return model_of(Constant{{x, 0, 0}, {}}, id); };
  loop.servo->publish(at(0.1, 1));
  loop.run(50);
  loop.servo->publish(at(0.3, 2));
  loop.run(10);
  loop.servo->publish(at(9.0, 3));
  loop.run(5);
  loop.servo->publish(at(0.5, 4));
  double last = loop.run(1).asked.x;
  for (int i = 0; i < 30; ++i) {
    const double x = loop.run(1).asked.x;
    EXPECT_LE(std::abs(x - last), 0.0101);  // 0.2 N in 20 ms, twice; model 3 is never evaluated
    last = x;
  }
  EXPECT_DOUBLE_EQ(last, 0.5);
}

RC_GTEST_PROP(Servo, ChangesOfFeelAreContinuousWheneverTheyCome, ()) {
  Loop loop;
  double last = 0.0;
  double newest = 0.0;
  std::uint32_t id = 1;
  loop.servo->publish(model_of(Constant{{}, {}}, id));
  loop.run(50);
  const auto gaps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 30));
  for (const int gap : gaps) {
    newest = *rc::gen::inRange(-100, 101) * 0.01;
    loop.servo->publish(model_of(Constant{{newest, 0.0, 0.0}, {}}, ++id));
    for (int i = 0; i < gap; ++i) {
      const double x = loop.run(1).asked.x;
      RC_ASSERT(std::abs(x - last) <= 2.0 * 0.001 / 0.020 + 1e-9);
      last = x;
    }
  }
  RC_ASSERT(loop.run(50).asked.x == newest);
}

// A body that a model points to may be deleted as soon as a newer model is in use alone.
TEST(Servo, SaysWhichModelsAreInUse) {
  ServoOptions options;
  options.cross_fade_s = 0.005;
  Loop loop(options);
  EXPECT_EQ(loop.servo->oldest_in_use(), 0u);
  EXPECT_EQ(loop.servo->publish(model_of(Constant{}, 1)), 1u);
  loop.run(20);
  EXPECT_EQ(loop.servo->oldest_in_use(), 1u);
  EXPECT_EQ(loop.servo->publish(model_of(Constant{}, 1)), 2u);
  EXPECT_EQ(loop.servo->oldest_in_use(), 1u) << "no tick has seen the new one";
  loop.run(1);
  EXPECT_EQ(loop.servo->oldest_in_use(), 2u) << "the same fade_id replaces it";
  loop.servo->publish(model_of(Constant{}, 2));
  loop.run(3);
  EXPECT_EQ(loop.servo->oldest_in_use(), 2u) << "it fades out";
  loop.servo->publish(model_of(Constant{}, 3));
  loop.run(4);
  EXPECT_EQ(loop.servo->oldest_in_use(), 3u) << "the next fade begins";
  loop.run(10);
  EXPECT_EQ(loop.servo->oldest_in_use(), 4u);
}

TEST(Servo, AFeelThatTakesOverStartsWithTheMemoryOfTheOther) {
  Loop loop;
  loop.servo->publish(model_of(Remembering{0.01}, 1));
  const double before = loop.run(50).asked.x;
  loop.servo->publish(model_of(Remembering{0.0}, 2));
  for (int i = 0; i < 40; ++i) {
    // Without the other model's memory the force would fall to zero; the old model keeps its own.
    EXPECT_GE(loop.run(1).asked.x, before - 1e-12);
  }
  EXPECT_NEAR(loop.run(1).asked.x, before, 1e-12);
}

TEST(Servo, BricksAreToldTimeCapAndBudget) {
  ServoOptions options;
  options.period_ns = 2 * kMs;
  options.limits.max_stiffness_n_per_m = 450.0;
  Loop loop(options);
  loop.servo->publish(model_of(Telling{}, 1));
  EXPECT_EQ(loop.run(50).asked, (Force{0.002, 0.002, 450.0}));
}

TEST(Servo, R56_SlopesBeyondTheBudgetAreScaledFrictionFirst) {
  Loop loop;
  loop.servo->publish(model_of(TellingScale{{100.0, 300.0, 200.0}}));
  EXPECT_EQ(loop.run(2).asked, (Force{1.0, 1.0, 1.0}));
  loop.servo->publish(model_of(TellingScale{{100.0, 5000.0, 200.0}}));
  const Force scale = loop.run(2).asked;
  EXPECT_LT(scale.x, 1.0);
  EXPECT_GT(scale.x, 0.0);
  EXPECT_EQ(scale.y, 1.0);
  EXPECT_EQ(scale.z, 1.0);
}

TEST(Servo, EverySampleArrivesTwiceInOrder) {
  Loop loop;
  for (int i = 0; i < 500; ++i) {
    loop.device.sample.position.x = 0.01 * i;
    loop.run(1);
  }
  for (Servo::Ring* ring : {&loop.servo->for_edit(), &loop.servo->for_autosave()}) {
    PenSample sample;
    for (int i = 0; i < 500; ++i) {
      ASSERT_TRUE(ring->pop(sample));
      EXPECT_EQ(sample.time_ns, i * kMs);
      EXPECT_EQ(sample.position.x, 0.01 * i);
    }
    EXPECT_FALSE(ring->pop(sample));
  }
}

TEST(Servo, AHungEditSideCostsItsOwnSamplesAndNobodyElses) {
  Loop loop;
  std::vector<PenSample> out(100);
  std::size_t saved = 0;
  const int ticks = static_cast<int>(Servo::kRingSamples) + 1000;
  for (int i = 0; i < ticks; ++i) {
    loop.run(1);
    saved += loop.servo->for_autosave().pop(out);
  }
  EXPECT_EQ(loop.servo->for_edit().dropped(), 1000U);
  EXPECT_EQ(saved, static_cast<std::size_t>(ticks));
}

TEST(Servo, R51_AMouseMayJump) {
  ScriptedDevice mouse;
  mouse.abilities.max_force_n = 0.0;
  const auto servo = std::make_unique<Servo>(mouse, ServoOptions{});
  VirtualClock clock(*servo);
  for (int i = 0; i < 100; ++i) {
    mouse.sample.position.x = i % 2 == 0 ? 0.0 : 50.0;
    clock.tick();
  }
  EXPECT_EQ(servo->for_edit().size(), 100U);
}

TEST(Servo, R50_PeriodsAreClampedTo02To4Ms) {
  ScriptedDevice device;
  for (const auto& [asked, expected] : std::vector<std::pair<std::int64_t, std::int64_t>>{
           {0, 200'000}, {-5, 200'000}, {200'000, 200'000}, {kMs, kMs}, {kMs * 1000, 4 * kMs}}) {
    ServoOptions options;
    options.period_ns = asked;
    options.cross_fade_s = std::nan("");
    const auto servo = std::make_unique<Servo>(device, options);
    EXPECT_EQ(servo->options().period_ns, expected);
    EXPECT_EQ(servo->options().limits.period_ns, expected);
    EXPECT_EQ(servo->options().cross_fade_s, 0.020);
  }
}

TEST(Servo, R50_FadesTakeTheirTimeAtEveryPeriod) {
  for (const std::int64_t period_ns : {200'000, 250'000, 1'000'000, 2'000'000, 4'000'000}) {
    ServoOptions options;
    options.period_ns = period_ns;
    Loop loop(options);
    loop.servo->publish(model_of(Constant{{0.0, 0.0, 0.0}, {}}, 1));
    loop.run(200);
    loop.servo->publish(model_of(Constant{{1.0, 0.0, 0.0}, {}}, 2));
    loop.run(1);
    const auto half = static_cast<int>(10 * kMs / period_ns);
    EXPECT_NEAR(loop.run(half).asked.x, 0.5, 0.11) << period_ns;
    EXPECT_DOUBLE_EQ(loop.run(half + 2).asked.x, 1.0) << period_ns;
  }
}

TEST(Servo, AtFullStrengthNothingIsChanged) {
  Loop plain, reported;
  reported.servo->set_strength(1.0);
  reported.servo->set_strength(std::nan(""));
  for (Loop* loop : {&plain, &reported}) {
    loop->servo->publish(model_of(Constant{{0.1, -0.07, 1.0 / 3.0}, {}}));
    loop->servo->arm();
  }
  for (int i = 0; i < 1000; ++i) {
    const TickReport &a = plain.run(1), &b = reported.run(1);
    ASSERT_EQ(a.asked, (Force{0.1, -0.07, 1.0 / 3.0}));
    ASSERT_EQ(a.sent, b.sent);
    ASSERT_EQ(b.strength, 1.0);
  }
}

// At any period, and after any changes of the requested strength, the strength stays within 0..1.
// It changes linearly towards the last requested value, never faster than the ramp, and the force
// changes with it.
RC_GTEST_PROP(Servo, StrengthIsBoundedContinuousAndMonotone, ()) {
  ServoOptions options;
  options.period_ns = *rc::gen::element<std::int64_t>(200'000, 250'000, kMs, 4 * kMs);
  Loop loop(options);
  const Force force{0.4, -0.3, 0.2};
  loop.servo->publish(model_of(Constant{force, {}}));
  double last = loop.run(5).strength;
  double target = 1.0;
  RC_ASSERT(last == 1.0);
  const double step = 1e-9 * double(options.period_ns) / Servo::kStrengthRampS;
  for (int change = 0; change < 8; ++change) {
    const double share = *rc::gen::element(0.0, 0.25, 0.5, 1.0, -3.0, 7.0, std::nan(""),
                                           std::numeric_limits<double>::infinity());
    loop.servo->set_strength(share);
    if (!std::isnan(share)) target = std::clamp(share, 0.0, 1.0);
    for (int i = *rc::gen::inRange(0, 300); i > 0; --i) {
      const TickReport& tick = loop.run(1);
      RC_ASSERT(tick.strength >= 0.0 && tick.strength <= 1.0);
      RC_ASSERT(std::abs(tick.strength - last) <= step * (1.0 + 1e-9));
      RC_ASSERT(std::abs(target - tick.strength) <= std::abs(target - last));
      RC_ASSERT(tick.strength == target || tick.strength != last);
      RC_ASSERT(tick.asked == tick.strength * force);
      last = tick.strength;
    }
  }
}

TEST(Servo, AtStrengthZeroTheDeviceGetsNoForceWhileTheModelGoesOn) {
  Loop loop;
  loop.servo->publish(model_of(Remembering{0.001}));
  loop.engage();
  ASSERT_GT(norm(loop.run(200).sent), 0.1);
  loop.servo->set_strength(0.0);
  loop.run(51);
  for (int i = 0; i < 50; ++i) {
    const TickReport& tick = loop.run(1);
    ASSERT_EQ(tick.asked, Force{});
    ASSERT_EQ(loop.device.force, Force{});
  }
  loop.servo->set_strength(1.0);
  EXPECT_GT(norm(loop.run(60).asked), 0.3);  // meanwhile the pen pulled the bristle along
}

TEST(Servo, StoppingTakesTheForceOffTheDeviceAndItCanGoOnLater) {
  Loop loop;
  loop.servo->publish(model_of(Constant{{0.15, 0.0, 0.0}, {}}));
  loop.engage();
  loop.servo->arm();  // too late to have an effect
  loop.servo->stop();
  EXPECT_EQ(loop.device.force, Force{});
  EXPECT_EQ(loop.device.stops, 1);
  EXPECT_EQ(loop.servo->latest().safety.state, SafetyState::kOff);
  EXPECT_EQ(loop.servo->latest().sent, Force{});
  loop.engage();
  EXPECT_EQ(loop.device.force, (Force{0.15, 0.0, 0.0}));
}

TEST(Servo, StatsCountLateTicks) {
  Loop loop;
  loop.run(10);
  loop.servo->step(loop.clock.now_ns() + 30 * kMs);
  EXPECT_EQ(loop.servo->stats().ticks(), 11U);
  EXPECT_EQ(loop.servo->stats().missed(), 29U);
  EXPECT_EQ(loop.servo->stats().lateness().max_ns(), 29 * kMs);
}

}  // namespace
}  // namespace felt::servo_test
