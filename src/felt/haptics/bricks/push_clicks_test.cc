#include "felt/haptics/bricks/push_clicks.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace felt::push_clicks_test {
namespace {

PushClicks two_clicks() {
  PushClicks clicks;
  clicks.add(0.5);
  clicks.add(1.0);
  return clicks;
}

PenSample at_depth(double depth_mm) {
  PenSample sample;
  sample.position = {0, 0, -depth_mm};
  return sample;
}

/// Plays depths at 1 kHz and returns the forces in z.
std::vector<double> play(const PushClicks& clicks, const std::vector<double>& depths) {
  ForceMemory memory;
  std::vector<double> forces;
  for (const double depth : depths) {
    memory.begin_tick(0.001);
    const Force force = clicks(at_depth(depth), memory);
    EXPECT_EQ(force.x, 0.0);
    EXPECT_EQ(force.y, 0.0);
    forces.push_back(force.z);
  }
  return forces;
}

std::vector<double> ramp(double from, double to, int ticks) {
  std::vector<double> depths;
  for (int i = 0; i <= ticks; ++i) depths.push_back(from + (to - from) * i / ticks);
  return depths;
}

void append(std::vector<double>& to, const std::vector<double>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

int pulses(const std::vector<double>& forces) {
  int count = 0;
  for (std::size_t i = 1; i < forces.size(); ++i) count += forces[i - 1] == 0.0 && forces[i] != 0.0;
  return count;
}

TEST(PushClicks, OneClickForEachThresholdAndDirection) {
  std::vector<double> depths = ramp(0.2, 0.2, 100);
  append(depths, ramp(0.2, 1.4, 600));
  append(depths, ramp(1.4, 0.2, 600));
  const std::vector<double> forces = play(two_clicks(), depths);
  EXPECT_EQ(pulses(forces), 4);
  // Against the movement: out of the surface on the way in, into the surface on the way out.
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const double against = i < 702 ? forces[i] : -forces[i];
    EXPECT_GE(against, 0.0) << i;
  }
  EXPECT_NEAR(*std::max_element(forces.begin(), forces.end()), PushClicks::kForceN, 0.01);
}

TEST(PushClicks, ALandingAndAPenAtAThresholdFeelNone) {
  EXPECT_EQ(pulses(play(two_clicks(), ramp(0.0, 1.4, 40))), 0);  // lands within 40 ms
  std::vector<double> resting = ramp(0.4, 0.4, 100);
  for (int i = 0; i < 2000; ++i) resting.push_back(0.5 + 0.03 * std::sin(0.3 * i));
  EXPECT_EQ(pulses(play(two_clicks(), resting)), 0);
}

TEST(PushClicks, NoForceInAirOrWithoutThresholds) {
  for (const double force : play(two_clicks(), ramp(-2.0, 0.0, 50))) EXPECT_EQ(force, 0.0);
  for (const double force : play(PushClicks(), ramp(0.1, 2.0, 500))) EXPECT_EQ(force, 0.0);
}

// A pen that moves in any way gains little energy: at most that of hands that turn around within a
// pulse.
RC_GTEST_PROP(PushClicks, GiveHardlyAnyEnergy, (std::uint32_t seed)) {
  std::uint32_t state = seed | 1U;
  const auto next = [&] { return (state = state * 1664525U + 1013904223U) * 0x1p-32; };
  std::vector<double> depths;
  double depth = 0.3, speed = 0.0;
  for (int i = 0; i < 5000; ++i) {
    speed += 0.05 * (next() - 0.5) - 0.01 * speed - 0.002 * (depth - 0.75);
    speed = std::clamp(speed, -0.05, 0.05);  // mm per tick: 50 mm/s
    depth = std::clamp(depth + speed, 0.05, 2.0);
    depths.push_back(depth);
  }
  const std::vector<double> forces = play(two_clicks(), depths);
  double given_mj = 0.0;
  for (std::size_t i = 1; i < depths.size(); ++i) {
    RC_ASSERT(std::abs(forces[i]) <= PushClicks::kForceN);
    given_mj += forces[i] * (depths[i - 1] - depths[i]);  // N mm
  }
  RC_ASSERT(given_mj <= 0.1);
}

}  // namespace
}  // namespace felt::push_clicks_test
