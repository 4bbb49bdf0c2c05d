// What every suite takes for granted of a bench.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/drivers/driver_bench.h"
#include "tests/drivers/scripted_bench.h"

namespace felt {
namespace {

class DriverBenchTest : public ::testing::TestWithParam<std::string_view> {};

TEST_P(DriverBenchTest, IsOpenAndSaysWhatItIs) {
  const auto bench = make_driver_bench(GetParam(), {});
  ASSERT_NE(bench, nullptr);
  EXPECT_EQ(bench->name(), GetParam());
  ASSERT_NE(bench->device(), nullptr);
  const DeviceDescriptor& found = bench->device()->descriptor();
  EXPECT_EQ(found.driver + ":", found.id.substr(0, found.driver.size() + 1));
  EXPECT_EQ(bench->device()->homing(), Homing::kNone) << "it is homed";
  EXPECT_EQ(bench->world().held_force(), Force{}) << "opening does not push";
  EXPECT_EQ(bench->broken_rule(), "");
  EXPECT_GT(bench->tolerance_mm(), 0.0);
  // What renders forces by itself, told each 8 ms, is another kind of device.
  const bool is_low_rate = bench->name() == "evdev";
  EXPECT_LE(bench->tolerance_mm(), is_low_rate ? 3.0 : 1.0);
  EXPECT_LE(bench->notice_ns(), (is_low_rate ? 24 : 2) * bench->device()->capabilities().period_ns);
  EXPECT_TRUE(bench->shows(InjectedFault::kUnplugged)) << "every cable can be pulled";
}

TEST_P(DriverBenchTest, TwoOfThemDoNotMeet) {
  const auto one = make_driver_bench(GetParam(), {}), other = make_driver_bench(GetParam(), {});
  one->hand().aim({40, 30, 10}, {}, 0);
  other->hand().aim({60, 50, 10}, {}, 0);
  const PlaneCalibration plane = one->plane();
  PenSample a, b;
  const std::int64_t period_ns = one->device()->capabilities().period_ns;
  for (std::int64_t t = 0; t < 50 * period_ns; t += period_ns) {
    one->before_tick(t);
    other->before_tick(t);
    const auto said = one->device()->read(t), said_by_other = other->device()->read(t);
    ASSERT_TRUE(said && said_by_other);
    EXPECT_TRUE(one->device()->write({}) && other->device()->write({}));
    a = *said, b = *said_by_other;
  }
  EXPECT_GT(plane.to_sheet(b.position).x, plane.to_sheet(a.position).x + 5.0);
}

TEST(DriverBenches, EachHasANameOfItsOwn) {
  const auto names = driver_bench_names();
  EXPECT_EQ(std::set<std::string_view>(names.begin(), names.end()).size(), names.size());
  EXPECT_EQ(make_driver_bench("none of them", {}), nullptr);
}

INSTANTIATE_TEST_SUITE_P(, DriverBenchTest, ::testing::ValuesIn(driver_bench_names()),
                         [](const auto& bench) { return std::string(bench.param); });

}  // namespace
}  // namespace felt
