// Tests the driver of the HapticMASTER with a fake of its controller, as far as they are specific
// to that machine. machine_safety_test.cc tests when it is switched off.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "tests/devices/drivers/hapticmaster/desk.h"
#include "tests/devices/drivers/said.h"

namespace felt::hapticmaster::hapticmaster_driver_test {
namespace {

using ::testing::HasSubstr;

TEST(HapticMasterDriver, IsFoundOnlyIfItsAddressIsSet) {
  Desk desk;
  const auto found = desk.driver->find();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].id, "hapticmaster:192.168.0.25:7654");
  EXPECT_FALSE(found[0].is_connected);
  EXPECT_EQ(found[0].capabilities.period_ns, kTickNs);
  EXPECT_EQ(desk.controller.requests(), 0) << "a list of devices disturbs nothing";
  desk.system.set_environment(kAddressVariable, "10.0.0.7:99");
  EXPECT_EQ(desk.driver->find().at(0).id, "hapticmaster:10.0.0.7:99");
  EXPECT_FALSE(desk.driver->open(found[0], {}).has_value()) << "the other is not named any more";
  for (const char* const text : {"", "10.0.0.7:0", ":7654"}) {
    desk.system.set_environment(kAddressVariable, text);
    EXPECT_TRUE(desk.driver->find().empty()) << text;
  }
}

TEST(HapticMasterDriver, R49_NothingMovesBeforeTheUserAgrees) {
  Desk desk;
  ASSERT_TRUE(desk.open().has_value());
  EXPECT_EQ(desk.device->homing(), Homing::kByItself);
  EXPECT_THAT(desk.device->homing_words(), HasSubstr("docs/devices/hapticmaster.md"));
  EXPECT_THAT(desk.device->homing_words(), HasSubstr("250 N"));
  for (int i = 0; i < 5; ++i) {
    const auto [read, written] = desk.tick({1, 0, 0});
    ASSERT_FALSE(read || written);
    EXPECT_EQ(read.error(), DeviceFault::kNotCalibrated);
    EXPECT_EQ(written.error(), DeviceFault::kNotCalibrated);
  }
  EXPECT_EQ(desk.controller.state(), "off");
  EXPECT_EQ(desk.controller.effects(), 0);
  EXPECT_EQ(desk.controller.largest_asked_n(), 0.0);
  ASSERT_TRUE(desk.device->find_home().has_value());
  EXPECT_EQ(desk.device->homing(), Homing::kNone);
  EXPECT_EQ(desk.controller.state(), "force");
  EXPECT_EQ(desk.controller.effects(), 1);
  EXPECT_GE(desk.controller.inertia_kg(), 3.0);
  EXPECT_TRUE(desk.tick().read.has_value());
  EXPECT_EQ(desk.controller.broken_rule(), "");
}

TEST(HapticMasterDriver, FindsItsEndStopsAndItsZeroForce) {
  Desk desk({.is_force_calibrated = false, .is_position_calibrated = false});
  ASSERT_TRUE(desk.open_at_home());
  EXPECT_TRUE(desk.controller.options().is_force_calibrated);
  EXPECT_TRUE(desk.controller.options().is_position_calibrated);
  EXPECT_EQ(desk.controller.state(), "force");
  EXPECT_EQ(desk.controller.broken_rule(), "");

  Desk pressed({.is_position_calibrated = false, .has_emergency = true});
  ASSERT_TRUE(pressed.open().has_value());
  const auto home = pressed.device->find_home();
  ASSERT_FALSE(home.has_value());
  EXPECT_THAT(home.error().message, HasSubstr("emergency button"));
  EXPECT_EQ(pressed.controller.state(), "off");
  EXPECT_EQ(pressed.controller.effects(), 0);
}

TEST(HapticMasterDriver, SaysWhereItIsAndPushesTheRightWay) {
  Desk desk;
  desk.world.stylus().hold({});
  ASSERT_TRUE(desk.open_at_home());
  desk.world.stylus().place({10, -20, 30});
  for (int i = 0; i < 5; ++i) desk.tick();
  EXPECT_NEAR(norm(desk.tick().read->position - Vec3{10, -20, 30}), 0.0, 0.01);
  desk.push({0.5, -1.0, 2.0});
  EXPECT_NEAR(norm(desk.world.held_force() - Force{0.5, -1.0, 2.0}), 0.0, 1e-5);
  EXPECT_EQ(desk.device->held_force(), desk.world.held_force());
}

// The machine moves its virtual mass under the bias force.
TEST(HapticMasterDriver, TheMassMovesUnderTheForce) {
  Desk desk({}, {}, HapticMasterDevice::kInertiaKg);
  desk.world.stylus().hold(std::nullopt);
  ASSERT_TRUE(desk.open_at_home());
  desk.world.stylus().place({0, 0, 0});
  for (int i = 0; i < 5; ++i) desk.tick();
  Desk::Ticked last = desk.tick({0, 1.5, 0});
  for (int i = 0; i < 100; ++i) last = desk.tick({0, 1.5, 0});
  // 1.5 N on 3 kg for 0.4 s: 0.2 m/s, 40 mm. It takes two ticks until the force has risen.
  EXPECT_NEAR(last.read->velocity.y, 200.0, 8.0);
  EXPECT_NEAR(last.read->position.y, 40.0, 2.0);
}

TEST(HapticMasterDriver, R49_ForcesAreFarBelowThoseOfTheMachine) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({200, 0, 0});
  EXPECT_LE(desk.controller.largest_asked_n(), 3.0);
  EXPECT_EQ(desk.tick({std::nan(""), 0, 0}).written.error(), DeviceFault::kBadData);
  EXPECT_EQ(desk.world.held_force(), Force{});
  desk.push({HUGE_VAL, 0, 0});
  EXPECT_LE(desk.controller.largest_asked_n(), 3.0);
}

// An error message does not say which force acts now.
TEST(HapticMasterDriver, ARefusedForceIsReleased) {
  Desk desk({}, {{InjectedFault::kWriteError, 100 * kMs, 108 * kMs}});
  ASSERT_TRUE(desk.open_at_home());
  while (desk.now_ns < 100 * kMs) desk.tick({1, 0, 0});
  EXPECT_NEAR(desk.held_n(), 1.0, 1e-5);
  desk.tick({0.5, 0, 0});
  const auto ticked = desk.tick({0.5, 0, 0});
  ASSERT_FALSE(ticked.written.has_value());
  EXPECT_EQ(ticked.written.error(), DeviceFault::kForcesOff);
  EXPECT_EQ(desk.world.held_force(), Force{});
  EXPECT_THAT(std::string(desk.device->status().vendor_words.view()), HasSubstr("--- ERROR:"));
}

// If even the release is refused, the guard switches the machine off, and the user must agree anew.
TEST(HapticMasterDriver, R49_ARefusedReleaseSwitchesTheMachineOff) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.controller.say_instead("--- ERROR: effect not found", "set felt", 1000);
  desk.device->stop();
  desk.tick();
  EXPECT_EQ(desk.world.held_force(), Force{});
  EXPECT_EQ(desk.controller.state(), "off");
  EXPECT_EQ(desk.controller.effects(), 0);
  EXPECT_EQ(desk.tick().read.error(), DeviceFault::kNotCalibrated);
  EXPECT_EQ(desk.device->homing(), Homing::kByItself);
  desk.controller.say_instead("", "", 0);
  ASSERT_TRUE(desk.device->find_home().has_value());
  EXPECT_TRUE(desk.tick().read.has_value());
}

TEST(HapticMasterDriver, AMachineThatLeavesItsStateGetsNoForce) {
  for (const char* const state : {"stop", "position", "home"}) {
    Desk desk;
    ASSERT_TRUE(desk.open_at_home());
    desk.push({1, 0, 0});
    desk.controller.set_state(state);
    std::optional<DeviceFault> fault;
    for (int i = 0; i < HapticMasterDevice::kStateTicks && !fault; ++i) {
      const auto ticked = desk.tick({1, 0, 0});
      EXPECT_TRUE(ticked.read.has_value()) << "it is still read";
      if (!ticked.written) fault = ticked.written.error();
    }
    EXPECT_EQ(fault, DeviceFault::kForcesOff) << state;
    for (int i = 0; i < 10; ++i) EXPECT_FALSE(desk.tick({1, 0, 0}).written.has_value());
    desk.controller.set_state("force");
    desk.push({});
    EXPECT_TRUE(desk.tick().written.has_value());
  }
  Desk off;
  ASSERT_TRUE(off.open_at_home());
  off.controller.set_state("off");
  EXPECT_EQ(off.first_fault(3), DeviceFault::kNotCalibrated);
}

// Answers that do not belong to their requests: nothing of what the controller says can be trusted,
// and the machine is switched off through the other connection.
TEST(HapticMasterDriver, R49_AnswersOutOfOrderEndTheConnection) {
  struct Case {
    const char *request, *answer;
  };
  for (const auto& [request, answer] :
       {Case{"get measpos", "Bias force's force set"}, Case{"get measpos", "force"},
        Case{"get measpos", "?!"}, Case{"get modelvel", "force"}, Case{"get state", "[0,0,0]"},
        Case{"get state", "Bias force's force set"}, Case{"set felt", "[0,0,0]"},
        Case{"set felt", "force"}}) {
    Desk desk;
    ASSERT_TRUE(desk.open_at_home());
    desk.push({1, 0, 0});
    desk.controller.say_instead(answer, request);
    EXPECT_EQ(desk.first_fault(3), DeviceFault::kDisconnected) << request << answer;
    EXPECT_EQ(desk.world.held_force(), Force{});
    EXPECT_EQ(desk.controller.state(), "off");
    EXPECT_EQ(desk.controller.effects(), 0);
    EXPECT_EQ(desk.tick().read.error(), DeviceFault::kDisconnected) << "for ever";
  }
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.controller.say_unasked("[0.0,0.0,0.0]");
  EXPECT_EQ(desk.first_fault(3), DeviceFault::kDisconnected) << "an answer from the past";
  EXPECT_EQ(desk.world.held_force(), Force{});
}

TEST(HapticMasterDriver, GarbledAnswersEndTheConnection) {
  using std::string_view_literals::operator""sv;
  for (const auto bytes :
       {"\0\0\0\0\0\0\0\0"sv, "\0\0\4\xFF\0\0\0\0"sv, "\xFF\xFF\xFF\xFF\0\0\0\0"sv,
        "\0\0\0\3\0\0\0\0\1\2\3"sv, "\0\0\0\x20\0\0\0\0[0,0,0]"sv, "x"sv}) {
    Desk desk;
    ASSERT_TRUE(desk.open_at_home());
    desk.push({1, 0, 0});
    desk.controller.babble(bytes);
    EXPECT_EQ(desk.first_fault(20), DeviceFault::kDisconnected);
    EXPECT_EQ(desk.world.held_force(), Force{});
    EXPECT_EQ(desk.controller.state(), "off");
  }
}

TEST(HapticMasterDriver, ImpossiblePositionsAreFaultsAndOver) {
  for (const char* const text : {"[nan,0,0]", "[0,inf,0]", "[0,0]", "[0,0,0,0]", "[,,]",
                                 "[0.9,0,0]", "[0,0,-1e300]", "[0.02,0,0]", "--- ERROR: no"}) {
    Desk desk;
    desk.world.stylus().hold({});
    desk.world.stylus().place({0, 0, 0});
    ASSERT_TRUE(desk.open_at_home());
    desk.push({1, 0, 0});
    desk.controller.say_instead(text, "get measpos");
    const auto read = desk.tick({1, 0, 0}).read;
    ASSERT_FALSE(read.has_value()) << text;
    EXPECT_EQ(read.error(), *text == '-' ? DeviceFault::kOther : DeviceFault::kBadData) << text;
    EXPECT_TRUE(desk.tick().read.has_value()) << text;
  }
}

TEST(HapticMasterDriver, PiecesOfAnswersAreJoined) {
  for (const std::size_t piece : {std::size_t{1}, std::size_t{3}, std::size_t{7}}) {
    for (const bool quotes : {true, false}) {
      Desk desk({.piece = piece, .quotes = quotes});
      ASSERT_TRUE(desk.open_at_home()) << piece;
      for (int i = 0; i < 20; ++i) static_cast<void>(desk.tick({1, 0, 0}));
      EXPECT_TRUE(desk.tick({1, 0, 0}).written.has_value()) << piece;
      EXPECT_NEAR(desk.held_n(), 1.0, 1e-5);
      EXPECT_EQ(desk.device->status().faults, 0u);
    }
  }
}

// measured-use, part three: forces came late and messages piled up before a slow service.
TEST(HapticMasterDriver, R49_ForcesOffNeverWaitsAndNothingPilesUp) {
  for (const double ms : {0.5, 1.9, 2.1, 4.0, 12.0, 40.0, 300.0}) {
    Desk desk({}, {{InjectedFault::kSlowAnswers, 200 * kMs, 5000 * kMs, ms}});
    ASSERT_TRUE(desk.open_at_home());
    while (desk.now_ns < 200 * kMs) desk.tick({1, 0, 0});
    for (int i = 0; i < 700; ++i) desk.tick({1, 0, 0});
    EXPECT_LE(desk.controller.max_waiting(), RequestQueue::kMaxUnanswered) << ms;
    desk.device->stop();
    EXPECT_EQ(desk.controller.newest_force(), Force{}) << ms;
    if (ms >= 4.0) {
      EXPECT_EQ(desk.world.held_force(), Force{}) << ms;
    }
    EXPECT_EQ(desk.controller.broken_rule(), "") << ms;
  }
}

// measured-use, part three: late answers chopped the force, and the log did not say so.
TEST(HapticMasterDriver, R49_OneLateAnswerDoesNotChopTheForce) {
  Desk desk({}, {{InjectedFault::kLateAnswer, 200 * kMs, 220 * kMs, 9.0}});
  ASSERT_TRUE(desk.open_at_home());
  double least_n = 10.0;
  while (desk.now_ns < 400 * kMs) {
    const bool is_steady = desk.now_ns > 100 * kMs;
    const auto ticked = desk.tick({2, 0, 0});
    EXPECT_TRUE(ticked.read.has_value());
    if (is_steady) least_n = std::min(least_n, desk.held_n());
    EXPECT_NEAR(norm(*desk.device->held_force() - desk.controller.newest_force()), 0.0, 1e-5);
  }
  EXPECT_NEAR(least_n, 2.0, 1e-5);
  EXPECT_EQ(desk.device->status().faults, 0u);
}

TEST(HapticMasterDriver, R49_ASilentControllerLosesTheForceAndIsSwitchedOff) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.controller.be_silent(true);
  for (int i = 0; i < 5; ++i) desk.tick({1, 0, 0});
  EXPECT_EQ(desk.world.held_force(), Force{}) << "after 20 ms";
  EXPECT_EQ(desk.first_fault(3), DeviceFault::kOther);
  for (int i = 0; i < 25; ++i) desk.tick({1, 0, 0});
  EXPECT_EQ(desk.tick().read.error(), DeviceFault::kNotCalibrated) << "after 0.1 s";
  EXPECT_EQ(desk.controller.state(), "off");
  EXPECT_EQ(desk.controller.effects(), 0);
  ASSERT_FALSE(desk.device->find_home().has_value());
  EXPECT_EQ(desk.tick().read.error(), DeviceFault::kDisconnected);
  desk.controller.be_silent(false);
  EXPECT_EQ(desk.tick().read.error(), DeviceFault::kDisconnected) << "for ever";
}

TEST(HapticMasterDriver, R49_ALostConnectionTakesTheForceThroughTheOther) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  ASSERT_GT(desk.held_n(), 0.9);
  desk.controller.hang_up();
  EXPECT_EQ(desk.tick({1, 0, 0}).read.error(), DeviceFault::kDisconnected);
  EXPECT_EQ(desk.world.held_force(), Force{}) << "in the same tick";
  EXPECT_EQ(desk.controller.effects(), 0);
  ASSERT_TRUE(desk.open_at_home()) << "opened again";
}

TEST(HapticMasterDriver, R49_WithoutAGuardNothingPushes) {
  for (const bool refuses : {true, false}) {
    Desk desk({.ignores_guard = !refuses, .refuses_guard = refuses});
    ASSERT_TRUE(desk.open().has_value());
    const auto home = desk.device->find_home();
    ASSERT_FALSE(home.has_value());
    EXPECT_THAT(home.error().message, HasSubstr("The second process"));
    for (int i = 0; i < 3; ++i) desk.tick({1, 0, 0});
    EXPECT_EQ(desk.world.held_force(), Force{});
    EXPECT_EQ(desk.controller.state(), "off");
    EXPECT_EQ(desk.controller.effects(), 0);
    EXPECT_EQ(desk.controller.broken_rule(), "");
  }
  Desk one({.max_connections = 1});
  ASSERT_TRUE(one.open().has_value());
  const auto home = one.device->find_home();
  ASSERT_FALSE(home.has_value());
  EXPECT_THAT(home.error().message, HasSubstr("a connection of its own"));
}

// Nobody would switch the machine off if this program were killed now.
TEST(HapticMasterDriver, R49_WithoutItsGuardTheMachineIsSwitchedOff) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.controller.hang_up_guard();
  const auto ticked = desk.tick({1, 0, 0});
  ASSERT_FALSE(ticked.read || ticked.written);
  EXPECT_EQ(ticked.read.error(), DeviceFault::kNotCalibrated);
  EXPECT_EQ(ticked.written.error(), DeviceFault::kNotCalibrated);
  EXPECT_THAT(desk.device->status().vendor_words.view(), HasSubstr("does not run"));
  EXPECT_EQ(desk.world.held_force(), Force{});
  EXPECT_EQ(desk.controller.state(), "off");
  ASSERT_TRUE(desk.device->find_home().has_value()) << "with another one";
  desk.push({1, 0, 0});
  EXPECT_GT(desk.held_n(), 0.9);
}

// As when the program was stopped for a while: the guard has acted, and the user must agree anew.
TEST(HapticMasterDriver, R49_AfterAPauseTheMachineIsOff) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.now_ns += 60 * kMs;
  EXPECT_EQ(desk.first_fault(3), DeviceFault::kNotCalibrated);
  EXPECT_EQ(desk.world.held_force(), Force{});
  EXPECT_EQ(desk.controller.state(), "off");
}

TEST(HapticMasterDriver, ItStaysReadyWhileNoLoopRuns) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.now_ns += 5 * kSecond;
  EXPECT_TRUE(desk.tick().read.has_value()) << "the loop began late";
  desk.push({1, 0, 0});
  desk.device->stop();
  desk.now_ns += 5 * kSecond;
  EXPECT_TRUE(desk.tick().read.has_value()) << "another loop";
  EXPECT_EQ(desk.controller.state(), "force");
}

TEST(HapticMasterDriver, TheEndSwitchesTheMachineOff) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.device.reset();
  EXPECT_EQ(desk.world.held_force(), Force{});
  EXPECT_EQ(desk.controller.state(), "off");
  EXPECT_EQ(desk.controller.effects(), 0);
}

TEST(HapticMasterDriver, AFullSocketIsAFaultAndStopsThroughTheGuard) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.controller.refuse_requests(1000);
  desk.device->stop();
  EXPECT_EQ(desk.world.held_force(), Force{});
  EXPECT_EQ(desk.controller.state(), "off");
}

TEST(HapticMasterDriver, AWorkspaceThatCannotBeIsRefused) {
  for (const char* const r :
       {"[0.18,0.6,-0.18]", "[-0.18,0.1,0.18]", "[nan,0.6,0.18]", "true", "--- ERROR: none"}) {
    FakeControllerOptions options;
    options.workspace_r = r;
    Desk desk(options);
    EXPECT_FALSE(desk.open().has_value()) << r;
  }
  Desk desk;
  ASSERT_TRUE(desk.open().has_value());
  const Capabilities& can = desk.device->capabilities();
  EXPECT_NEAR(can.workspace_min.x, -180.0, 1e-6);
  EXPECT_NEAR(can.workspace_max.y, 420.0 * std::sin(0.4), 1e-6);
  EXPECT_LT(can.workspace_max.x, 180.0);
}

TEST(HapticMasterDoctor, SaysWhatIsMissing) {
  Desk desk;
  const auto findings = desk.driver->diagnose(desk.system);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_THAT(said(findings), HasSubstr("State: off"));
  EXPECT_THAT(said(findings), HasSubstr("Nobody has tried this machine"));
  EXPECT_EQ(desk.controller.state(), "off");

  desk.controller.say_instead("--- ERROR: busy", "get state");
  EXPECT_THAT(said(desk.driver->diagnose(desk.system)), HasSubstr("is not a HapticMASTER"));
  desk.controller.options().max_connections = 0;
  EXPECT_THAT(said(desk.driver->diagnose(desk.system)), HasSubstr("could not be reached"));
  desk.system.set_environment(kAddressVariable, "somewhere:x");
  EXPECT_THAT(said(desk.driver->diagnose(desk.system)), HasSubstr("not an address"));
  desk.system.set_environment(kAddressVariable, "");
  const auto absent = desk.driver->diagnose(desk.system);
  ASSERT_EQ(absent.size(), 1u);
  EXPECT_EQ(absent[0].level, FindingLevel::kAbsent);
}

}  // namespace
}  // namespace felt::hapticmaster::hapticmaster_driver_test
