// Tests the properties of a bench that every suite relies on.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "felt/base/constants.h"
#include "felt/rt/leap_filter.h"
#include "felt/session/session.h"
#include "tests/devices/drivers/driver_bench.h"
#include "tests/devices/drivers/scripted_bench.h"

namespace felt::driver_bench_test {
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
  // A device that renders forces by itself and receives an update every 8 ms is of another kind.
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
    ASSERT_TRUE(said && said_by_other)
        << "at " << t << " ns: " << one->device()->status().vendor_words.view() << " / "
        << other->device()->status().vendor_words.view();
    EXPECT_TRUE(one->device()->write({}) && other->device()->write({}));
    a = *said, b = *said_by_other;
  }
  EXPECT_GT(plane.to_page(b.position).x, plane.to_page(a.position).x + 5.0);
}

TEST(DriverBenches, EachHasANameOfItsOwn) {
  const auto names = driver_bench_names();
  EXPECT_EQ(std::set<std::string_view>(names.begin(), names.end()).size(), names.size());
  EXPECT_EQ(make_driver_bench("none of them", {}), nullptr);
}

// An arm reports a jump while the pen bounces. The pencil must not draw the samples after the leap
// filter as a single stroke.
TEST(LeapFilterWithAPencil, R49_ALeapDuringABounceDrawsNoLine) {
  for (const double before_z : {-1.0, 0.1}) {
    for (const double after_z : {-1.0, 0.3}) {
      LeapFilter filter{SafetyLimits{}};
      Session session(make_tools(), SessionOptions{});
      ASSERT_TRUE(session.apply({0, SelectTool{"pencil"}}).has_value());
      std::int64_t now_ns = 0;
      const auto draw = [&](int ticks, double x, double z) {
        for (int i = 0; i < ticks; ++i) {
          PenSample sample;
          sample.time_ns = now_ns += kMs;
          sample.position = {x += 0.1, 20, z};
          if (const auto passed = filter.pass(sample, now_ns)) {
            ASSERT_TRUE(session.sample(*passed).has_value());
          }
        }
      };
      draw(100, 20, -1);
      draw(3, 30, before_z);
      draw(4, 1000, after_z);
      draw(300, 1000, -1);
      draw(50, 1030, 3);
      int strokes = 0;
      for (const Layer& layer : session.document().layers()) {
        for (const StrokeId id : layer.strokes) {
          const StrokePtr stroke = session.document().find(id);
          EXPECT_LT(distance(stroke->position(0), stroke->position(stroke->segment_count())), 50.0);
          ++strokes;
        }
      }
      EXPECT_EQ(strokes, 2) << before_z << ' ' << after_z;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, DriverBenchTest, ::testing::ValuesIn(driver_bench_names()),
                         [](const auto& bench) { return std::string(bench.param); });

}  // namespace
}  // namespace felt::driver_bench_test
