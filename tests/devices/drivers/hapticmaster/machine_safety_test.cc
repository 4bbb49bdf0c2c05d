// Tests when the machine is switched off, and that the trials of the guard prove something.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "tests/devices/drivers/hapticmaster/desk.h"

namespace felt::hapticmaster::machine_safety_test {
namespace {

using ::testing::HasSubstr;

constexpr std::int64_t kNeverNs = 3600 * kSecond;
constexpr int kOften = 1 << 20;

/// Returns the time from now until the machine is off, or a long time.
std::int64_t off_after_ns(Desk& desk, const Force& force, std::int64_t tick_ns = kTickNs) {
  const std::int64_t begin_ns = desk.now_ns;
  while (!desk.is_off() && desk.now_ns < begin_ns + 5 * kSecond) desk.tick(force, tick_ns);
  return desk.now_ns - begin_ns;
}

std::string words_of(Desk& desk) {
  return std::string(desk.device->status().vendor_words.view());
}

TEST(HapticMasterSafety, R49_AnUnansweredReleaseSwitchesTheMachineOff) {
  for (const Force force : {Force{1, 0, 0}, Force{}}) {
    Desk desk;
    ASSERT_TRUE(desk.open_at_home());
    desk.push({1, 0, 0});
    ASSERT_GT(desk.held_n(), 0.9);
    desk.controller.stall();
    // A force is held for 16 ms before it is to be zero (ServicePace).
    const std::int64_t hold_ns = force == Force{} ? 0 : ServicePace::kHoldNs;
    EXPECT_LE(off_after_ns(desk, force), hold_ns + 50 * kMs + 3 * kTickNs);
    const auto ticked = desk.tick(force);
    ASSERT_FALSE(ticked.read || ticked.written);
    EXPECT_EQ(ticked.read.error(), DeviceFault::kNotCalibrated);
    EXPECT_EQ(ticked.written.error(), DeviceFault::kNotCalibrated);
    EXPECT_THAT(words_of(desk), HasSubstr("ended the force"));
    EXPECT_EQ(desk.device->homing(), Homing::kByItself) << "the user must agree again";
  }
}

TEST(HapticMasterSafety, R49_AReleaseThatCannotBeSentSwitchesTheMachineOff) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.controller.refuse_requests(kOften);
  EXPECT_LE(off_after_ns(desk, {}), 50 * kMs + 3 * kTickNs);
}

// A slow computer runs few ticks. The limits must not grow with them.
TEST(HapticMasterSafety, R49_TheLimitsCountTheTimeAndNotTheTicks) {
  for (const std::int64_t tick_ns : {4 * kMs, 13 * kMs, 24 * kMs, 45 * kMs}) {
    Desk desk;
    ASSERT_TRUE(desk.open_at_home());
    while (desk.now_ns < kSecond) desk.tick({1, 0, 0}, tick_ns);
    desk.controller.stall();
    EXPECT_LE(off_after_ns(desk, {1, 0, 0}, tick_ns),
              ServicePace::kHoldNs + 50 * kMs + 3 * tick_ns);
  }
}

TEST(HapticMasterSafety, R49_PositionsThatStayImpossibleSwitchTheMachineOff) {
  struct Case {
    const char *request, *answer;
  };
  for (const auto& [request, answer] :
       {Case{"get measpos", "[nan,0,0]"}, Case{"get measpos", "[0,inf,0]"},
        Case{"get measpos", "[0.9,0,0]"}, Case{"get measpos", "[0,0,-1e300]"},
        Case{"get measpos", "[0.05,0,0]"}, Case{"get measpos", "[,,]"},
        Case{"get measpos", "--- ERROR: no"}, Case{"get modelvel", "[nan,0,0]"},
        Case{"get modelvel", "--- ERROR: no"}, Case{"get modelvel", "[200,0,0]"}}) {
    Desk desk;
    desk.world.stylus().aim({0, 0, 0}, {}, 0);
    desk.world.stylus().place({0, 0, 0});
    ASSERT_TRUE(desk.open_at_home());
    desk.push({1, 0, 0});
    desk.controller.say_instead(answer, request, 5);
    for (int i = 0; i < 5; ++i) EXPECT_FALSE(desk.tick().read.has_value()) << answer;
    EXPECT_TRUE(desk.tick().read.has_value()) << "20 ms are forgiven: " << request << answer;
    for (int i = 0; i < 100; ++i) desk.tick();
    EXPECT_EQ(desk.controller.state(), "force");
    desk.controller.say_instead(answer, request, kOften);
    EXPECT_LE(off_after_ns(desk, {}), 20 * kMs + 2 * kTickNs) << request << answer;
    EXPECT_EQ(desk.tick().read.error(), DeviceFault::kNotCalibrated);
  }
}

// After a fault, the loop calls stop() in each tick, and each release is confirmed.
TEST(HapticMasterSafety, R49_StopsDoNotStopTheTime) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.controller.say_instead("[nan,0,0]", "get measpos", kOften);
  for (int i = 0; i < 8; ++i) {
    EXPECT_FALSE(desk.tick().read.has_value());
    desk.device->stop();
  }
  EXPECT_TRUE(desk.is_off());
}

// The handle is moved with 100 mm/s, while a coordinate or everything stands.
TEST(HapticMasterSafety, R49_APositionThatFreezesWhileTheHandMovesSwitchesTheMachineOff) {
  for (const InjectedFault fault : {InjectedFault::kStuckAxis, InjectedFault::kFrozen}) {
    const std::int64_t from_ns = 600 * kMs;
    Desk desk({}, {{fault, from_ns, kNeverNs, 1.0}});
    ASSERT_TRUE(desk.open_at_home());
    const auto move = [&desk] {
      desk.world.stylus().aim({0, 0, 1e-7 * static_cast<double>(desk.now_ns)}, {}, 0);
    };
    desk.world.stylus().place({0, 0, 0});
    while (desk.now_ns < from_ns) {
      move();
      EXPECT_TRUE(desk.tick().read.has_value());
    }
    while (!desk.is_off() && desk.now_ns < from_ns + 5 * kSecond) {
      move();
      desk.tick();
    }
    EXPECT_LE(desk.now_ns - from_ns, 200 * kMs);
    EXPECT_THAT(words_of(desk), HasSubstr("does not follow the velocity"));
  }
}

TEST(HapticMasterSafety, AHandThatRestsIsNoFault) {
  Desk desk({}, {{InjectedFault::kFrozen, 500 * kMs, kNeverNs, 1.0}});
  desk.world.stylus().aim({0, 0, 5}, {}, 0);
  desk.world.stylus().place({0, 0, 5});
  ASSERT_TRUE(desk.open_at_home());
  for (int i = 0; i < 5000; ++i) EXPECT_TRUE(desk.tick().read.has_value());
}

// Each of these lies to the trial: the guard never acts, and something else looks as if it had.
TEST(HapticMasterSafety, R49_OnlyAGuardThatActsPassesItsTrial) {
  struct Case {
    const char* name;
    FakeControllerOptions options;
    const char* request;
    int count, skip;
  };
  const FakeControllerOptions off{
      .ignores_guard = true, .gives_up_force = true, .creates_twice = true};
  FakeControllerOptions keeps;
  keeps.keeps_effects = true;
  for (const auto& [name, options, request, count, skip] :
       {Case{"errors for another reason", off, "set felt", 2, 0},
        Case{"errors after the first look", off, "set felt", 1, 1},
        Case{"errors after the second look", off, "set felt", 1, 2},
        Case{"the machine is off by itself", off, "get nothing", 1, 0},
        Case{"effects that stay", keeps, "get nothing", 1, 0}}) {
    Desk desk(options);
    ASSERT_TRUE(desk.open().has_value());
    desk.controller.say_instead("--- ERROR: busy", request, count, skip);
    const auto home = desk.device->find_home();
    ASSERT_FALSE(home.has_value()) << name;
    for (int i = 0; i < 5; ++i) desk.tick({1, 0, 0});
    EXPECT_EQ(desk.controller.state(), "off") << name;
    EXPECT_EQ(desk.world.held_force(), Force{}) << name;
    EXPECT_EQ(desk.controller.broken_rule(), "") << name;
  }
}

// A late answer says where the pen was, and when.
TEST(HapticMasterSafety, R49_AnOldPositionCarriesItsTime) {
  const std::int64_t from_ns = 600 * kMs, until_ns = 630 * kMs;
  Desk desk({}, {{InjectedFault::kNoAnswer, from_ns, until_ns, 1.0}});
  ASSERT_TRUE(desk.open_at_home());
  desk.world.stylus().place({0, 0, 0});
  std::int64_t last_ns = -1;
  bool was_old = false;
  while (desk.now_ns < kSecond) {
    desk.world.stylus().aim({0, 0, 5e-8 * static_cast<double>(desk.now_ns)}, {}, 0);
    const std::int64_t now_ns = desk.now_ns;
    const auto read = desk.tick().read;
    if (!read) continue;
    EXPECT_GE(read->time_ns, last_ns) << "time does not go back";
    const bool is_new = read->time_ns != last_ns;
    last_ns = read->time_ns;
    if (is_new && now_ns >= until_ns && !was_old) {
      was_old = true;
      EXPECT_LT(read->time_ns, from_ns + 2 * kTickNs) << "it was asked for before";
      continue;
    }
    EXPECT_TRUE(!is_new || read->time_ns == now_ns) << "extrapolated to now";
  }
  EXPECT_TRUE(was_old);
}

TEST(HapticMasterSafety, R49_TheSearchForTheEndStopsIsNotAwaitedForEver) {
  struct Case {
    const char* position;
    std::int64_t seconds;
  };
  for (const auto& [position, seconds] :
       {Case{"[0.0,0.0,0.0]", 10}, Case{"--- ERROR: position is not calibrated", 10}}) {
    Desk desk({.is_position_calibrated = false, .init_looks = kOften});
    ASSERT_TRUE(desk.open().has_value());
    desk.controller.say_instead(position, "get measpos", kOften);
    const auto home = desk.device->find_home();
    ASSERT_FALSE(home.has_value());
    EXPECT_THAT(home.error().message, HasSubstr("end stops"));
    EXPECT_LE(desk.controller.requests(), seconds * 50 * 3 + 100) << "three requests in 20 ms";
    EXPECT_EQ(desk.controller.state(), "off");
  }
  Desk slow({.is_position_calibrated = false, .init_looks = 400});
  EXPECT_TRUE(slow.open_at_home()) << "8 s";
}

TEST(HapticMasterSafety, R49_ASearchWhoseStateIsRefusedEndsAtOnce) {
  Desk desk({.is_position_calibrated = false, .init_looks = kOften});
  ASSERT_TRUE(desk.open().has_value());
  desk.controller.say_instead("--- ERROR: busy", "get state", kOften, 3);  // after the trial
  EXPECT_FALSE(desk.device->find_home().has_value());
  EXPECT_LE(desk.controller.requests(), 100);
  EXPECT_EQ(desk.controller.state(), "off");
}

// The machine confirms the request, but stays on, and its guard cannot reach it.
TEST(HapticMasterSafety, R49_TheRequestToSwitchOffIsRepeated) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.controller.options().ignores_guard = true;
  desk.controller.options().ignored_offs = 3;
  desk.controller.hang_up_guard();
  EXPECT_EQ(desk.first_fault(1), DeviceFault::kNotCalibrated);
  ASSERT_EQ(desk.controller.state(), "force");
  EXPECT_EQ(desk.world.held_force(), Force{});
  for (int i = 0; i < 60; ++i) static_cast<void>(desk.tick({1, 0, 0}));
  EXPECT_EQ(desk.controller.state(), "off");
  EXPECT_THAT(desk.device->status().vendor_words.view(), HasSubstr("does not run"));
  const int requests = desk.controller.requests();
  for (int i = 0; i < 60; ++i) static_cast<void>(desk.tick({1, 0, 0}));
  EXPECT_EQ(desk.controller.requests(), requests) << "it is off";
  EXPECT_EQ(desk.controller.broken_rule(), "");
}

TEST(HapticMasterSafety, R49_TheUserIsToldIfTheMachineDoesNotConfirmThatItIsOff) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.controller.options().ignored_offs = kOften;
  desk.controller.hang_up_guard();
  for (int i = 0; i < 150; ++i) static_cast<void>(desk.tick());
  EXPECT_THAT(desk.device->status().vendor_words.view(), HasSubstr("emergency button"));
  desk.controller.options().ignored_offs = 0;
  for (int i = 0; i < 30; ++i) static_cast<void>(desk.tick());
  EXPECT_EQ(desk.controller.state(), "off");
  EXPECT_THAT(desk.device->status().vendor_words.view(), HasSubstr("does not run"));
}

// Also when the device is closed at once, and when it could not be prepared.
TEST(HapticMasterSafety, R49_ClosingItRepeatsTheRequestToSwitchOff) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.controller.options().ignored_offs = 5;
  desk.device.reset();
  EXPECT_TRUE(desk.is_off());
  EXPECT_EQ(desk.controller.broken_rule(), "");
}

TEST(HapticMasterSafety, R49_AMachineThatCouldNotBePreparedIsOffOrTheUserIsTold) {
  for (const bool obeys : {true, false}) {
    Desk desk({.is_position_calibrated = false, .init_looks = kOften});
    ASSERT_TRUE(desk.open().has_value());
    desk.controller.say_instead("--- ERROR: no position", "get measpos", kOften);
    desk.controller.options().ignored_offs_in_init = obeys ? 6 : kOften;
    const auto home = desk.device->find_home();
    ASSERT_FALSE(home.has_value());
    EXPECT_EQ(desk.controller.state() == "off", obeys);
    EXPECT_THAT(home.error().message, HasSubstr("end stops"));
    EXPECT_EQ(home.error().message.find("press its emergency button") == std::string::npos, obeys);
  }
}

TEST(HapticMasterSafety, R49_AFrozenPositionIsNoticedThoughTheClockStandsStill) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  for (int i = 0; i < 20; ++i) static_cast<void>(desk.tick());
  desk.world.stylus().place({0, 0, 0});
  desk.controller.say_instead("[0.0,0.1,0.0]", "get modelvel", kOften);
  std::optional<DeviceFault> fault;
  for (int i = 0; i < 200 && fault != DeviceFault::kNotCalibrated; ++i) {
    if (const auto read = desk.tick({}, 0).read; !read) fault = read.error();
  }
  EXPECT_EQ(fault, DeviceFault::kNotCalibrated);
  EXPECT_EQ(desk.controller.state(), "off");
}

TEST(HapticMasterSafety, R49_AfterAStopWithoutConfirmationTheGuardActsWithoutTicks) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.controller.stall();
  desk.device->stop();
  ASSERT_GT(desk.held_n(), 0.9) << "the release has not arrived";
  desk.controller.tick(desk.now_ns + HapticMasterDevice::kGuardNs);
  EXPECT_TRUE(desk.is_off());
}

TEST(HapticMasterSafety, AfterAConfirmedStopTheMachineStaysReady) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  desk.push({1, 0, 0});
  desk.device->stop();
  EXPECT_EQ(desk.held_n(), 0.0);
  desk.controller.tick(desk.now_ns + 60 * kSecond);
  EXPECT_EQ(desk.controller.state(), "force");
}

// Another program takes the machine. The commands of the first must not change the other's force.
TEST(HapticMasterSafety, R49_TwoProgramsDoNotShareAnEffect) {
  for (const bool is_resting : {false, true}) {
    Desk first;
    ASSERT_TRUE(first.open_at_home());
    first.push({1, 0, 0});
    if (is_resting) first.device->stop();
    auto other = first.driver->open(first.driver->find().at(0), {});
    ASSERT_TRUE(other.has_value());
    ASSERT_TRUE((*other)->find_home().has_value());
    EXPECT_EQ(first.held_n(), 0.0) << "a new effect begins without a force";
    for (int i = 0; i < 10; ++i) {
      first.tick({0, 3, 0});
      EXPECT_EQ(first.held_n(), 0.0);
    }
    EXPECT_TRUE(first.is_off()) << "nobody has the machine until a user agrees";
    static_cast<void>((*other)->read(first.now_ns));  // it asks for the state in the next tick
    EXPECT_FALSE((*other)->read(first.now_ns + kTickNs).has_value());
  }
}

// Another program has crashed and left its effect behind.
TEST(HapticMasterSafety, R49_AnEffectThatWasLeftBehindIsRemoved) {
  Desk desk;
  auto stream = desk.controller.connect("192.168.0.25", 7654);
  ASSERT_TRUE(stream.has_value());
  {
    ControllerLink link(*std::move(stream));
    for (const char* const text :
         {"create biasforce feltforce", "set feltforce force [2.0,0.0,0.0]", "set state force",
          "set feltforce enable"}) {
      ASSERT_TRUE(ask_controller(link, text).has_value()) << text;
    }
  }
  ASSERT_GT(desk.held_n(), 1.9);
  ASSERT_TRUE(desk.open_at_home());
  EXPECT_EQ(desk.controller.effects(), 1);
  desk.push({});
  EXPECT_EQ(desk.held_n(), 0.0);
}

// Without friction, the smallest error of the force sensor would move the machine.
TEST(HapticMasterSafety, R49_TheVirtualMassHasFriction) {
  Desk desk;
  ASSERT_TRUE(desk.open_at_home());
  EXPECT_EQ(desk.controller.friction_n(), HapticMasterDevice::kFrictionN);
  EXPECT_GE(desk.controller.friction_n(), 0.3);
}

}  // namespace
}  // namespace felt::hapticmaster::machine_safety_test
