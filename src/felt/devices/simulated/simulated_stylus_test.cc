#include "felt/devices/simulated/simulated_stylus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/devices/simulated/aim_track.h"
#include "felt/devices/simulated/gliding_aim.h"
#include "felt/devices/simulated/held_body.h"

namespace felt::simulated_stylus_test {
namespace {

StylusPreset preset(std::string_view name) {
  return *find_stylus_preset(name);
}

// Runs ticks with a period of `period_ns`. In each tick it reads the stylus and writes the force
// that `control` computes from the sample.
class Loop {
 public:
  Loop(SimulatedStylus& stylus, std::int64_t period_ns) : stylus_(stylus), period_ns_(period_ns) {}

  template <class Control>
  PenSample run(int ticks, Control control) {
    PenSample sample;
    for (int i = 0; i < ticks; ++i) {
      sample = stylus_.read(now_ns_).value();
      EXPECT_TRUE(stylus_.write(control(sample)).has_value());
      now_ns_ += period_ns_;
    }
    return sample;
  }
  PenSample run(int ticks) {
    return run(ticks, [](const PenSample&) { return Force{}; });
  }

 private:
  SimulatedStylus& stylus_;
  std::int64_t period_ns_;
  std::int64_t now_ns_ = 0;
};

Force plane_force(const PenSample& s, double stiffness_n_per_m) {
  return {0, 0, std::max(0.0, 1e-3 * (stiffness_n_per_m * depth_mm(s) - 2.0 * s.velocity.z))};
}

// With hand spring k and surface spring K, a pen that the hand aims at height -a rests at
// -a k/(k + K).
TEST(SimulatedStylus, RestsWhereHandAndPlaneBalance) {
  for (const SimulatedHand& hand : simulated_hands()) {
    SimulatedStylus stylus(preset("worst"), hand);
    Loop loop(stylus, kMs);
    const double plane = 500.0;
    stylus.aim({50, 50, 5}, {}, 0);
    loop.run(200);
    stylus.aim({50, 50, -1.5 * (hand.stiffness_n_per_m + plane) / hand.stiffness_n_per_m}, {}, 0);
    loop.run(4000, [&](const PenSample& s) {
      return s.position.z < 0.0 ? plane_force(s, plane) : Force{};
    });
    // The device senses the depth in steps of 0.03 mm.
    EXPECT_NEAR(stylus.body().position().z, -1.5, 0.03) << hand.name;
    EXPECT_NEAR(stylus.body().position().x, 50.0, 1e-9) << hand.name;
  }
}

TEST(SimulatedStylus, FrictionSticksExactly) {
  SimulatedStylus stylus(preset("touch"), std::nullopt);
  stylus.place({40, 40, 0});
  Loop loop(stylus, kMs);
  const Force push{0.15, 0.0, 0.1 + 0.2};  // without weight .25 N, below .26 N
  loop.run(10'000, [&](const PenSample&) { return push; });
  EXPECT_EQ(stylus.body().position(), (Vec3{40, 40, 0}));
  EXPECT_EQ(stylus.body().velocity(), Vec3{});
  loop.run(100, [&](const PenSample&) { return 1.1 * push; });
  EXPECT_GT(stylus.body().position().x, 40.0);
}

// A frictionless body under a constant force: x = F t^2 / 2m.
TEST(SimulatedStylus, AcceleratesByItsMass) {
  StylusPreset free = preset("worst");
  free.mechanics.weight_n = 0.0;
  SimulatedStylus stylus(free, std::nullopt);
  stylus.place({50, 50, 0});
  Loop loop(stylus, kMs);
  loop.run(102, [](const PenSample&) { return Force{0.1, 0, 0}; });
  // The force is requested after the first read and acts from the second one on (delay of 1 tick),
  // for 100 ms.
  EXPECT_NEAR(stylus.body().position().x - 50.0, 1e3 * 0.1 / 0.045 * 0.5 * 0.01, 0.12 * 1.02);
  EXPECT_NEAR(stylus.body().velocity().x, 1e3 * 0.1 / 0.045 * 0.1, 1e-6 + 2.3);
}

// Compares every preset and hand with an integration of the same equations in steps of 1 us.
TEST(HeldBody, AgreesWithMicrosecondSteps) {
  for (const StylusPreset& device : stylus_presets()) {
    if (!device.capabilities.has_force()) continue;
    for (const SimulatedHand& hand : simulated_hands()) {
      HeldBody coarse(device.mechanics, {-500, -500, -500}, {500, 500, 500});
      HeldBody fine = coarse;
      coarse.hold(hand);
      fine.hold(hand);
      double worst_mm = 0.0, way_mm = 0.0;
      Vec3 aim;
      for (int ms = 0; ms < 1000; ++ms) {
        const double t = 1e-3 * ms;
        const Vec3 next{20.0 * std::sin(9.0 * t), 8.0 * std::cos(23.0 * t) - 8.0, 3.0 * t};
        const Force force{ms > 300 ? 0.7 : 0.0, 0.0, ms % 200 < 100 ? 0.5 : 0.0};
        for (int i = 0; i < 4; ++i) {
          coarse.step(2.5e-4, lerp(aim, next, 0.25 * i), lerp(aim, next, 0.25 * (i + 1)), force);
        }
        for (int i = 0; i < 1000; ++i) {
          fine.step(1e-6, lerp(aim, next, 1e-3 * i), lerp(aim, next, 1e-3 * (i + 1)), force);
        }
        aim = next;
        worst_mm = std::max(worst_mm, norm(coarse.position() - fine.position()));
        way_mm = std::max(way_mm, norm(fine.position()));
      }
      EXPECT_GT(way_mm, 10.0);
      EXPECT_LT(worst_mm, 1e-3 * way_mm) << device.name << ", " << hand.name;
    }
  }
}

// Without an external force and with a constant aim, the energy never grows. Without friction and
// damping it stays constant.
TEST(HeldBody, EnergyNeverGrows) {
  Random random(7);
  for (int n = 0; n < 200; ++n) {
    const StylusMechanics mechanics{.mass_kg = random.between(0.02, 0.4),
                                    .friction_n = n % 4 == 0 ? 0.0 : random.between(0.0, 0.5),
                                    .viscous_n_s_per_m = random.between(0.0, 1.0)};
    const SimulatedHand hand{.mass_kg = random.between(0.0, 0.1),
                             .stiffness_n_per_m = random.between(10.0, 2000.0),
                             .damping_n_s_per_m = random.between(0.0, 10.0)};
    HeldBody body(mechanics, {-99, -99, -99}, {99, 99, 99});
    body.place({random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)});
    body.hold(hand);
    const Vec3 aim{1, 2, 3};
    double last = body.energy_mj(aim);
    for (int i = 0; i < 5000; ++i) {
      body.step(random.between(1e-5, 5e-3), aim, aim, {});
      const double now = body.energy_mj(aim);
      ASSERT_LE(now, last * (1.0 + 1e-12) + 1e-15) << "case " << n << ", step " << i;
      last = now;
    }
  }
  HeldBody ideal({.mass_kg = 0.05}, {-99, -99, -99}, {99, 99, 99});
  ideal.place({5, 0, 0});
  ideal.hold(SimulatedHand{.mass_kg = 0.0, .stiffness_n_per_m = 300.0, .damping_n_s_per_m = 0.0});
  const double start = ideal.energy_mj({});
  for (int i = 0; i < 100'000; ++i) ideal.step(2.5e-4, {}, {}, {});
  EXPECT_NEAR(ideal.energy_mj({}), start, 1e-9 * start);
}

TEST(SimulatedStylus, PositionsAreInTheSensorsSteps) {
  for (const StylusPreset& device : stylus_presets()) {
    const double step = device.capabilities.position_step_mm;
    if (step == 0.0) continue;
    SimulatedStylus stylus(device);
    Loop loop(stylus, device.capabilities.period_ns);
    for (int i = 0; i < 200; ++i) {
      stylus.aim({20.0 + 0.1 * i, 30.0 + 0.07 * i, -0.02 * i}, {}, 0);
      const PenSample s = loop.run(1);
      const Vec3 off = s.position - stylus.body().position();
      const double z = device.renders_surface() ? s.position.z : 0.0;  // else from the pressure
      for (const double v : {s.position.x, s.position.y, z}) {
        EXPECT_NEAR(v / step, std::round(v / step), 1e-9);
      }
      for (const double v : {off.x, off.y, off.z}) EXPECT_LE(std::fabs(v), 0.5 * step + 1e-9);
    }
  }
}

TEST(SimulatedStylus, ForcesAreBoundedByTheDevice) {
  for (const StylusPreset& device : stylus_presets()) {
    SimulatedStylus stylus(device, std::nullopt);
    Loop loop(stylus, kMs);
    loop.run(20, [](const PenSample&) { return Force{300, -400, 1200}; });
    EXPECT_NEAR(norm(stylus.acting_force()), device.capabilities.max_force_n, 1e-9);
  }
}

// A force that is requested on tick n acts exactly from tick n + delay on.
TEST(SimulatedStylus, DelayIsExactInTicks) {
  for (const int delay : {0, 1, 2, 5}) {
    StylusPreset device = preset("worst");
    device.capabilities.delay_ticks = delay;
    SimulatedStylus stylus(device);
    for (int tick = 0; tick < 100; ++tick) {
      ASSERT_TRUE(stylus.read(tick * kMs).has_value());
      // The force since the last read, [tick - 1, tick], was requested on tick - 1 - delay.
      const int asked_on = tick - 1 - delay;
      EXPECT_EQ(stylus.acting_force().x, asked_on >= 0 ? 1e-3 * asked_on : 0.0) << delay;
      ASSERT_TRUE(stylus.write({1e-3 * tick, 0, 0}).has_value());
    }
    stylus.stop();
    ASSERT_TRUE(stylus.read(100 * kMs).has_value());
    EXPECT_EQ(stylus.acting_force(), Force{}) << "stop() does not wait";
  }
}

TEST(SimulatedStylus, LetGoItFallsAndRests) {
  for (const StylusPreset& device : stylus_presets()) {
    if (!device.capabilities.has_force()) continue;
    SimulatedStylus stylus(device);
    Loop loop(stylus, kMs);
    stylus.aim({40, 40, 3}, {}, 0);
    loop.run(300);
    stylus.hold(std::nullopt);
    loop.run(20'000, [](const PenSample& s) {
      return s.position.z < 0.0 ? plane_force(s, 350.0) : Force{};
    });
    const Vec3 p = stylus.body().position();
    ASSERT_TRUE(is_finite(p));
    EXPECT_LT(norm(stylus.body().velocity()), 5.0) << device.name;
    EXPECT_LE(p.z, 3.1) << device.name;
    EXPECT_GE(p.z, -1.5) << device.name;
  }
}

TEST(SimulatedStylus, StaysInItsWorkspace) {
  for (const StylusPreset& device : stylus_presets()) {
    SimulatedStylus stylus(device, *find_hand("firm"));
    Loop loop(stylus, kMs);
    stylus.aim({10, 10, 0}, {}, 0);
    loop.run(10);
    for (const double far : {1e3, -1e3, 1e300, -1e300}) {
      stylus.aim({far, -far, far}, {}, 0);
      for (int i = 0; i < 2000; ++i) {
        const Vec3 p = loop.run(1).position;
        const double slack = device.capabilities.position_step_mm;
        ASSERT_GE(p.x, device.capabilities.workspace_min.x - slack);
        ASSERT_LE(p.x, device.capabilities.workspace_max.x + slack);
        ASSERT_GE(p.z, device.capabilities.workspace_min.z - slack);
        ASSERT_LE(p.z, device.capabilities.workspace_max.z + slack);
      }
    }
  }
}

TEST(SimulatedStylus, IgnoresWhatIsNotFinite) {
  SimulatedStylus stylus(preset("touch"));
  Loop loop(stylus, kMs);
  stylus.aim({10, 10, 2}, {}, 0);
  loop.run(50);
  stylus.aim({kNan, 10, 2}, {}, 1);
  stylus.aim({10, std::numeric_limits<double>::infinity(), 2}, {}, 1);
  EXPECT_EQ(loop.run(50).buttons, 0u);
  EXPECT_EQ(stylus.hand_aim(), (Vec3{10, 10, 2}));
  stylus.aim({10, 10, 2}, kNan, 0);
  EXPECT_FALSE(loop.run(50).pressure.has_value());

  ASSERT_TRUE(stylus.write({1, 0, 0}).has_value());
  const auto refused = stylus.write({0, 0, kNan});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error(), DeviceFault::kBadData);
  ASSERT_TRUE(stylus.read(1000 * kMs).has_value());
  EXPECT_EQ(stylus.acting_force(), Force{});
}

// After gaps in time, the work is bounded, the state finite and the position of the pen plausible.
TEST(SimulatedStylus, SurvivesGapsAndClocksThatRunBackwards) {
  for (const StylusPreset& device : stylus_presets()) {
    SimulatedStylus stylus(device);
    stylus.aim({30, 30, 1}, {}, 0);
    std::int64_t now_ns = 0;
    for (const std::int64_t gap_ns :
         {kMs, 29 * kMs, kMs, 10'000 * kMs, std::int64_t{0}, kMs, -3'600'000 * kMs, kMs,
          7'200'000 * kMs, std::int64_t{1}, kMs}) {
      now_ns += gap_ns;
      stylus.aim({32, 30, 1}, {}, 0);
      const auto sample = stylus.read(now_ns);
      ASSERT_TRUE(sample.has_value());
      EXPECT_EQ(sample->time_ns, now_ns);
      EXPECT_TRUE(is_finite(sample->position) && is_finite(sample->velocity));
      ASSERT_TRUE(stylus.write({0.2, 0, 0}).has_value());
    }
    for (int i = 0; i < 2000; ++i) {
      now_ns += kMs;
      ASSERT_TRUE(stylus.read(now_ns).has_value());
      ASSERT_TRUE(stylus.write({}).has_value());
    }
    EXPECT_NEAR(stylus.body().position().x, 32.0, 2.0) << device.name;
  }
}

TEST(SimulatedStylus, TheSameCallsGiveTheSameSamples) {
  const auto session = [](std::string_view device) {
    SimulatedStylus stylus(preset(device));
    Random random(3);
    std::vector<PenSample> samples;
    std::int64_t now_ns = 0;
    for (int i = 0; i < 5000; ++i) {
      now_ns += static_cast<std::int64_t>(random.between(1e5, 3e6));
      if (i % 7 == 0) {
        stylus.aim({random.between(0, 50), random.between(0, 50), random.between(-5, 5)}, {}, 0);
      }
      samples.push_back(stylus.read(now_ns).value());
      EXPECT_TRUE(stylus.write(plane_force(samples.back(), 400.0)).has_value());
    }
    return samples;
  };
  for (const StylusPreset& device : stylus_presets()) {
    EXPECT_EQ(session(device.name), session(device.name)) << device.name;
  }
}

// The velocity in a sample is the velocity of the pen, delayed by 1.6 ms.
TEST(SimulatedStylus, VelocityIsLowPassed) {
  SimulatedStylus stylus(preset("worst"), *find_hand("firm"));
  Loop loop(stylus, kMs);
  for (int i = 0; i < 1000; ++i) {
    stylus.aim({10.0 + 0.05 * i, 20, 5}, {}, 0);  // 50 mm/s
    const PenSample s = loop.run(1);
    if (i < 500) continue;
    EXPECT_NEAR(s.velocity.x, 50.0, 8.0);  // steps of .03 mm in 1 ms, low-passed
    EXPECT_EQ(s.velocity.y, 0.0);
  }
}

TEST(SimulatedStylus, R18_PressureOfTabletsIsPassedThrough) {
  SimulatedStylus stylus(preset("tablet"));
  Loop loop(stylus, kMs);
  stylus.aim({10, 10, 4}, 0.0, 0);
  loop.run(5);
  for (const double p : {0.001, 0.25, 0.5, 1.0}) {
    stylus.aim({12, 10, 0}, p, 2);
    const PenSample s = loop.run(10);
    EXPECT_EQ(s.pressure, p);
    EXPECT_EQ(s.buttons, 2u);
    EXPECT_EQ(s.position, (Vec3{12, 10, 0})) << "without a body the pen is where the hand aims";
    EXPECT_TRUE(in_contact(s));
  }
  stylus.aim({12, 10, 0}, 7.5, 0);
  EXPECT_EQ(loop.run(10).pressure, 1.0);
}

// For pens with and without a body, and for aims with and without time stamps.
TEST(SimulatedStylus, ThePenTiltsAsTheHandSays) {
  for (const char* name : {"tablet", "touch"}) {
    for (const bool timed : {false, true}) {
      SimulatedStylus stylus(preset(name));
      Loop loop(stylus, kMs);
      std::int64_t now_ns = 0;
      const auto tilt = [&](std::optional<double> tilt_deg) {
        const Aim aim{{10, 10, 4}, 0.0, 0, tilt_deg};
        timed ? stylus.aim_at(now_ns, aim) : stylus.aim(aim);
        now_ns += 40 * kMs;
        return loop.run(40).tilt_deg;
      };
      EXPECT_EQ(tilt({}), std::nullopt) << name;
      EXPECT_EQ(tilt(32.5), 32.5) << name;
      EXPECT_EQ(tilt(0.0), 0.0) << name;
      EXPECT_EQ(tilt(-4.0), 0.0) << name;
      EXPECT_EQ(tilt(123.0), 90.0) << name;
      EXPECT_EQ(tilt(kNan), std::nullopt) << name;
    }
  }
}

// The pen goes down, up, down and up between two reads. Each change appears in its own read.
TEST(SimulatedStylus, NoTouchIsLostBetweenTwoReads) {
  SimulatedStylus stylus(preset("tablet"));
  Loop loop(stylus, 4 * kMs);
  stylus.aim({10, 10, 4}, 0.0, 0);
  loop.run(3);
  for (int i = 0; i < 5; ++i) {
    stylus.aim({10, 10, 0}, 0.4, 1);
    stylus.aim({10, 10, 0}, 0.5, 1);
    stylus.aim({10, 10, 4}, 0.0, 0);
  }
  int touches = 0;
  bool touched = false;
  for (int i = 0; i < 40; ++i) {
    const bool touching = in_contact(loop.run(1));
    touches += touching && !touched ? 1 : 0;
    touched = touching;
  }
  EXPECT_EQ(touches, 5);
}

// Gives ThreadSanitizer a hand on its own thread, as mouse and tablet have it.
TEST(SimulatedStylus, IsAimedFromAnotherThread) {
  SimulatedStylus stylus(preset("touch"));
  stylus.aim({0, 20, 4}, {}, 0);
  ASSERT_TRUE(stylus.read(0).has_value());
  std::jthread hand([&stylus] {
    for (int i = 1; i <= 2000; ++i) stylus.aim({0.01 * i, 20, 4}, {}, static_cast<unsigned>(i & 1));
  });
  Loop loop(stylus, kMs);
  loop.run(2000);
  hand.join();
  loop.run(2000);  // plays the aims that still wait: each of them presses or releases the button
  stylus.aim({20, 20, 4}, {}, 0);
  loop.run(300);
  EXPECT_NEAR(stylus.hand_aim().x, 20.0, 1e-9);
}

// A hand with a body never jumps, even if the mouse jumps, because the safety chain would treat a
// jump as a fault.
TEST(SimulatedStylus, HandsDoNotLeap) {
  for (const SimulatedHand& hand : simulated_hands()) {
    SimulatedStylus stylus(preset("touch"), hand);
    Loop loop(stylus, kMs);
    stylus.aim({0, 0, 4}, {}, 0);
    loop.run(10);
    stylus.aim({120, 90, 4}, {}, 0);
    for (int i = 0; i < 1000; ++i) {
      loop.run(1);
      ASSERT_LT(norm(stylus.body().velocity()), 900.0) << hand.name;
    }
    EXPECT_NEAR(stylus.body().position().x, 120.0, 10.0) << hand.name;
  }
}

TEST(StylusPresets, AreComplete) {
  for (const char* name :
       {"worst", "touch", "touch-x", "premium", "falcon", "omega", "inverse3", "delta",
        "hapticmaster", "joystick", "mouse", "vibrating-mouse", "tablet"}) {
    const StylusPreset* device = find_stylus_preset(name);
    ASSERT_NE(device, nullptr) << name;
    const Capabilities& can = device->capabilities;
    EXPECT_FALSE(device->source.empty());
    EXPECT_LT(can.workspace_min.x, 0.0);
    EXPECT_GT(can.workspace_max.z, 0.0);
    if (!can.has_force()) continue;
    EXPECT_GT(device->mechanics.mass_kg, 0.0);
    EXPECT_GT(can.advised_force_n, 0.0);
    EXPECT_LE(can.advised_force_n, can.max_force_n);
    EXPECT_GT(can.continuous_force_n, 0.0);
    EXPECT_GT(can.max_stiffness_n_per_m, 0.0);
    EXPECT_GT(can.max_damping_n_s_per_m, 0.0);
    EXPECT_GT(can.position_step_mm, 0.0);
  }
  EXPECT_EQ(find_stylus_preset("no such"), nullptr);
  EXPECT_EQ(find_hand("no such"), nullptr);
  EXPECT_EQ(simulated_hands().size(), 4u);
  EXPECT_EQ(typical_hand().name, "typical");
}

}  // namespace
}  // namespace felt::simulated_stylus_test
