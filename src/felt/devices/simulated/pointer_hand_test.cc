#include "felt/devices/simulated/pointer_hand.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "felt/base/constants.h"
#include "felt/devices/simulated/simulated_stylus.h"

namespace felt::pointer_hand_test {
namespace {

// Holds the pen down for 1.5 s on a surface of K N/m and returns the surface's spring force.
double pressed_force_n(const StylusPreset& device, const SimulatedHand& hand,
                       const HandScriptOptions& options, PointerEvent event) {
  SimulatedStylus stylus(device, hand);
  PointerHand pointer(stylus, options);
  double force_n = 0.0;
  for (std::int64_t ms = 0; ms < 1500; ++ms) {
    event.time_ns = ms * kMs;
    event.touching = ms > 200;
    if (ms % 8 == 0) pointer.point(event);
    const PenSample s = stylus.read(ms * kMs).value();
    const double spring_n = 1e-3 * options.plane_n_per_m * depth_mm(s);
    const double damped_n = spring_n - 2e-3 * s.velocity.z;
    const bool ok =
        stylus.write({0, 0, spring_n > 0.0 ? std::max(damped_n, 0.0) : 0.0}).has_value();
    EXPECT_TRUE(ok);
    force_n = spring_n;
  }
  return force_n;
}

// On a device with forces, the tablet's pressure becomes the force of the surface: a pressure p
// gives F0 + p (F1 - F0).
TEST(PointerHand, R18_TabletPressureMapsToTheSamePress) {
  for (const char* name : {"worst", "touch", "premium"}) {
    const StylusPreset& device = *find_stylus_preset(name);
    for (const SimulatedHand& hand : simulated_hands()) {
      const HandScriptOptions options = script_options_for(device, hand);
      for (const double p : {0.1, 0.5, 1.0}) {
        const double force_n =
            pressed_force_n(device, hand, options, {.position = {40, 40}, .pressure = p});
        const double share = (force_n - options.light_n) / (options.full_n - options.light_n);
        // The device's friction may hold the pen. Then the forces of hand and surface may differ.
        const double stuck_n = 2.0 * device.mechanics.friction_n;
        EXPECT_NEAR(share, p, 0.04 + stuck_n / (options.full_n - options.light_n))
            << name << ", " << hand.name;
      }
    }
  }
}

TEST(PointerHand, TiltIsPassedThroughByAllDevices) {
  for (const char* name : {"tablet", "touch"}) {
    const StylusPreset& device = *find_stylus_preset(name);
    SimulatedStylus stylus(device, typical_hand());
    PointerHand pointer(stylus, script_options_for(device, typical_hand()));
    for (const bool touching : {false, true}) {
      const double tilt_deg = touching ? 41.5 : 12.0;
      const std::int64_t start_ns = touching ? 100 * kMs : 0;
      PenSample s;
      for (std::int64_t ms = 0; ms < 100; ms += 8) {
        pointer.point({.time_ns = start_ns + ms * kMs,
                       .position = {40, 40},
                       .touching = touching,
                       .tilt_deg = tilt_deg});
        for (int i = 0; i < 8; ++i) s = stylus.read(start_ns + (ms + i) * kMs).value();
      }
      EXPECT_EQ(s.tilt_deg, tilt_deg) << name;
    }
  }
}

TEST(PointerHand, R18_AMouseHasConstantOrSpeedPressure) {
  SimulatedStylus stylus(*find_stylus_preset("mouse"));
  const HandScriptOptions options =
      script_options_for(*find_stylus_preset("mouse"), typical_hand());
  ASSERT_EQ(options.contact, ContactBy::kPressure);
  PointerHand constant(stylus, options);
  constant.point({.touching = true});
  EXPECT_EQ(constant.pressure(), 0.5);
  constant.point({.time_ns = kMs, .position = {5, 0}, .touching = false});
  EXPECT_EQ(constant.pressure(), 0.0);

  PointerHand by_speed(stylus, options, MousePressure::kBySpeed);
  double last = 1.0;
  for (const double speed : {0.0, 50.0, 150.0, 290.0, 2000.0}) {
    for (int i = 0; i < 100; ++i) {
      by_speed.point(
          {.time_ns = i * 8 * kMs, .position = {speed * 0.008 * i, 0}, .touching = true});
    }
    EXPECT_LT(by_speed.pressure(), last);
    EXPECT_GE(by_speed.pressure(), 0.2 - 1e-12);
    EXPECT_LE(by_speed.pressure(), 0.8 + 1e-12);
    last = by_speed.pressure();
  }
}

// Half of the steps of 66 characters that were drawn with a mouse are slower than 24 mm/s.
TEST(PointerHand, WritingWithAMouseChangesThePressure) {
  EXPECT_DOUBLE_EQ(PointerHand::pressure_at(0.0), 0.8);
  EXPECT_GT(PointerHand::pressure_at(6.0) - PointerHand::pressure_at(60.0), 0.25);
  EXPECT_NEAR(PointerHand::pressure_at(24.0), 0.6, 0.02);
  EXPECT_GT(PointerHand::pressure_at(2000.0), 0.2 - 1e-12);
}

TEST(PointerHand, ALineOfAMouseBeginsThinIfItsWidthFollowsTheSpeed) {
  SimulatedStylus stylus(*find_stylus_preset("mouse"));
  PointerHand pointer(stylus, script_options_for(*find_stylus_preset("mouse"), typical_hand()),
                      MousePressure::kBySpeed);
  for (const std::int64_t start_ns : {100 * kMs, 1000 * kMs}) {
    double last = 0.0;
    for (std::int64_t ms = 0; ms <= 60; ms += 10) {
      pointer.point({.time_ns = start_ns + ms * kMs, .position = {5, 5}, .touching = true});
      EXPECT_GT(pointer.pressure(), last) << ms;
      if (ms == 0) {
        EXPECT_DOUBLE_EQ(pointer.pressure(), 0.2);
      }
      last = pointer.pressure();
    }
    EXPECT_NEAR(last, 0.8, 1e-9);
    pointer.point({.time_ns = start_ns + 70 * kMs, .position = {5, 5}});
  }
}

TEST(PointerHand, IgnoresPlacesThatAreNotFinite) {
  SimulatedStylus stylus(*find_stylus_preset("tablet"));
  PointerHand pointer(stylus, script_options_for(*find_stylus_preset("tablet"), typical_hand()));
  pointer.point({.position = {3, 4}, .touching = true, .pressure = 0.5});
  pointer.point({.position = {std::numeric_limits<double>::quiet_NaN(), 4}, .touching = true});
  pointer.point(
      {.position = {3, 4}, .touching = true, .pressure = std::numeric_limits<double>::quiet_NaN()});
  const auto sample = stylus.read(kMs);
  ASSERT_TRUE(sample.has_value());
  EXPECT_EQ(sample->position, (Vec3{3, 4, 0}));
  EXPECT_EQ(sample->pressure, 0.5);
}

}  // namespace
}  // namespace felt::pointer_hand_test
