#include "felt/rt/virtual_clock.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "felt/base/constants.h"
#include "felt/rt/testing/scripted_device.h"

namespace felt::virtual_clock_test {
namespace {

TEST(VirtualClock, TicksArePeriodsApart) {
  ScriptedDevice device;
  ServoOptions options;
  options.period_ns = 250'000;
  const auto servo = std::make_unique<Servo>(device, options);
  VirtualClock clock(*servo);
  EXPECT_EQ(clock.now_ns(), -1);
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(clock.next_ns(), i * 250'000);
    EXPECT_EQ(clock.tick().sample.time_ns, i * 250'000);
    EXPECT_EQ(clock.now_ns(), i * 250'000);
  }
}

TEST(VirtualClock, RunsUpToATime) {
  ScriptedDevice device;
  const auto servo = std::make_unique<Servo>(device, ServoOptions{});
  VirtualClock clock(*servo);
  int ticks = 0;
  clock.run(100 * kMs, [&](const TickReport&) { ++ticks; });
  EXPECT_EQ(ticks, 101);  // including 0 and 100 ms
  clock.run(100 * kMs);
  EXPECT_EQ(clock.now_ns(), 100 * kMs);
}

TEST(VirtualClock, LateTicksComeLateAndMissedOnesNever) {
  ScriptedDevice device;
  const auto servo = std::make_unique<Servo>(device, ServoOptions{});
  const std::array<std::int64_t, 3> lateness{100'000, 29 * kMs + 500'000, -7};
  VirtualClock clock(*servo, lateness);
  std::vector<std::int64_t> times;
  clock.run(61 * kMs, [&](const TickReport& report) { times.push_back(report.sample.time_ns); });
  const std::vector<std::int64_t> expected{100'000, 30 * kMs + 500'000, 31 * kMs,
                                           32 * kMs + 100'000};
  ASSERT_GE(times.size(), expected.size());
  times.resize(expected.size());
  EXPECT_EQ(times, expected);
}

}  // namespace
}  // namespace felt::virtual_clock_test
