#include "felt/devices/hapticmaster/machine_watch.h"

#include <gtest/gtest.h>

#include "felt/base/constants.h"

namespace felt::hapticmaster::machine_watch_test {
namespace {

Signs only(Condition condition, Sign sign) {
  Signs signs{};
  signs[static_cast<std::size_t>(condition)] = sign;
  return signs;
}

TEST(MachineWatch, TheTableIsInTheOrderOfTheConditions) {
  for (std::size_t i = 0; i < kConditions; ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kLimits[i].condition), i);
  }
}

TEST(MachineWatch, R49_EachConditionMayLastForItsLimitAndNotLonger) {
  for (const Limit& limit : kLimits) {
    for (const std::int64_t tick_ns : {kMs, 4 * kMs, 10 * kMs, 300 * kMs}) {
      MachineWatch watch;
      std::int64_t lasted_ns = 0;
      const Limit* broken = nullptr;
      while (broken == nullptr && lasted_ns < kSecond) {
        broken = watch.tick(tick_ns, only(limit.condition, Sign::kPresent));
        lasted_ns += tick_ns;
      }
      ASSERT_EQ(broken, &limit) << limit.words;
      EXPECT_GT(lasted_ns, limit.limit_ns) << limit.words;
      EXPECT_LE(lasted_ns, limit.limit_ns + tick_ns) << "in real time: " << limit.words;
    }
  }
}

TEST(MachineWatch, ATickWithoutNewsChangesNothing) {
  MachineWatch watch;
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(watch.tick(4 * kMs, only(Condition::kImpossiblePosition, Sign::kPresent)), nullptr);
  }
  EXPECT_EQ(watch.tick(4 * kMs, only(Condition::kImpossiblePosition, Sign::kUnknown)), nullptr);
  EXPECT_NE(watch.tick(4 * kMs, only(Condition::kImpossiblePosition, Sign::kUnknown)), nullptr)
      << "it still lasts";
  watch.restart();
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(watch.tick(4 * kMs, only(Condition::kImpossiblePosition, Sign::kUnknown)), nullptr);
  }
}

TEST(MachineWatch, R49_PositionsThatAreBadAgainAndAgainAddUp) {
  for (const int good : {1, 2}) {
    MachineWatch watch;
    int ticks = 0;
    const Limit* broken = nullptr;
    for (; broken == nullptr && ticks < 1000; ++ticks) {
      const bool is_bad = ticks % (good + 1) == 0;
      broken = watch.tick(
          4 * kMs, only(Condition::kImpossiblePosition, is_bad ? Sign::kPresent : Sign::kAbsent));
    }
    EXPECT_LT(ticks, 40) << good;
  }
  MachineWatch watch;
  for (int i = 0; i < 10'000; ++i) {
    const Sign sign = i % 5 == 0 ? Sign::kPresent : Sign::kAbsent;
    EXPECT_EQ(watch.tick(4 * kMs, only(Condition::kImpossiblePosition, sign)), nullptr)
        << "one in five never does";
  }
}

TEST(MachineWatch, AnAnswerEndsASilence) {
  MachineWatch watch;
  for (int i = 0; i < 1000; ++i) {
    const Sign sign = i % 20 == 0 ? Sign::kAbsent : Sign::kPresent;
    EXPECT_EQ(watch.tick(4 * kMs, only(Condition::kNoAnswer, sign)), nullptr);
  }
}

}  // namespace
}  // namespace felt::hapticmaster::machine_watch_test
