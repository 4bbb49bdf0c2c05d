#include "felt/tools/pencil/landing_pressure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace felt::landing_pressure_test {
namespace {

constexpr std::int64_t kMs = 1'000'000;

/// Returns the pressures of a line whose pen lands at 80 mm/s and moves at 60 mm/s.
template <class Pressure>
std::vector<double> ink_of(int count_ms, Pressure&& pressure) {
  LandingPressure landing;
  PenSample touch;
  touch.velocity = {60.0, 0.0, -80.0};
  landing.begin(touch, true);
  std::vector<double> ink;
  const auto take = [&ink](std::span<const InkSample> samples) {
    for (const InkSample& s : samples) ink.push_back(s.pressure.value_or(0.0));
  };
  for (int ms = 0; ms < count_ms; ++ms) {
    InkSample sample;
    sample.position = {0.06 * ms, 0.0};
    sample.time_ns = ms * kMs;
    sample.pressure = pressure(ms);
    take(landing.push(sample, true));
  }
  take(landing.end());
  return ink;
}

// The dip after the impact ends without a crossing of the level.
TEST(LandingPressure, ADipThatComesBackFromBelowLeavesNoWaist) {
  const auto pressure = [](int ms) {
    if (ms < 30) return 0.9;
    if (ms < 70) return 0.35;
    return 0.5 - 0.03 * std::exp(-0.02 * (ms - 70));
  };
  const std::vector<double> ink = ink_of(400, pressure);
  ASSERT_EQ(ink.size(), 400U);
  EXPECT_NEAR(*std::min_element(ink.begin(), ink.end()), 0.5, 0.01);
  EXPECT_NEAR(*std::max_element(ink.begin(), ink.end()), 0.5, 0.01);
}

TEST(LandingPressure, TheEndOfAShortLineStaysThin) {
  const auto pressure = [](int ms) {
    if (ms < 30) return 0.9;
    return ms < 200 ? 0.5 : 0.5 * (300 - ms) / 100.0;
  };
  const std::vector<double> ink = ink_of(300, pressure);
  ASSERT_EQ(ink.size(), 300U);
  EXPECT_LT(ink.back(), 0.01);
  EXPECT_LT(ink.front(), 0.55);
}

}  // namespace
}  // namespace felt::landing_pressure_test
