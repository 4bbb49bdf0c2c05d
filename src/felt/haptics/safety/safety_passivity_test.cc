#include "felt/haptics/safety/safety_guards.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace felt::safety_passivity_test {
namespace {

PenSample at(const Vec3& position_mm) {
  return {0, position_mm, {}, {}, 0};
}

/// Presses into a plane and releases it, with `delay` ticks between position and force.
double energy_of(double stiffness_n_per_m, std::size_t delay, double speed_mm_per_s) {
  PassivityObserver observer;
  std::array<Force, 8> late{};
  double energy = 0.0;
  for (std::size_t i = 0; i < 2000; ++i) {
    const double t = 0.001 * static_cast<double>(i);
    const PenSample sample = at({0, 0, 0.5 - speed_mm_per_s * std::min(t, 2.0 - t)});
    energy = observer.update(sample, late[i % (delay + 1)]);
    late[i % (delay + 1)] = {0, 0, 0.001 * stiffness_n_per_m * depth_mm(sample)};
  }
  return energy;
}

TEST(PassivityObserver, SeesTheEnergyOfTheHoldAndOfDelay) {
  // A sampled spring returns K d dz T more per contact than it receives, and more with delay.
  EXPECT_NEAR(energy_of(500.0, 0, 5.0), 0.5 * 4.5 * 0.005, 0.003);
  EXPECT_GT(energy_of(500.0, 2, 5.0), 2.5 * energy_of(500.0, 0, 5.0));
  EXPECT_EQ(energy_of(0.0, 0, 5.0), 0.0);
}

TEST(PassivityObserver, DampingTakesEnergyAndANewContactStartsAtZero) {
  PassivityObserver observer;
  double energy = 0.0;
  for (int i = 0; i < 100; ++i) {
    energy = observer.update(at({0.1 * i, 0, -1}), {-0.2, 0, 0});
  }
  EXPECT_NEAR(energy, -0.2 * 9.9, 1e-9);
  observer.update(at({9.9, 0, 1}), {});
  EXPECT_EQ(observer.update(at({9.9, 0, -1}), {}), 0.0);
  observer.reset();
  EXPECT_EQ(observer.update(at({99, 0, -1}), {3, 3, 3}), 0.0) << "the first sample";
}

TEST(PassivityObserver, HugeNumbersSaturate) {
  PassivityObserver observer;
  observer.update(at({1e308, 0, -1}), {});
  EXPECT_TRUE(std::isfinite(observer.update(at({-1e308, 0, -1}), {0, 0, 3})));
}

}  // namespace
}  // namespace felt::safety_passivity_test
