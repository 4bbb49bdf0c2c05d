// Runs the device test through the real code of every driver, which is connected to its fake.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "felt/validate/simulated_subject.h"
#include "felt/validate/validator.h"
#include "tests/devices/drivers/bench_device.h"

namespace felt::bench_validator_test {
namespace {

ValidationReport tested(DriverBench& bench, int level) {
  BenchDevice device(bench);
  SimulatedSubject subject(device, bench.hand(), bench.device()->descriptor());
  VirtualTestLoop loop([&subject](std::int64_t now_ns) { subject.before_tick(now_ns); });
  ValidationOptions options;
  options.program = "test";
  options.level = level;
  options.rate_s = 2.0;
  options.soak_s = 5.0;
  return validate(subject, loop, subject, options);
}

class BenchValidatorTest : public ::testing::TestWithParam<std::string_view> {};

TEST_P(BenchValidatorTest, WhatItSaysIsSoundInEveryModel) {
  const auto bench = make_driver_bench(GetParam(), {});
  std::vector<std::string_view> models = bench->other_models();
  models.insert(models.begin(), "");
  for (const std::string_view model : models) {
    if (!model.empty()) {
      ASSERT_TRUE(bench->reconnect_as(model)) << model;
    }
    const ValidationReport report = tested(*bench, 4);
    EXPECT_TRUE(report.passed()) << model << "\n" << report_text(report);
  }
}

/// Returns all benches except evdev. A stick receives effects and renders springs itself, so that
/// the test cannot compare it with the force of a single tick.
std::vector<std::string_view> names_of_force_benches() {
  std::vector<std::string_view> names = driver_bench_names();
  std::erase(names, "evdev");
  return names;
}

class BenchPushTest : public ::testing::TestWithParam<std::string_view> {};

TEST_P(BenchPushTest, ItPushesTheWayThatItIsTold) {
  const auto bench = make_driver_bench(GetParam(), {});
  const ValidationReport report = tested(*bench, 6);
  EXPECT_TRUE(report.passed()) << report_text(report);
  EXPECT_THAT(report_text(report), ::testing::HasSubstr("of the surface: right, down"));
}

INSTANTIATE_TEST_SUITE_P(, BenchValidatorTest, ::testing::ValuesIn(driver_bench_names()),
                         [](const auto& bench) { return std::string(bench.param); });
INSTANTIATE_TEST_SUITE_P(, BenchPushTest, ::testing::ValuesIn(names_of_force_benches()),
                         [](const auto& bench) { return std::string(bench.param); });

}  // namespace
}  // namespace felt::bench_validator_test
