// Tests that a Force Dimension device never searches for home by itself without the user's consent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/devices/drivers/forcedimension_bench.h"

namespace felt::homing_test {
namespace {

using ::testing::HasSubstr;

constexpr fake_dhd::Model kJustSwitchedOn{.is_home = false};

TEST(ForceDimensionHoming, OpeningMovesNothing) {
  ForceDimensionBench bench("omega.3", {}, kJustSwitchedOn, FakeLibrary::kDrd, false);
  bench.before_tick(0);
  ASSERT_TRUE(bench.open().has_value());
  EXPECT_EQ(bench.state().auto_inits, 0);
  EXPECT_EQ(bench.state().enables, 0);
  EXPECT_EQ(bench.device()->homing(), Homing::kByItself);
  EXPECT_THAT(bench.device()->homing_words(), HasSubstr("Take your hand off"));
  EXPECT_EQ(bench.state().auto_inits, 0) << "asking is no yes";

  // The loop does not search either: it reports that homing is missing and sends no force.
  for (std::int64_t t = 0; t < 20'000'000; t += 250'000) {
    bench.before_tick(t);
    const auto sample = bench.device()->read(t);
    ASSERT_FALSE(sample.has_value());
    EXPECT_EQ(sample.error(), DeviceFault::kNotCalibrated);
    const auto written = bench.device()->write({0, 0, 1});
    ASSERT_FALSE(written.has_value());
    EXPECT_EQ(written.error(), DeviceFault::kNotCalibrated);
  }
  EXPECT_EQ(bench.state().auto_inits, 0);
  EXPECT_EQ(bench.state().enables, 0);
  EXPECT_EQ(bench.device()->status().fault, DeviceFault::kNotCalibrated);
  EXPECT_EQ(bench.device()->status().faults, 1U) << "told once, not at each tick";
  EXPECT_EQ(bench.broken_rule(), "");
}

TEST(ForceDimensionHoming, AfterAYesTheArmMovesOnceAndIsLetGo) {
  ForceDimensionBench bench("omega.3", {}, kJustSwitchedOn, FakeLibrary::kDrd, false);
  bench.before_tick(0);
  ASSERT_TRUE(bench.open().has_value());
  ASSERT_TRUE(bench.device()->find_home().has_value());
  EXPECT_EQ(bench.state().auto_inits, 1);
  EXPECT_FALSE(bench.state().is_regulated) << "the library's own loop has let go";
  EXPECT_EQ(bench.state().mode, fake_dhd::State::Mode::kBrake) << "until the loop runs";
  EXPECT_EQ(bench.device()->homing(), Homing::kNone);
  EXPECT_EQ(bench.device()->homing_words(), "");

  ASSERT_TRUE(bench.device()->find_home().has_value());
  EXPECT_EQ(bench.state().auto_inits, 1) << "it is home already";
  bench.before_tick(250'000);
  EXPECT_TRUE(bench.device()->read(250'000).has_value());
  EXPECT_TRUE(bench.device()->write({0, 0, 1}).has_value());
  EXPECT_EQ(bench.broken_rule(), "");
}

TEST(ForceDimensionHoming, ADeviceThatIsHomeDoesNotMove) {
  ForceDimensionBench bench({});
  EXPECT_EQ(bench.state().auto_inits, 0);
}

TEST(ForceDimensionHoming, AnArmThatCannotMoveIsLetGoAndToldInTheLibrarysWords) {
  ForceDimensionBench bench("omega.3", {{InjectedFault::kNoAnswer, 1'000'000, 2'000'000}},
                            kJustSwitchedOn, FakeLibrary::kDrd, false);
  bench.before_tick(0);
  ASSERT_TRUE(bench.open().has_value());
  bench.before_tick(1'500'000);
  const auto home = bench.device()->find_home();
  ASSERT_FALSE(home.has_value());
  EXPECT_THAT(home.error().message, HasSubstr("timeout (error 7)"));
  EXPECT_FALSE(bench.state().is_regulated);
  EXPECT_EQ(bench.state().mode, fake_dhd::State::Mode::kReset);
  EXPECT_EQ(bench.world().held_force(), Force{});
}

TEST(ForceDimensionHoming, WhatDrdDoesNotKnowIsBroughtHomeByHand) {
  ForceDimensionBench bench(
      "falcon", {},
      {.type = 60, .name = "Falcon", .has_serial = false, .is_home = false, .drd_knows_it = false},
      FakeLibrary::kDrd, false);
  bench.before_tick(0);
  ASSERT_TRUE(bench.open().has_value());
  EXPECT_EQ(bench.device()->homing(), Homing::kRestPose);
  EXPECT_THAT(bench.device()->homing_words(), HasSubstr("Push the knob"));
  const auto home = bench.device()->find_home();
  ASSERT_FALSE(home.has_value());
  EXPECT_EQ(bench.state().auto_inits, 0) << "nothing moves that DRD does not know";
}

TEST(ForceDimensionHoming, TheSmallerLibraryWaitsForTheRestPose) {
  ForceDimensionBench bench("omega.3", {}, kJustSwitchedOn, FakeLibrary::kDhd, false);
  bench.world().stylus().place({70, 70, 0});
  bench.before_tick(0);
  ASSERT_TRUE(bench.open().has_value());
  EXPECT_EQ(bench.device()->homing(), Homing::kRestPose);
  EXPECT_THAT(bench.device()->homing_words(), HasSubstr("rest pose"));
  const auto nobody = bench.device()->find_home();
  ASSERT_FALSE(nobody.has_value());
  EXPECT_THAT(nobody.error().message, HasSubstr("timeout (error 7)"));

  bench.world().stylus().place({70, 70, -53});  // pushed back to the end of its range
  bench.before_tick(250'000);
  ASSERT_TRUE(bench.device()->find_home().has_value());
  EXPECT_EQ(bench.device()->homing(), Homing::kNone);
  EXPECT_EQ(bench.state().auto_inits, 0);
  EXPECT_TRUE(bench.device()->read(250'000).has_value());
  EXPECT_EQ(bench.broken_rule(), "");
}

TEST(ForceDimensionHoming, WhoLosesTheWayWhileDrawingIsToldAndNotPushed) {
  ForceDimensionBench bench({{InjectedFault::kUncalibrated, 5'000'000, 9'000'000}});
  for (std::int64_t t = 0; t < 5'000'000; t += 250'000) {
    bench.before_tick(t);
    ASSERT_TRUE(bench.device()->read(t).has_value());
    ASSERT_TRUE(bench.device()->write({0, 0, 1}).has_value());
  }
  for (std::int64_t t = 5'000'000; t < 9'000'000; t += 250'000) {
    bench.before_tick(t);
    const auto sample = bench.device()->read(t);
    EXPECT_EQ(bench.world().held_force(), Force{});
    if (t < 5'000'000 + bench.notice_ns()) continue;
    ASSERT_FALSE(sample.has_value());
    EXPECT_EQ(sample.error(), DeviceFault::kNotCalibrated);
    static_cast<void>(bench.device()->write({}));
  }
  bench.before_tick(10'000'000);
  static_cast<void>(bench.device()->read(10'000'000));
  bench.before_tick(10'250'000);
  EXPECT_TRUE(bench.device()->read(10'250'000).has_value()) << "somebody showed it its rest pose";
  EXPECT_EQ(bench.broken_rule(), "");
}

}  // namespace
}  // namespace felt::homing_test
