// Tests of the simulated devices that the paper of 2002 names beside the PHANToM: a Delta, a
// HapticMASTER, a joystick, and a mouse that only vibrates.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "felt/base/constants.h"
#include "felt/devices/simulated/held_body.h"
#include "felt/devices/simulated/pointer_hand.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/rt/servo.h"

namespace felt::paper_devices_test {
namespace {

constexpr const char* kPaperDevices[] = {"delta", "hapticmaster", "joystick", "vibrating-mouse"};

const StylusPreset& preset(std::string_view name) {
  return *find_stylus_preset(name);
}

double any_between(int low, int high) {
  return 0.01 * *rc::gen::inRange(100 * low, 100 * high);
}

// A stiff force law, a hand that jumps about, and the safety chain.
RC_GTEST_PROP(PaperDevices, R55_NoForceIsBeyondTheLimitOrNoNumber, ()) {
  const StylusPreset& device = preset(kPaperDevices[*rc::gen::inRange<std::size_t>(0, 4)]);
  const SafetyLimits limits = limits_for(device.capabilities);
  SimulatedStylus stylus(device, simulated_hands()[*rc::gen::inRange<std::size_t>(0, 4)]);
  const std::int64_t period_ns = device.capabilities.period_ns;
  const auto servo =
      std::make_unique<Servo>(stylus, ServoOptions{.period_ns = period_ns, .limits = limits});
  PointerHand hand(stylus, script_options_for(device, typical_hand()));
  servo->publish(ForceModel(EditSpring(Point{40.0, 40.0})));
  servo->arm();
  for (std::int64_t tick = 0; tick < 1500; ++tick) {
    const std::int64_t now_ns = tick * period_ns;
    if (tick % 50 == 0) {
      hand.point({.time_ns = now_ns,
                  .position = {any_between(0, 80), any_between(0, 80)},
                  .touching = tick % 100 == 0});
    }
    const TickReport& report = servo->step(now_ns);
    RC_ASSERT(is_finite(report.sample.position) && is_finite(report.sample.velocity));
    RC_ASSERT(is_finite(report.sent) && norm(report.sent) <= limits.peak_force_n + 1e-12);
    RC_ASSERT(norm(stylus.acting_force()) <= limits.peak_force_n + 1e-12);
    if (!device.renders_surface()) RC_ASSERT(stylus.acting_force().z == 0.0);
    if (!device.capabilities.has_force()) RC_ASSERT(stylus.acting_force() == Force{});
  }
}

// The virtual mass m moves under the bias force F and the friction f: x = (F - f) t^2 / 2m.
RC_GTEST_PROP(HapticMaster, R55_MovesInTheDirectionOfTheForce, ()) {
  const StylusPreset& device = preset("hapticmaster");
  SimulatedStylus stylus(device, std::nullopt);
  const Vec3 start{100.0, 100.0, 0.0};
  stylus.place(start);
  const double angle = any_between(0, 7), up = any_between(-1, 2), size_n = any_between(1, 4);
  const Vec3 direction = (1.0 / std::hypot(1.0, up)) * Vec3{std::cos(angle), std::sin(angle), up};
  const Vec3 push = size_n * direction;
  const int ticks = 50;
  for (int i = 0; i <= ticks + 1; ++i) {
    RC_ASSERT(stylus.read(i * device.force_hold_ns).has_value());
    RC_ASSERT(stylus.write({push.x, push.y, push.z}).has_value());
  }
  const double t_s = 1e-9 * static_cast<double>(ticks * device.force_hold_ns);
  const double moved_mm =
      1e3 * (size_n - device.mechanics.friction_n) / device.mechanics.mass_kg * 0.5 * t_s * t_s;
  const Vec3 off = stylus.body().position() - start - moved_mm * direction;
  RC_ASSERT(norm(off) < 0.05 * moved_mm + 0.1);
}

// It measures the force of the hand: a hand that does not overcome the friction moves nothing.
TEST(HapticMaster, R55_FollowsTheMeasuredForceOfTheHand) {
  const StylusPreset& device = preset("hapticmaster");
  const auto moved_mm = [&](double hand_mm) {
    SimulatedStylus stylus(device, typical_hand());
    stylus.place({100.0, 100.0, 5.0});
    for (int i = 0; i < 25; ++i) {
      stylus.aim({100.0 + hand_mm, 100.0, 5.0}, {}, 0);
      EXPECT_TRUE(stylus.read(i * device.force_hold_ns).has_value());
    }
    return stylus.body().position().x - 100.0;
  };
  EXPECT_EQ(moved_mm(0.2), 0.0) << "0.06 N";
  EXPECT_GT(moved_mm(10.0), 1.0) << "3 N";
  EXPECT_LT(moved_mm(-10.0), -1.0);
}

// Returns the lengths of time, ms, for which the same force acts while the program sends another
// force at each tick of a loop with this period.
std::vector<std::int64_t> held_ms(std::int64_t period_ns) {
  SimulatedStylus stylus(preset("hapticmaster"));
  std::vector<std::int64_t> lengths;
  Force last;
  std::int64_t since_ns = 0;
  for (std::int64_t i = 0; i * period_ns < 200 * kMs; ++i) {
    EXPECT_TRUE(stylus.read(i * period_ns).has_value());
    EXPECT_TRUE(stylus.write({1e-3 * static_cast<double>(i + 1), 0.0, 0.0}).has_value());
    if (stylus.acting_force() == last) continue;
    lengths.push_back((i * period_ns - since_ns) / kMs);
    last = stylus.acting_force();
    since_ns = i * period_ns;
  }
  lengths.erase(lengths.begin());  // before the first force
  return lengths;
}

TEST(HapticMaster, R55_HoldsAForceForFourMillisecondsHoweverFastTheLoopIs) {
  for (const std::int64_t period_ns : {kMs, 2 * kMs, 4 * kMs}) {
    const std::vector<std::int64_t> lengths = held_ms(period_ns);
    EXPECT_GE(lengths.size(), 45u) << period_ns;
    for (const std::int64_t length : lengths) EXPECT_EQ(length, 4) << period_ns;
  }
}

TEST(HapticMaster, ItsForceEndsAtOnce) {
  SimulatedStylus stylus(preset("hapticmaster"));
  for (std::int64_t ms = 0; ms < 9; ++ms) {
    ASSERT_TRUE(stylus.read(ms * kMs).has_value());
    ASSERT_TRUE(stylus.write({1.0, 0.0, 0.0}).has_value());
  }
  EXPECT_EQ(stylus.acting_force().x, 1.0);
  stylus.stop();
  ASSERT_TRUE(stylus.read(9 * kMs).has_value());
  EXPECT_EQ(stylus.acting_force(), Force{});
}

// As the driver reports it (StickAxes): the height follows from the pressure.
TEST(Joystick, R55_TheTriggerPutsThePenDown) {
  const StylusPreset& device = preset("joystick");
  SimulatedStylus stylus(device);
  std::int64_t now_ns = 0;
  const auto height_mm = [&](double aim_z, double pressure) {
    PenSample sample;
    for (int i = 0; i < 40; ++i) {
      stylus.aim({20.0, 20.0, aim_z}, pressure, 0);
      sample = stylus.read(now_ns += kMs).value();
      EXPECT_TRUE(stylus.write({0.0, 0.0, 5.0}).has_value());
      EXPECT_EQ(sample.velocity.z, 0.0);
    }
    EXPECT_EQ(in_contact(sample), pressure > 0.0);
    return sample.position.z;
  };
  EXPECT_EQ(height_mm(4.0, 0.0), 0.8);
  EXPECT_EQ(height_mm(4.0, 0.5), -1.0);
  EXPECT_EQ(height_mm(-3.0, 1.0), -2.0);
  EXPECT_EQ(height_mm(-3.0, 0.0), 0.8);
}

// Feltline switches the centring spring of a joystick off.
TEST(Joystick, StaysWhereItIsLetGo) {
  SimulatedStylus stylus(preset("joystick"), std::nullopt);
  stylus.place({60.0, 10.0, 0.0});
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(stylus.read(i * kMs).has_value());
  EXPECT_EQ(stylus.body().position().x, 60.0);
  EXPECT_EQ(stylus.body().position().y, 10.0);
}

TEST(VibratingMouse, R55_HasNoForceAndThePenIsExactlyAtTheAim) {
  SimulatedStylus stylus(preset("vibrating-mouse"));
  EXPECT_TRUE(preset("vibrating-mouse").plays_cues);
  for (int i = 0; i < 200; ++i) {
    const Vec3 at{20.0 + 0.1 * i, 30.0, 0.0};
    stylus.aim(at, 0.5, 0);
    const auto sample = stylus.read(i * kMs);
    ASSERT_TRUE(sample.has_value());
    ASSERT_TRUE(stylus.write({1.0, 2.0, 3.0}).has_value());
    EXPECT_EQ(stylus.acting_force(), Force{});
  }
  EXPECT_NEAR(stylus.read(400 * kMs)->position.x, 20.0 + 0.1 * 199, 1e-9);
}

}  // namespace
}  // namespace felt::paper_devices_test
