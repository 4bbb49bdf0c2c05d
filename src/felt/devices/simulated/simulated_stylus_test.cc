#include "felt/devices/simulated/simulated_stylus.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "felt/devices/simulated/random.h"

namespace felt {
namespace {

constexpr std::int64_t kMs = 1'000'000;

StylusPreset preset(std::string_view name) {
  return *find_stylus_preset(name);
}

// Steps through `ticks` ticks under a force that `control` makes of the sample.
template <class Control>
PenSample run(SimulatedStylus& stylus, std::int64_t from_ns, int ticks, std::int64_t period_ns,
              Control control) {
  PenSample sample;
  for (int i = 0; i <= ticks; ++i) {
    sample = stylus.read(from_ns + i * period_ns).value();
    EXPECT_TRUE(stylus.write(control(sample)).has_value());
  }
  return sample;
}

Force none(const PenSample&) {
  return {};
}

// With hand spring k to the target at -d and plane spring K, the pen rests at -d k/(k + K).
TEST(SimulatedStylus, RestsWhereHandAndPlaneBalance) {
  for (const SimulatedHand& hand : simulated_hands()) {
    SimulatedStylus stylus(preset("worst"), hand);
    const double plane = 500.0;
    const auto control = [plane](const PenSample& s) {
      return Force{0, 0, 1e-3 * (plane * depth_mm(s) - 2.0 * std::min(s.velocity.z, 0.0))};
    };
    const double target = -1.5 * (hand.stiffness_n_per_m + plane) / hand.stiffness_n_per_m;
    stylus.aim({50, 50, 5}, {}, 0);
    run(stylus, 0, 200, kMs, none);
    stylus.aim({50, 50, target}, {}, 0);
    run(stylus, 200 * kMs, 4000, kMs, control);
    EXPECT_NEAR(stylus.body().position().z, -1.5, 0.035) << hand.name;
    EXPECT_NEAR(stylus.body().position().x, 50.0, 1e-9);
  }
}

TEST(SimulatedStylus, FrictionSticksExactly) {
  SimulatedStylus stylus(preset("touch"), std::nullopt);
  stylus.place({40, 40, 0});
  const Force push{0.15, 0.0, 0.1 + 0.2};  // less its weight: |F| = .25 N < .26 N
  run(stylus, 0, 10'000, kMs, [&](const PenSample&) { return push; });
  EXPECT_EQ(stylus.body().position(), (Vec3{40, 40, 0}));
  EXPECT_EQ(stylus.body().velocity(), Vec3{});
  run(stylus, 10'001 * kMs, 100, kMs, [&](const PenSample&) { return 1.1 * push; });
  EXPECT_GT(stylus.body().position().x, 40.0);
}

}  // namespace
}  // namespace felt
