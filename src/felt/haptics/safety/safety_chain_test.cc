#include "felt/haptics/safety/safety_chain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "felt/base/constants.h"

namespace felt::safety_chain_test {
namespace {

/// A safety chain with a regular clock. Each tick is one call.
class Rig {
 public:
  explicit Rig(const SafetyLimits& limits = {}) : chain(limits) {}

  Force tick(const Force& asked, const Vec3& position = {}, const Vec3& velocity = {},
             std::int64_t step_ns = kMs) {
    now_ns += step_ns;
    if (is_edit_alive) chain.heartbeat(now_ns);
    chain.begin(now_ns);
    const PenSample sample{said_ns.value_or(now_ns), position, velocity, {}, 0};
    admitted = chain.admit(sample);
    sent = chain.limit(asked, sample);
    return sent;
  }
  void ticks(int n, const Force& asked) {
    for (int i = 0; i < n; ++i) tick(asked);
  }
  /// Arms and engages the chain until it outputs this force. Returns the rig.
  Rig& engaged(const Force& asked = {0, 0, 2}) {
    chain.arm();
    ticks(4, {});
    ticks(520, {});
    ticks(30, asked);
    EXPECT_EQ(state(), SafetyState::kActive);
    EXPECT_EQ(sent, asked);
    return *this;
  }
  [[nodiscard]] SafetyState state() const { return chain.report().state; }
  [[nodiscard]] SafetyFault fault() const { return chain.report().fault; }

  SafetyChain chain;
  std::int64_t now_ns = 0;
  std::optional<std::int64_t> said_ns;  ///< the time of the sample, if different from now
  bool is_edit_alive = true;
  bool admitted = false;
  Force sent;
};

TEST(SafetyChain, NoForceBeforeTheUserArms) {
  Rig rig;
  rig.ticks(2000, {0, 0, 0.1});
  EXPECT_EQ(rig.state(), SafetyState::kOff);
  EXPECT_EQ(rig.sent, Force{});
  rig.tick({}, {500, 0, 0});
  EXPECT_TRUE(rig.admitted) << "a mouse may leap";
}

TEST(SafetyChain, R49_NeverLongerThanThePeak) {
  const SafetyLimits limits = limits_for({.max_force_n = 2.0});
  Rig rig(limits);
  rig.engaged({0, 0, 1});
  for (const Force& f : {Force{1e308, 1e308, -1e308}, Force{0, 0, 1e9}, Force{5, -5, 5}}) {
    for (int i = 0; i < 50; ++i) {
      EXPECT_LE(norm(rig.tick(f)), limits.peak_force_n * (1.0 + 1e-12));
    }
    EXPECT_NEAR(norm(rig.sent), limits.peak_force_n, 1e-9);
    EXPECT_TRUE(rig.chain.report().limited_by & kLimitedByPeak);
  }
}

TEST(SafetyChain, R49_ANumberThatIsNoneStopsWithinTheTickAndLatches) {
  for (double odd : {kNan, kInf, -kInf}) {
    for (int what = 0; what < 3; ++what) {
      Rig rig;
      rig.engaged();
      if (what == 0) rig.tick({odd, 0, 0});
      if (what == 1) rig.tick({0, 0, 2}, {0, odd, 0});
      if (what == 2) rig.tick({0, 0, 2}, {}, {0, 0, odd});
      EXPECT_EQ(rig.sent, Force{});
      EXPECT_EQ(rig.state(), SafetyState::kLatched);
      EXPECT_EQ(rig.fault(), SafetyFault::kNotFinite);
      rig.ticks(3000, {});
      rig.tick({0, 0, 1});
      EXPECT_EQ(rig.sent, Force{});
      EXPECT_EQ(rig.state(), SafetyState::kLatched) << "only the user";
    }
  }
}

TEST(SafetyChain, R49_DeviceFaultsAndTheForceOffKeyTakeOneTick) {
  Rig rig;
  rig.engaged();
  rig.chain.begin(rig.now_ns + kMs);
  rig.chain.device_failed();
  EXPECT_EQ(rig.fault(), SafetyFault::kDeviceError);
  rig.tick({0, 0, 2});
  EXPECT_EQ(rig.sent, Force{});
  EXPECT_EQ(rig.state(), SafetyState::kLatched);

  Rig off;
  off.engaged();
  off.chain.disarm();
  off.tick({0, 0, 2});
  EXPECT_EQ(off.sent, Force{});
  EXPECT_EQ(off.state(), SafetyState::kOff);
}

TEST(SafetyChain, TheForceRisesBy300NewtonPerSecondAndFallsFreely) {
  Rig rig;
  rig.engaged({});
  double last = 0.0;
  for (int i = 0; i < 10; ++i) {
    rig.tick({0, 0, 3});
    EXPECT_NEAR(rig.sent.z - last, 0.3, 1e-12);
    last = rig.sent.z;
  }
  rig.tick({});
  EXPECT_EQ(rig.sent, Force{});
  rig.ticks(20, {0, 0, 3});
  rig.tick({0, 0, -3});
  EXPECT_NEAR(rig.sent.z, -0.3, 1e-12);
  // A tick that is 4 ms late permits two steps of the rise, not four.
  rig.tick({});
  rig.tick({0, 0, 3}, {}, {}, 4 * kMs);
  EXPECT_NEAR(rig.sent.z, 0.6, 1e-12);
}

// A typical user action: arming while the pen presses.
TEST(SafetyChain, APenThatPressesWhenArmedMustBeLiftedFirst) {
  Rig rig;
  rig.chain.arm();
  rig.ticks(5000, {0, 0, 1});
  EXPECT_EQ(rig.state(), SafetyState::kWaiting);
  EXPECT_EQ(rig.sent, Force{});
  rig.ticks(3, {});
  rig.tick({0, 0, 1});
  EXPECT_EQ(rig.state(), SafetyState::kWaiting) << "three calm ticks are not four";
  rig.ticks(4, {0, 0, 0.19});
  EXPECT_EQ(rig.state(), SafetyState::kEngaging);
  double last = 0.0;
  for (int i = 0; i < 499; ++i) {
    rig.tick({0, 0, 3});
    EXPECT_LE(rig.sent.z - last, 0.01 + 1e-12);
    EXPECT_LE(rig.sent.z, 3.0 * (i + 1) / 500.0 + 1e-9);
    last = rig.sent.z;
  }
}

TEST(SafetyChain, PressingLateIntoTheRampDoesNotKickAtItsEnd) {
  Rig rig;
  rig.chain.arm();
  rig.ticks(4 + 490, {});
  double last = 0.0;
  while (rig.state() == SafetyState::kEngaging) {
    rig.tick({0, 0, 2});
    EXPECT_LE(rig.sent.z - last, 0.01 + 1e-12);
    last = rig.sent.z;
    ASSERT_LT(rig.now_ns, 2000 * kMs);
  }
  EXPECT_GT(last, 1.8) << "only when the force has caught up";
}

TEST(SafetyChain, LateTicksEngageAnewSoftly) {
  Rig rig;
  rig.engaged();
  rig.tick({0, 0, 2}, {}, {}, 6 * kMs);
  EXPECT_EQ(rig.state(), SafetyState::kFalling);
  EXPECT_EQ(rig.fault(), SafetyFault::kLateTick);
  double last = 2.0;
  while (rig.state() == SafetyState::kFalling) {
    EXPECT_LE(rig.sent.z, last - 0.06 + 1e-9);
    last = rig.sent.z;
    rig.tick({0, 0, 2});
  }
  EXPECT_EQ(rig.sent, Force{});
  rig.ticks(100, {0, 0, 2});
  EXPECT_EQ(rig.state(), SafetyState::kWaiting);
  rig.ticks(4, {});
  EXPECT_EQ(rig.state(), SafetyState::kEngaging);
}

TEST(SafetyChain, VeryLateTicksAndClocksThatLeapSendNothingInThatTick) {
  for (std::int64_t step : {21 * kMs, 500 * kMs, 3'600'000 * kMs, -21 * kMs, -3'600'000 * kMs}) {
    Rig rig;
    rig.engaged();
    rig.tick({0, 0, 2}, {40, 0, 0}, {}, step);
    EXPECT_EQ(rig.sent, Force{}) << step;
    EXPECT_EQ(rig.state(), SafetyState::kWaiting) << "not a jump: nobody knows where it was";
    EXPECT_EQ(rig.fault(), SafetyFault::kVeryLateTick);
  }
}

TEST(SafetyChain, TimeThatStandsStillAddsNoForce) {
  Rig rig;
  rig.engaged({0, 0, 1});
  for (int i = 0; i < 100; ++i) {
    rig.tick({0, 0, 3}, {}, {}, 0);
    EXPECT_EQ(rig.sent, (Force{0, 0, 1}));
  }
}

TEST(SafetyChain, ThreeSoftFaultsIn10SecondsLatchUntilArmed) {
  const auto fault_after = [](Rig& rig, int pause_ticks) {
    rig.ticks(pause_ticks, {});
    EXPECT_EQ(rig.state(), SafetyState::kActive);
    rig.tick({}, {}, {}, 25 * kMs);
  };
  Rig quick;
  quick.engaged({});
  for (int i = 0; i < 3; ++i) fault_after(quick, 1000);
  EXPECT_EQ(quick.state(), SafetyState::kLatched);
  EXPECT_EQ(quick.fault(), SafetyFault::kTooManyFaults);
  quick.ticks(20000, {});
  EXPECT_EQ(quick.state(), SafetyState::kLatched);
  quick.chain.disarm();
  quick.ticks(10, {});
  EXPECT_EQ(quick.state(), SafetyState::kLatched);
  quick.chain.arm();
  quick.ticks(4, {});
  EXPECT_EQ(quick.state(), SafetyState::kEngaging);

  Rig slow;
  slow.engaged({});
  for (int i = 0; i < 6; ++i) fault_after(slow, 5100);
  EXPECT_EQ(slow.state(), SafetyState::kWaiting);
  EXPECT_EQ(slow.chain.report().soft_faults, 6u);
}

TEST(SafetyChain, ASilentEditSideLeavesDampingThenNothing) {
  Rig rig;
  rig.engaged();
  rig.is_edit_alive = false;
  rig.ticks(499, {0, 0, 2});
  EXPECT_EQ(rig.sent, (Force{0, 0, 2}));
  rig.ticks(60, {0, 0, 2});
  EXPECT_EQ(rig.state(), SafetyState::kSilent);
  EXPECT_EQ(rig.sent, Force{});
  for (int i = 0; i < 40; ++i) rig.tick({0, 0, 2}, {0.05 * i, 0, 0}, {100, 0, 0});
  EXPECT_NEAR(rig.sent.x, -0.1, 1e-6) << "2 N s/m, whatever the device reports";
  EXPECT_EQ(rig.sent.z, 0.0);
  for (int i = 0; i < 1500; ++i) rig.tick({0, 0, 2}, {1.9, 0, 0});
  EXPECT_EQ(rig.fault(), SafetyFault::kEditSilent);
  EXPECT_EQ(rig.sent, Force{});
  rig.ticks(100, {});
  EXPECT_EQ(rig.state(), SafetyState::kWaiting) << "nobody there to engage for";
}

TEST(SafetyChain, AnEditSideThatComesBackIsFadedIn) {
  Rig rig;
  rig.engaged();
  rig.is_edit_alive = false;
  rig.ticks(1000, {0, 0, 2});
  rig.is_edit_alive = true;
  double last = 0.0;
  for (int i = 0; i < 600; ++i) {
    rig.tick({0, 0, 2});
    EXPECT_LE(rig.sent.z - last, 0.01 + 1e-12);
    last = rig.sent.z;
  }
  EXPECT_EQ(rig.state(), SafetyState::kActive);
  EXPECT_EQ(rig.chain.report().soft_faults, 0u);
}

TEST(SafetyChain, AFastPenIsBrakedThenLetGo) {
  Rig rig;
  rig.engaged({});
  double x = 0.0;
  for (int i = 0; i < 30; ++i) rig.tick({}, {x += 0.8, 0, 0}, {800, 0, 0});
  EXPECT_NEAR(rig.sent.x, -0.8, 1e-9);
  EXPECT_TRUE(rig.chain.report().limited_by & kLimitedBySpeed);
  for (int i = 0; i < 2; ++i) rig.tick({1, 0, 0}, {x += 1.1, 0, 0}, {1100, 0, 0});
  EXPECT_EQ(rig.state(), SafetyState::kActive);
  rig.tick({1, 0, 0}, {x += 1.1, 0, 0}, {1100, 0, 0});
  EXPECT_EQ(rig.state(), SafetyState::kFalling);
  EXPECT_EQ(rig.fault(), SafetyFault::kTooFast);
  EXPECT_LE(rig.sent.x, 0.0) << "nothing that pushes on";
}

// A device may report a velocity with the wrong sign. No brake and no damping may push the pen on.
TEST(SafetyChain, R49_AVelocityOfTheWrongSignNeverPushesThePen) {
  for (const double mm_per_s : {50.0, 300.0, 700.0, 900.0}) {
    Rig rig;
    rig.engaged({});
    double x = 0.0;
    for (int i = 0; i < 60; ++i) {
      rig.tick({}, {x += 1e-3 * mm_per_s, 0, 0}, {-mm_per_s, 0, 0});
      EXPECT_LE(rig.sent.x, 0.0) << mm_per_s << " mm/s, tick " << i;
    }
    const bool is_braked = rig.sent.x < -0.1;
    EXPECT_EQ(is_braked, mm_per_s > 600.0) << "the brake works by positions";
    rig.is_edit_alive = false;
    for (int i = 0; i < 900; ++i) {
      const double step = (i / 50) % 2 == 0 ? -0.05 : 0.05;
      rig.tick({0, 0, 2}, {x += step, 0, 0}, {-1e3 * step, 0, 0});
      if (rig.state() != SafetyState::kSilent || i % 50 < 10) continue;  // the filter's delay
      EXPECT_LT(rig.sent.x * step, 0.0) << "damping, tick " << i;
    }
    EXPECT_EQ(rig.state(), SafetyState::kSilent);
  }
}

TEST(SafetyChain, R49_AVelocityOfTheWrongSignNeverPushesBetweenTwoPositions) {
  Rig rig;
  rig.engaged({});
  double x = 0.0;
  double hardest = 0.0;
  for (int i = 0; i < 400; ++i) {  // each position is read four times, with a new time
    if (i % 4 == 0) x += 0.8;
    rig.tick({}, {x, 0, 0}, {-900, 0, 0});
    EXPECT_LE(rig.sent.x, 0.0) << i;
    hardest = std::min(hardest, rig.sent.x);
  }
  EXPECT_LT(hardest, -0.1);
}

TEST(SafetyChain, R49_ADeviceThatFreezesIsNotBrakedForEver) {
  Rig rig;
  rig.engaged({});
  double x = 0.0;
  for (int i = 0; i < 30; ++i) rig.tick({}, {x += 0.9, 0, 0}, {900, 0, 0});
  EXPECT_LT(rig.sent.x, -1.0);
  rig.said_ns = rig.now_ns;  // the same sample again and again
  for (int i = 0; i < 15; ++i) rig.tick({}, {x, 0, 0}, {900, 0, 0});
  EXPECT_LT(rig.sent.x, -1.0) << "it may be late";
  for (int i = 0; i < 15; ++i) rig.tick({}, {x, 0, 0}, {900, 0, 0});
  EXPECT_EQ(rig.sent.x, 0.0);
  rig.said_ns.reset();
  for (int i = 0; i < 30; ++i) rig.tick({}, {x, 0, 0}, {900, 0, 0});
  EXPECT_NEAR(rig.sent.x, 0.0, 1e-6) << "a new time, the same position";
}

TEST(SafetyChain, APositionThatJumpsHoldsTheForceFor2MillisecondsThenLatches) {
  Rig rig;
  rig.engaged();
  for (int i = 0; i < 2; ++i) {
    rig.tick({0, 0, 3}, {5, 0, 0});
    EXPECT_FALSE(rig.admitted);
    EXPECT_EQ(rig.sent, (Force{0, 0, 2}));
  }
  rig.tick({0, 0, 3}, {5, 0, 0});
  EXPECT_EQ(rig.sent, Force{});
  EXPECT_EQ(rig.fault(), SafetyFault::kPositionJump);
  EXPECT_EQ(rig.state(), SafetyState::kLatched);

  Rig back;
  back.engaged();
  for (int i = 0; i < 50; ++i) {
    back.tick({0, 0, 2}, {5, 0, 0});
    for (int k = 0; k < 8; ++k) back.tick({0, 0, 2});
    EXPECT_TRUE(back.admitted);
  }
  EXPECT_EQ(back.state(), SafetyState::kActive);
}

// If the answers of a device are late, it repeats its last sample while the hand continues to move.
TEST(SafetyChain, R49_AHandThatMovesOnDuringASilenceDoesNotJump) {
  for (const int silent_ms : {3, 5, 10, 16, 20}) {
    for (const double mm_per_ms : {0.1, 0.2, 0.5}) {
      Rig rig;
      rig.engaged();
      double x = 0.0;
      for (int i = 0; i < 50; ++i) rig.tick({0, 0, 2}, {x += mm_per_ms, 0, 0});
      rig.said_ns = rig.now_ns;
      for (int i = 0; i < silent_ms; ++i) rig.tick({0, 0, 2}, {x, 0, 0});
      rig.said_ns.reset();
      x += silent_ms * mm_per_ms;
      for (int i = 0; i < 50; ++i) {
        rig.tick({0, 0, 2}, {x += mm_per_ms, 0, 0});
        EXPECT_TRUE(rig.admitted) << silent_ms << " ms at " << mm_per_ms;
      }
      EXPECT_EQ(rig.state(), SafetyState::kActive);
      EXPECT_EQ(rig.chain.report().soft_faults + rig.chain.report().hard_faults, 0u);
    }
  }
}

TEST(SafetyChain, R49_AJumpThatIsRepeatedIsAFaultAfter2Milliseconds) {
  Rig rig;
  rig.engaged();
  rig.tick({0, 0, 2}, {5, 0, 0});
  rig.said_ns = rig.now_ns;
  for (int i = 0; i < 2; ++i) rig.tick({0, 0, 2}, {5, 0, 0});
  EXPECT_EQ(rig.fault(), SafetyFault::kPositionJump);
  EXPECT_EQ(rig.sent, Force{});
}

TEST(SafetyChain, R49_APositionThatLiesInEverySecondSampleLatches) {
  Rig rig;
  rig.engaged();
  for (int i = 0; i < 12; ++i) {
    rig.tick({0, 0, 3}, {1000, 0, 0});
    rig.tick({0, 0, 3});
  }
  EXPECT_EQ(rig.sent, Force{});
  EXPECT_EQ(rig.fault(), SafetyFault::kPositionJump);
}

TEST(SafetyChain, NonsenseLimitsNeverLetAForceThrough) {
  SafetyLimits limits;
  limits.rise_n_per_ms = kNan;
  Rig rig(limits);
  EXPECT_EQ(rig.fault(), SafetyFault::kSelfTest);
  rig.chain.arm();
  rig.ticks(1000, {});
  rig.ticks(10, {0, 0, 1});
  EXPECT_EQ(rig.state(), SafetyState::kLatched);
  EXPECT_EQ(rig.sent, Force{});
}

TEST(SafetyChain, CallsOutOfOrderLatch) {
  Rig rig;
  rig.engaged();
  EXPECT_EQ(rig.chain.limit({0, 0, 2}, {}), Force{}) << "a second limit() in a tick";
  EXPECT_EQ(rig.fault(), SafetyFault::kSelfTest);
  Rig unseen;
  unseen.engaged();
  unseen.chain.begin(unseen.now_ns + kMs);
  EXPECT_EQ(unseen.chain.limit({0, 0, 2}, {}), Force{}) << "limit() without admit()";
}

TEST(SafetyChain, R56_BudgetsTheStiffnessAndSaysSo) {
  Rig rig;
  rig.chain.begin(kMs);
  EXPECT_EQ(rig.chain.budget({500, 600, 300}), StiffnessScale{});
  EXPECT_FALSE(rig.chain.report().limited_by & kLimitedByBudget);
  const StiffnessScale s = rig.chain.budget({1000, 600, 600});
  EXPECT_DOUBLE_EQ(s.friction * 600 + s.lateral * 600, 900.0);
  EXPECT_EQ(s.lateral, 1.0) << "friction gives way first";
  EXPECT_TRUE(rig.chain.report().limited_by & kLimitedByBudget);
}

TEST(SafetyChain, WarmMotorsAreReported) {
  Rig rig(limits_for({.max_force_n = 3.3, .continuous_force_n = 0.88}));
  rig.engaged({0, 0, 1});
  EXPECT_FALSE(rig.chain.report().motors_are_warm);
  rig.ticks(9000, {0, 0, 1});
  EXPECT_TRUE(rig.chain.report().motors_are_warm);
  EXPECT_LT(rig.sent.z, 0.8 * 0.88);
  EXPECT_GT(rig.sent.z, 0.5);
  rig.ticks(9000, {});
  EXPECT_FALSE(rig.chain.report().motors_are_warm);
}

// Tests every state with every event: the complete transition table.
TEST(SafetyChain, TheTableOfStatesAndEvents) {
  using S = SafetyState;
  struct Row {
    S from, late, very_late, device, off, arm;
  };
  const std::vector<Row> table{
      {S::kOff, S::kOff, S::kOff, S::kOff, S::kOff, S::kWaiting},
      {S::kWaiting, S::kWaiting, S::kWaiting, S::kLatched, S::kOff, S::kWaiting},
      {S::kEngaging, S::kFalling, S::kWaiting, S::kLatched, S::kOff, S::kEngaging},
      {S::kActive, S::kFalling, S::kWaiting, S::kLatched, S::kOff, S::kActive},
      {S::kSilent, S::kFalling, S::kWaiting, S::kLatched, S::kOff, S::kSilent},
      {S::kFalling, S::kFalling, S::kWaiting, S::kLatched, S::kOff, S::kFalling},
      {S::kLatched, S::kLatched, S::kLatched, S::kLatched, S::kLatched, S::kWaiting},
  };
  const auto in_state = [](Rig& rig, S state) {
    if (state == S::kOff) return rig.ticks(1, {});
    if (state == S::kWaiting) return rig.chain.arm(), rig.ticks(9, {0, 0, 1});
    if (state == S::kEngaging) return rig.chain.arm(), rig.ticks(4, {}), rig.ticks(300, {0, 0, 2});
    rig.engaged();
    if (state == S::kSilent) {
      rig.is_edit_alive = false;
      rig.ticks(505, {0, 0, 2});
    }
    if (state == S::kFalling) rig.tick({0, 0, 2}, {}, {}, 6 * kMs);
    if (state == S::kLatched) rig.tick({kNan, 0, 0});
  };
  const auto after = [&](S from, int event) {
    Rig rig;
    in_state(rig, from);
    EXPECT_EQ(rig.state(), from);
    const Force asked{0, 0, 1.5};
    if (event == 0) rig.tick(asked, {}, {}, 6 * kMs);
    if (event == 1) rig.tick(asked, {}, {}, 30 * kMs);
    if (event == 2) rig.chain.device_failed();
    if (event == 3) rig.chain.disarm();
    if (event == 4) rig.chain.arm();
    return rig.state();
  };
  for (const Row& row : table) {
    const int from = static_cast<int>(row.from);
    EXPECT_EQ(after(row.from, 0), row.late) << from;
    EXPECT_EQ(after(row.from, 1), row.very_late) << from;
    EXPECT_EQ(after(row.from, 2), row.device) << from;
    EXPECT_EQ(after(row.from, 3), row.off) << from;
    EXPECT_EQ(after(row.from, 4), row.arm) << from;
  }
}

TEST(SafetyChain, R55_TheSameChainForEveryDeviceAndPeriod) {
  for (std::int64_t period_ns : {200'000, 500'000, 1'000'000, 4'000'000}) {
    for (double nominal : {1.5, 3.3, 12.0}) {
      const SafetyLimits limits = limits_for({.max_force_n = nominal, .period_ns = period_ns});
      Rig rig(limits);
      rig.chain.arm();
      const auto ms_per_tick = static_cast<double>(period_ns) * 1e-6;
      double last = 0.0;
      bool was_active = false;
      for (int i = 0; i < 6000; ++i) {
        rig.tick(i < 4 ? Force{} : Force{0, 0, 30}, {}, {}, period_ns);
        EXPECT_LE(rig.sent.z - last, 0.3 * ms_per_tick + 1e-9);
        last = rig.sent.z;
        was_active = was_active || rig.state() == SafetyState::kActive;
      }
      EXPECT_TRUE(was_active);
      EXPECT_NEAR(last, limits.peak_force_n, 1e-9);
    }
  }
}

}  // namespace
}  // namespace felt::safety_chain_test
