#include "felt/haptics/safety/safety_guards.h"

#include <gtest/gtest.h>

#include <limits>

#include "felt/base/constants.h"

namespace felt::safety_clock_test {
namespace {

TEST(TickClock, TheFirstTickIsOnePeriod) {
  TickClock clock({});
  const TickTime t = clock.tick(-77);
  EXPECT_EQ(t.model_s, 0.001);
  EXPECT_EQ(t.lateness, Lateness::kOnTime);
}

TEST(TickClock, LateOver5AndVeryLateOver20Milliseconds) {
  const auto after = [](std::int64_t step_ns) {
    TickClock clock({});
    clock.tick(0);
    return clock.tick(step_ns).lateness;
  };
  EXPECT_EQ(after(5 * kMs), Lateness::kOnTime);
  EXPECT_EQ(after(5 * kMs + 1000), Lateness::kLate);
  EXPECT_EQ(after(20 * kMs), Lateness::kLate);
  EXPECT_EQ(after(20 * kMs + 1000), Lateness::kVeryLate);
  EXPECT_EQ(after(-kMs), Lateness::kOnTime);
  EXPECT_EQ(after(-6 * kMs), Lateness::kLate);
  EXPECT_EQ(after(-3'600'000 * kMs), Lateness::kVeryLate);
}

TEST(TickClock, DoubtAboutTimeIsSettledAgainstTheForce) {
  TickClock clock({});
  clock.tick(0);
  const TickTime still = clock.tick(0);
  EXPECT_EQ(still.credited_s, 0.0);
  EXPECT_EQ(still.charged_s, 0.0002);
  EXPECT_EQ(still.model_s, 0.0002);
  const TickTime back = clock.tick(-kMs);
  EXPECT_EQ(back.credited_s, 0.0);
  EXPECT_EQ(back.charged_s, 0.0002);
  const TickTime late = clock.tick(9 * kMs);
  EXPECT_EQ(late.credited_s, 0.002) << "a late tick buys two periods at most";
  EXPECT_DOUBLE_EQ(late.charged_s, 0.010);
  EXPECT_EQ(late.model_s, 0.005);
}

TEST(TickClock, TheFarthestTimesDoNotOverflow) {
  TickClock clock({});
  clock.tick(std::numeric_limits<std::int64_t>::min());
  const TickTime t = clock.tick(std::numeric_limits<std::int64_t>::max());
  EXPECT_NEAR(t.charged_s, 1.8446744e10, 1e4);
  EXPECT_EQ(clock.tick(std::numeric_limits<std::int64_t>::min()).charged_s, 0.0002);
}

TEST(HeartbeatWatch, CountsItsOwnTicksAndEachHeartbeatOnce) {
  TickTime tick;  // 1 ms
  HeartbeatWatch watch;
  double silence = 0.0;
  for (int i = 1; i <= 10; ++i) silence = watch.tick(i * kMs, tick);
  EXPECT_NEAR(silence, 0.010, 1e-12);
  watch.beat(10 * kMs);
  EXPECT_NEAR(watch.tick(11 * kMs, tick), 0.001, 1e-12) << "as old as it is";
  watch.beat(10 * kMs);
  EXPECT_NEAR(watch.tick(12 * kMs, tick), 0.002, 1e-12) << "the same one is no news";
  watch.beat(999 * kMs);
  EXPECT_EQ(watch.tick(13 * kMs, tick), 0.0);
  // The clock stands still, but the measured silence still grows.
  for (int i = 0; i < 10; ++i) silence = watch.tick(13 * kMs, tick);
  EXPECT_NEAR(silence, 0.010, 1e-12);
  watch.restart();
  EXPECT_NEAR(watch.tick(14 * kMs, tick), 0.001, 1e-12);
}

}  // namespace
}  // namespace felt::safety_clock_test
