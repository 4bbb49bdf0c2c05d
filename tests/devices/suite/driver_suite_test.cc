// Tests the requirements on drivers beyond the contract of a device (R55), for each bench of
// tests/devices/drivers.
#include "tests/devices/suite/driver_suite.h"

#include <gtest/gtest.h>

#include "tests/devices/drivers/scripted_bench.h"

namespace felt::driver_suite_test {
namespace {

class DriverSuite : public ::testing::TestWithParam<std::string_view> {
 protected:
  BenchMaker make_ = [](std::vector<FaultWindow> faults) {
    return make_driver_bench(GetParam(), std::move(faults));
  };
};

TEST_P(DriverSuite, R55_SamplesGoWhereTheHandGoes) {
  EXPECT_EQ(check_axes(make_), "");
}
TEST_P(DriverSuite, R55_ForcesPushTheWayTheyShould) {
  EXPECT_EQ(check_force_signs(make_), "");
}
TEST_P(DriverSuite, R55_PressingIntoTheSurfaceIsPushedOut) {
  EXPECT_EQ(check_pressing(make_), "");
}
TEST_P(DriverSuite, R55_SaysWhatItIs) {
  EXPECT_EQ(check_words(make_), "");
}

TEST(DriverSuites, CatchBadDrivers) {
  const auto maker = [](BadDriver bad) {
    return
        [bad](std::vector<FaultWindow> faults) { return make_bad_bench(bad, std::move(faults)); };
  };
  EXPECT_NE(check_axes(maker(BadDriver::kMirrored)), "");
  EXPECT_NE(check_axes(maker(BadDriver::kSaysNan)), "");
  EXPECT_NE(check_force_signs(maker(BadDriver::kMirrored)), "");
  EXPECT_NE(check_force_signs(maker(BadDriver::kWrongForceSign)), "");
  EXPECT_NE(check_pressing(maker(BadDriver::kWrongForceSign)), "");
  EXPECT_NE(check_pressing(maker(BadDriver::kBreaksRule)), "");
}

INSTANTIATE_TEST_SUITE_P(, DriverSuite, ::testing::ValuesIn(driver_bench_names()),
                         [](const auto& bench) { return std::string(bench.param); });

}  // namespace
}  // namespace felt::driver_suite_test
