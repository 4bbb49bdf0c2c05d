#include "felt/devices/openhaptics/temperature_guard.h"

#include <gtest/gtest.h>

#include <limits>

namespace felt::temperature_guard_test {
namespace {

TEST(TemperatureGuard, CoolMotorsGiveAllThereIs) {
  TemperatureGuard guard(2.5, 0.88);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(guard.allow(0.7), 2.5);
}

TEST(TemperatureGuard, WarmOnesSinkToWhatTheyStandForGoodAndComeBackCool) {
  TemperatureGuard guard(2.5, 0.88);
  EXPECT_DOUBLE_EQ(guard.allow(0.71), 2.5 * 0.999);
  int ticks = 1;
  while (guard.allow(0.6) > 0.88) ++ticks;  // the limit keeps falling between the two marks
  EXPECT_EQ(ticks + 1, 1044);               // ln(2.5 / 0.88) / 0.0010005, whole ticks
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(guard.allow(0.9), 0.88);
  EXPECT_DOUBLE_EQ(guard.allow(0.49), 0.88 * 1.001);
  while (guard.allow(0.6) < 2.5) ++ticks;  // the limit keeps rising between the two marks
  EXPECT_EQ(guard.allowed_n(), 2.5);
}

TEST(TemperatureGuard, NonsenseIsTooWarmAndNothingIsMoreThanThereIs) {
  TemperatureGuard guard(2.5, 0.88);
  EXPECT_LT(guard.allow(std::numeric_limits<double>::quiet_NaN()), 2.5);
  TemperatureGuard weak(0.5, 0.88);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(weak.allow(1.0), 0.5);
}

}  // namespace
}  // namespace felt::temperature_guard_test
