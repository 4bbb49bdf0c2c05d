#include "felt/driver/service_pace.h"

#include <gtest/gtest.h>

#include "felt/base/constants.h"

namespace felt::service_pace_test {
namespace {

void run(ServicePace& pace, int ticks, int every, std::int64_t tick_ns = kMs) {
  for (int i = 1; i <= ticks; ++i) pace.tick(tick_ns, i % every == 0);
}

TEST(ServicePace, AStateInEachTickIsPromptAtEveryPeriod) {
  for (const std::int64_t tick_ns : {kMs / 5, kMs, 4 * kMs}) {
    ServicePace pace(kMs);
    run(pace, 3000, tick_ns < kMs ? 5 : 1, tick_ns);
    EXPECT_EQ(pace.share(), 1.0) << tick_ns;
    EXPECT_FALSE(pace.is_off());
  }
}

TEST(ServicePace, ALateStateHoldsTheForceAndLastingSilenceTakesIt) {
  ServicePace pace(kMs);
  run(pace, 100, 1);
  for (int i = 0; i < 16; ++i) {
    pace.tick(kMs, false);
    EXPECT_EQ(pace.share(), 1.0) << "held";
  }
  pace.tick(kMs, false);
  EXPECT_EQ(pace.share(), 0.0);
  EXPECT_TRUE(pace.is_off());
}

TEST(ServicePace, OneLateStateChangesNothing) {
  for (const int late_ms : {5, 9, 12, 15}) {
    ServicePace pace(kMs);
    run(pace, 100, 1);
    for (int i = 0; i < 100 + late_ms; ++i) {
      pace.tick(kMs, i >= late_ms);
      EXPECT_EQ(pace.share(), 1.0) << late_ms << " ms";
    }
  }
}

TEST(ServicePace, ASlowServiceGoesOffOnceAndComesBackWhenItIsPromptForASecond) {
  ServicePace pace(kMs);
  int changes = 0;
  bool was_off = false;
  const auto count = [&](int ticks, int every) {
    for (int i = 1; i <= ticks; ++i) {
      pace.tick(kMs, i % every == 0);
      changes += pace.is_off() != was_off ? 1 : 0;
      was_off = pace.is_off();
    }
  };
  count(5000, 2);
  EXPECT_TRUE(was_off);
  EXPECT_EQ(changes, 1);
  for (int i = 0; i < 20; ++i) {  // sometimes the service is on time for a while
    count(300, 1);
    count(300, 3);
  }
  EXPECT_EQ(changes, 1);
  count(900, 1);
  EXPECT_TRUE(was_off);
  count(400, 1);
  EXPECT_FALSE(was_off);
  EXPECT_GT(pace.share(), 0.0);
}

TEST(ServicePace, ALoopThatStoodStillSaysNothingAboutTheService) {
  ServicePace pace(kMs);
  for (int i = 0; i < 50; ++i) {
    run(pace, 100, 1);
    pace.tick(500 * kMs, true);
  }
  EXPECT_EQ(pace.share(), 1.0);
}

// A slow computer makes few ticks. The limit of the last force must not grow with them.
TEST(ServicePace, R49_TheLastForceIsHeldForARealTimeHoweverRareTheTicksAre) {
  for (const std::int64_t tick_ns : {4 * kMs, 9 * kMs, 17 * kMs, 40 * kMs}) {
    ServicePace pace(kMs);
    run(pace, 100, 1, tick_ns);
    ASSERT_GT(pace.share(), 0.0);
    std::int64_t held_ns = 0;
    for (; pace.share() > 0.0 && held_ns < kSecond; held_ns += tick_ns) pace.tick(tick_ns, false);
    EXPECT_LE(held_ns, ServicePace::kHoldNs + tick_ns) << tick_ns;
    EXPECT_EQ(pace.waited_ns(), held_ns);
  }
}

}  // namespace
}  // namespace felt::service_pace_test
