#include "felt/haptics/safety/safety_guards.h"

#include <gtest/gtest.h>

#include <limits>

#include "felt/base/constants.h"

namespace felt::safety_motion_test {
namespace {

constexpr TickTime kTick{0.001, 0.001, 0.001, Lateness::kOnTime};

PenSample at(double x_mm, double vx_mm_per_s = 0.0) {
  return {0, {x_mm, 0, 0}, {vx_mm_per_s, 0, 0}, {}, 0};
}

TEST(JumpGuard, HoldsFor2MillisecondsThenGivesUp) {
  JumpGuard guard({});
  EXPECT_EQ(guard.judge({0, 0, 0}, kTick), PositionVerdict::kBelieved);
  EXPECT_EQ(guard.judge({3.0, 0, 0}, kTick), PositionVerdict::kBelieved);
  EXPECT_EQ(guard.judge({6.01, 0, 0}, kTick), PositionVerdict::kHeld);
  EXPECT_EQ(guard.judge({6.01, 0, 0}, kTick), PositionVerdict::kHeld);
  EXPECT_EQ(guard.judge({6.01, 0, 0}, kTick), PositionVerdict::kFault) << "waiting is no excuse";
}

TEST(JumpGuard, AJumpThatComesBackIsForgiven) {
  JumpGuard guard({});
  guard.judge({0, 0, 0}, kTick);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(guard.judge({50, 0, 0}, kTick), PositionVerdict::kHeld);
    for (int k = 0; k < 8; ++k) {
      EXPECT_EQ(guard.judge({0, 0, 0}, kTick), PositionVerdict::kBelieved);
    }
  }
}

TEST(JumpGuard, APositionThatLiesInEverySecondSampleIsAFault) {
  JumpGuard guard({});
  guard.judge({0, 0, 0}, kTick);
  int ticks = 0;
  while (guard.judge({1000, 0, 0}, kTick) != PositionVerdict::kFault && ticks < 1000) {
    EXPECT_EQ(guard.judge({0, 0, 0}, kTick), PositionVerdict::kBelieved);
    ticks += 2;
  }
  EXPECT_GE(ticks, 10);
  EXPECT_LE(ticks, 25);
}

TEST(JumpGuard, TheReachGrowsWithTheTickUpTo5Milliseconds) {
  const auto judge = [](double mm, double model_s) {
    JumpGuard guard({});
    guard.judge({0, 0, 0}, kTick);
    return guard.judge({mm, 0, 0}, {.model_s = model_s, .charged_s = model_s});
  };
  EXPECT_EQ(judge(0.59, 0.0002), PositionVerdict::kBelieved);
  EXPECT_EQ(judge(0.61, 0.0002), PositionVerdict::kHeld);
  EXPECT_EQ(judge(14.9, 0.005), PositionVerdict::kBelieved);
  EXPECT_EQ(judge(15.1, 0.005), PositionVerdict::kHeld);
  EXPECT_EQ(judge(1e308, 0.005), PositionVerdict::kHeld);
}

TEST(JumpGuard, TicksWithoutANewSampleBelongToTheNextOne) {
  const auto judge = [](double mm, int waits, Lateness lateness) {
    JumpGuard guard({});
    guard.judge({0, 0, 0}, kTick);
    for (int i = 0; i < waits; ++i) guard.wait(kTick);
    TickTime time = kTick;
    time.lateness = lateness;
    return guard.judge({mm, 0, 0}, time);
  };
  EXPECT_EQ(judge(32.9, 10, Lateness::kOnTime), PositionVerdict::kBelieved);
  EXPECT_EQ(judge(33.1, 10, Lateness::kOnTime), PositionVerdict::kHeld);
  EXPECT_EQ(judge(75.1, 1000, Lateness::kOnTime), PositionVerdict::kHeld) << "no more than 25 ms";
  EXPECT_EQ(judge(74.9, 0, Lateness::kVeryLate), PositionVerdict::kBelieved);
}

TEST(SpeedGuard, TicksWithoutANewSampleBelongToTheNextOne) {
  SpeedGuard guard({});
  guard.update(at(0), kTick);
  for (int i = 0; i < 15; ++i) guard.wait(kTick);
  guard.update(at(8), kTick);
  EXPECT_NEAR(guard.speed_m_per_s(), 0.5, 1e-9);
  EXPECT_FALSE(guard.must_cut());
}

TEST(SpeedGuard, CutsAfterThreeSamplesAbove1OrOneAbove2MetresPerSecond) {
  SpeedGuard guard({});
  guard.update(at(0), kTick);
  guard.update(at(0, 1001), kTick);
  guard.update(at(0, 1001), kTick);
  EXPECT_FALSE(guard.must_cut());
  guard.update(at(0, 999), kTick);
  guard.update(at(0, 1001), kTick);
  guard.update(at(0, 1001), kTick);
  EXPECT_FALSE(guard.must_cut());
  guard.update(at(0, 1001), kTick);
  EXPECT_TRUE(guard.must_cut());
  guard.update(at(0, 0), kTick);
  EXPECT_FALSE(guard.must_cut());
  guard.update(at(0, 2001), kTick);
  EXPECT_TRUE(guard.must_cut());
}

TEST(SpeedGuard, ADeviceThatReportsNoVelocityDoesNotPass) {
  SpeedGuard guard({});
  for (int i = 0; i < 4; ++i) guard.update(at(1.1 * i), kTick);
  EXPECT_NEAR(guard.speed_m_per_s(), 1.1, 1e-9);
  EXPECT_NEAR(guard.velocity_mm_per_s().x, 1100.0, 1e-6);
  EXPECT_TRUE(guard.must_cut());
}

TEST(SpeedGuard, BurstsOfTicksDoNotTurnAQuantumIntoASpeed) {
  SpeedGuard guard({});
  const TickTime burst{0.0002, 0.00001, 0.0002, Lateness::kOnTime};
  for (int i = 0; i < 1000; ++i) {
    guard.update(at(0.055 * (i % 2)), burst);
    EXPECT_FALSE(guard.must_cut());
    EXPECT_LT(guard.speed_m_per_s(), 0.1);
  }
}

TEST(PenSample, FiniteMeansEveryNumber) {
  EXPECT_TRUE(is_finite(PenSample{}));
  for (int i = 0; i < 7; ++i) {
    PenSample s;
    double* const numbers[] = {&s.position.x, &s.position.y, &s.position.z,
                               &s.velocity.x, &s.velocity.y, &s.velocity.z};
    if (i < 6) *numbers[i] = kNan;
    if (i == 6) s.pressure = kNan;
    EXPECT_FALSE(is_finite(s)) << i;
  }
}

}  // namespace
}  // namespace felt::safety_motion_test
