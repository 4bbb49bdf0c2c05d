#include "felt/tools/pencil/width_steps.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "felt/stroke/fit/width_map.h"

namespace felt::width_steps_test {
namespace {

WidthMapOptions widths(double min_mm, double max_mm, double gamma = 1.0) {
  WidthMapOptions options;
  options.min_mm = min_mm;
  options.max_mm = max_mm;
  options.gamma = gamma;
  return options;
}

std::vector<double> steps_of(const WidthSteps& steps) {
  std::vector<double> all;
  for (std::size_t i = 0; i < steps.size(); ++i) all.push_back(steps.width_mm(i));
  return all;
}

TEST(WidthSteps, AreWidthsOfPensInTheRange) {
  EXPECT_EQ(steps_of(WidthSteps(widths(0.3, 1.0))), (std::vector{0.3, 0.5, 0.7, 1.0}));
  EXPECT_EQ(steps_of(WidthSteps(widths(0.3, 6.0))), (std::vector{0.3, 0.7, 1.4, 2.8, 5.6}));
  EXPECT_EQ(WidthSteps(widths(0.35, 0.6)).size(), 0U);  // only 0.5 mm
  EXPECT_EQ(WidthSteps().size(), 0U);
}

RC_GTEST_PROP(WidthSteps, HoldTheWidthOfAStep, (std::uint32_t seed)) {
  std::uint32_t state = seed | 1U;
  const auto next = [&] { return (state = state * 1664525U + 1013904223U) * 0x1p-32; };
  const WidthMapOptions map = widths(0.1 + next(), 2.0 + 10.0 * next(), 0.4 + 2.0 * next());
  WidthSteps steps(map);
  for (int i = 0; i < 50; ++i) {
    const double width = width_of_pressure(map, *steps.held(next()));
    double nearest = 1e9;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      nearest = std::min(nearest, std::abs(width - steps.width_mm(k)));
    }
    RC_ASSERT(nearest < 1e-9);
  }
}

TEST(WidthSteps, AreLeftOnlyBeyondTheHysteresis) {
  WidthSteps steps(widths(0.3, 1.0));  // four steps, limits at 0.25, 0.5 and 0.75
  const double thin = *steps.held(0.2);
  EXPECT_EQ(*steps.held(0.28), thin);
  const double broader = *steps.held(0.3);
  EXPECT_GT(broader, thin);
  EXPECT_EQ(*steps.held(0.22), broader);
  EXPECT_EQ(*steps.held(0.2), thin);
}

TEST(WidthSteps, LeaveAbsentPressureAlone) {
  WidthSteps steps(widths(0.3, 6.0));
  EXPECT_EQ(steps.held(std::nullopt), std::nullopt);
  EXPECT_EQ(WidthSteps().held(0.37), 0.37);
}

}  // namespace
}  // namespace felt::width_steps_test
