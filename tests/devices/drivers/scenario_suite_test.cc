// Plays whole drawing sessions with every tool through each driver's real code, and compares the
// ink with that of the plain simulated device.
#include "tests/devices/drivers/scenario_suite.h"

#include <cstdio>
#include <set>

#include <gtest/gtest.h>

#include "tests/devices/drivers/scripted_bench.h"
#include "tests/support/repeats.h"

namespace felt::scenario_suite_test {
namespace {

const std::vector<Scenario>& scenarios() {
  static const std::vector<Scenario> all = [] {
    Result<std::vector<Scenario>> read = read_scenarios();
    EXPECT_TRUE(read) << read.error().message;
    return read ? *std::move(read) : std::vector<Scenario>{};
  }();
  return all;
}

class ScenarioSuite : public ::testing::TestWithParam<std::string_view> {};

TEST_P(ScenarioSuite, TheInkIsThatOfThePlainDevice) {
  ASSERT_GE(scenarios().size(), 30U);
  const BenchMaker make = [](std::vector<FaultWindow> faults) {
    return make_driver_bench(GetParam(), std::move(faults));
  };
  double largest_mm = 0.0;
  int expected = 0, lines = 0;
  // With sanitizers, each driver plays a third of the scenarios, not all of them the same third.
  std::size_t number = GetParam().size();
  for (const Scenario& scenario : scenarios()) {
    if (kSanitized && number++ % 3 != 0) continue;
    const ScenarioVerdict verdict = check_scenario(scenario, make);
    EXPECT_EQ(verdict.broken, "") << scenario.name;
    largest_mm = std::max(largest_mm, verdict.difference_mm);
    expected += verdict.expected;
    lines += verdict.lines;
  }
  std::printf("%s: ink differs by %.4f mm at most; %d of %d expectations hold\n",
              std::string(GetParam()).c_str(), largest_mm, expected, lines);
  EXPECT_GE(expected, lines / 2) << "else nothing is compared";
}

TEST(DriverScenarios, CoverEveryTool) {
  std::set<std::string> tools{"pencil"};
  for (const Scenario& scenario : scenarios()) {
    for (const Event& event : scenario.events) {
      if (const auto* tool = std::get_if<SelectTool>(&event.what)) tools.insert(tool->id);
    }
  }
  for (const auto& tool : make_tools()) {
    EXPECT_TRUE(tools.contains(std::string(tool->info().id))) << tool->info().id;
  }
}

TEST(DriverScenarios, BadDriversAreCaught) {
  for (const auto& [bad, name] : bad_drivers()) {
    switch (bad) {
      case BadDriver::kMirrored:
      case BadDriver::kForgetsSamples:
      case BadDriver::kWrongUnits:
      case BadDriver::kWrongForceSign:
      case BadDriver::kSaysNan:
      case BadDriver::kBreaksRule:
      case BadDriver::kRemembers:
        break;
      default:
        continue;
    }
    int caught = 0;
    for (const Scenario& scenario : scenarios()) {
      if (!scenario.has_hand()) continue;
      const ScenarioVerdict verdict =
          check_scenario(scenario, [bad = bad](std::vector<FaultWindow> faults) {
            return make_bad_bench(bad, std::move(faults));
          });
      caught += verdict.broken.empty() ? 0 : 1;
    }
    EXPECT_GT(caught, 0) << name;
    std::printf("%s: caught by %d scripts\n", std::string(name).c_str(), caught);
  }
}

INSTANTIATE_TEST_SUITE_P(, ScenarioSuite, ::testing::ValuesIn(driver_bench_names()),
                         [](const auto& bench) { return std::string(bench.param); });

}  // namespace
}  // namespace felt::scenario_suite_test
