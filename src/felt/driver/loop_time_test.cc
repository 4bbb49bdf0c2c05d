#include "felt/driver/loop_time.h"

#include <gtest/gtest.h>

#include <limits>

#include "felt/base/constants.h"

namespace felt::loop_time_test {
namespace {

TEST(LoopTime, CountsAllOfTheTime) {
  LoopTime time(4 * kMs);
  EXPECT_EQ(time.tick(70 * kMs), 0);
  EXPECT_EQ(time.tick(74 * kMs), 4 * kMs);
  EXPECT_EQ(time.tick(574 * kMs), 500 * kMs) << "a late tick counts as long as it was";
  time.restart();
  EXPECT_EQ(time.tick(9000 * kMs), 0);
  EXPECT_EQ(time.tick(9004 * kMs), 4 * kMs);
}

TEST(LoopTime, AClockThatStopsOrGoesBackStopsNoLimit) {
  LoopTime time(4 * kMs);
  EXPECT_EQ(time.tick(100 * kMs), 0);
  EXPECT_EQ(time.tick(100 * kMs), 4 * kMs);
  EXPECT_EQ(time.tick(-3600 * kSecond), 4 * kMs);
  EXPECT_EQ(time.tick(std::numeric_limits<std::int64_t>::max()), LoopTime::kMaxNs);
  EXPECT_EQ(time.tick(std::numeric_limits<std::int64_t>::min()), 4 * kMs);
}

}  // namespace
}  // namespace felt::loop_time_test
