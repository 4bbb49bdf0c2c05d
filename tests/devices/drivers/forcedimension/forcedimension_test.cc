// Tests the driver with a library that has the vendor's names and rules.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <thread>

#include "felt/base/constants.h"
#include "felt/devices/forcedimension/forcedimension.h"
#include "felt/driver/device_models.h"
#include "felt/rt/realtime_thread.h"
#include "tests/devices/drivers/bench_device.h"
#include "tests/devices/drivers/forcedimension_bench.h"

namespace felt::forcedimension_test {
namespace {

using fake_dhd::State;
using ::testing::HasSubstr;

constexpr std::int64_t kTick = 250'000;

/// Runs ticks with a single force. Returns the result of the last write.
tl::expected<void, DeviceFault> run(ForceDimensionBench& bench, std::int64_t from_ns,
                                    std::int64_t until_ns, const Force& force) {
  tl::expected<void, DeviceFault> said;
  for (std::int64_t t = from_ns; t < until_ns; t += kTick) {
    bench.before_tick(t);
    static_cast<void>(bench.device()->read(t));
    said = bench.device()->write(force);
    if (!said) bench.device()->stop();  // as the loop does
  }
  return said;
}

TEST(ForceDimension, FindsWhatIsPluggedInWithItsRowOfTheTable) {
  ForceDimensionBench bench({});
  const DeviceDescriptor found = bench.found();
  EXPECT_EQ(found.id, "forcedimension:" + found.serial);
  EXPECT_EQ(found.label, "Force Dimension omega.3");
  EXPECT_EQ(found.model, "omega.3");
  EXPECT_EQ(found.version, "3.17.5");
  EXPECT_EQ(found.capabilities, find_device_model("omega.3")->capabilities);
  EXPECT_EQ(found.capabilities.period_ns, kTick);
}

TEST(ForceDimension, LookingDoesNotDisturbWhatIsOpen) {
  ForceDimensionBench bench({});
  ASSERT_TRUE(run(bench, 0, 5 * kMs, {0, 0, 1}).has_value());
  const int opens = bench.state().opens;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(bench.driver().find().empty());
  // Another driver in the same program, which has never opened the device, must not close it.
  const auto other = make_forcedimension_driver({.library = FELT_FAKE_LIBDRD, .pen_mass_kg = {}});
  EXPECT_FALSE(other->find().empty());
  EXPECT_EQ(bench.state().opens, opens);
  EXPECT_TRUE(bench.state().is_open);
  EXPECT_EQ(bench.state().mode, State::Mode::kForce);
  EXPECT_EQ(bench.world().held_force().y, -1.0);
  EXPECT_TRUE(run(bench, 5 * kMs, 10 * kMs, {0, 0, 1}).has_value());
  const auto twice = other->open(bench.found(), {});
  ASSERT_FALSE(twice.has_value());
  EXPECT_THAT(twice.error().message, HasSubstr("already open in this program"));
  EXPECT_TRUE(bench.state().is_open);
  EXPECT_EQ(bench.broken_rule(), "");
}

TEST(ForceDimension, WhatAnotherProgramUsesIsListedAndToldInTheLibrarysWords) {
  ForceDimensionBench bench("omega.3", {}, {}, FakeLibrary::kDrd, false);
  bench.state().is_open_elsewhere = true;
  const auto found = bench.driver().find();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].label, HasSubstr("another program"));
  const auto opened = bench.driver().open(found[0], {});
  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().message, HasSubstr("device already in use (error 20)"));
  bench.state().is_open_elsewhere = false;
  for (int i = 0; i < 6; ++i) static_cast<void>(bench.driver().find());
  EXPECT_EQ(bench.found().model, "omega.3") << "it is let go, and seen";
}

TEST(ForceDimension, UnknownTypesAreOpenedWithTheLeastOfForces) {
  ForceDimensionBench bench("generic-3dof", {}, {.type = 128, .name = "prototype"},
                            FakeLibrary::kDrd);
  EXPECT_EQ(bench.device()->descriptor().label, "Force Dimension prototype");
  EXPECT_EQ(bench.device()->descriptor().model, "generic-3dof");
  ASSERT_TRUE(run(bench, 0, 10 * kMs, {0, 0, 50}).has_value());
  EXPECT_NEAR(bench.largest_asked_n(), 2.0, 1e-9);
}

TEST(ForceDimension, OlderDevicesWithoutSerialNumbersAreToldApartByTheirPlace) {
  const fake_dhd::Model falcon{.type = 60, .name = "Falcon", .has_serial = false};
  ForceDimensionBench one("falcon", {}, falcon, FakeLibrary::kDrd, false);
  ForceDimensionBench two("falcon", {}, falcon, FakeLibrary::kDrd, false);
  const auto found = one.driver().find();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].id, "forcedimension:falcon");
  EXPECT_EQ(found[1].id, "forcedimension:falcon-2");
}

TEST(ForceDimension, IsSetUpAsTheManualAsks) {
  ForceDimensionBench bench({});
  EXPECT_TRUE(bench.state().gravity);
  EXPECT_EQ(bench.state().watchdog, 248) << "31 ms in steps of 125 us";
  EXPECT_EQ(bench.state().effector_kg, 0.2) << "the maker's, when nobody says";
  EXPECT_EQ(bench.state().mode, State::Mode::kBrake) << "until the loop runs";
  EXPECT_EQ(bench.device()->status().notice.view(), "");
  EXPECT_NEAR(bench.device()->status().rate_hz, 3900.0, 1e-9);
  EXPECT_EQ(bench.broken_rule(), "");
}

TEST(ForceDimension, APensMassIsHandedOn) {
  ForceDimensionBench bench("omega.3", {}, {}, FakeLibrary::kDrd, false);
  const auto driver =
      make_forcedimension_driver({.library = FELT_FAKE_LIBDRD, .pen_mass_kg = 0.035});
  const auto device = driver->open(bench.found(), {});
  ASSERT_TRUE(device.has_value());
  EXPECT_EQ(bench.state().effector_kg, 0.035);
}

TEST(ForceDimension, FirmwareWithoutWatchdogIsANote) {
  ForceDimensionBench bench("omega.3", {}, {.has_watchdog = false}, FakeLibrary::kDrd);
  EXPECT_THAT(std::string(bench.device()->status().notice.view()), HasSubstr("no watchdog"));
  EXPECT_TRUE(run(bench, 0, 5 * kMs, {0, 0, 1}).has_value()) << "and no reason to refuse";
}

TEST(ForceDimension, PlacesAreInMillimetresAndTheOldAnswerIsNoError) {
  ForceDimensionBench bench({});
  bench.world().stylus().place({70, 50, 20});
  bench.before_tick(0);
  const auto first = bench.device()->read(0);
  ASSERT_TRUE(first.has_value());
  EXPECT_NEAR(first->position.x, 20.0, 0.02);  // towards the user
  EXPECT_NEAR(first->position.y, 0.0, 0.02);
  EXPECT_NEAR(first->position.z, 20.0, 0.02);  // up
  const auto again = bench.device()->read(0);  // too soon: the time guard
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->position, first->position);
  EXPECT_EQ(bench.device()->status().faults, 0U);
}

TEST(ForceDimension, MotorsThatGiveAllTheyCanAreNoError) {
  ForceDimensionBench bench("omega.3", {}, {.saturates_above_n = 0.5}, FakeLibrary::kDrd);
  EXPECT_TRUE(run(bench, 0, 5 * kMs, {0, 0, 2}).has_value());
  EXPECT_EQ(bench.device()->status().faults, 0U);
}

TEST(ForceDimension, ForcesAreBoundByTheRowAndNumbersAreNumbers) {
  ForceDimensionBench bench({});
  ASSERT_TRUE(run(bench, 0, 30 * kMs, {1e300, -1e300, 1e300}).has_value());
  EXPECT_NEAR(bench.largest_asked_n(), 6.0, 1e-9);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto said = run(bench, 30 * kMs, 30 * kMs + kTick, {0, nan, 0});
  ASSERT_FALSE(said.has_value());
  EXPECT_EQ(said.error(), DeviceFault::kBadData);
  EXPECT_EQ(bench.world().held_force(), Force{});
  EXPECT_NEAR(bench.largest_asked_n(), 6.0, 1e-9);
  EXPECT_EQ(bench.broken_rule(), "");
}

TEST(ForceDimension, GripperAndWristAreToldToRest) {
  ForceDimensionBench omega({});
  ASSERT_TRUE(run(omega, 0, kMs, {0, 0, 1}).has_value());
  EXPECT_TRUE(std::isnan(omega.state().gripper_n)) << "it has none";
  ForceDimensionBench sigma("sigma.7", {}, {.type = 104, .name = "sigma.7"}, FakeLibrary::kDrd);
  sigma.state().torque_nm = {9, 9, 9};
  ASSERT_TRUE(run(sigma, 0, kMs, {0, 0, 1}).has_value());
  EXPECT_EQ(sigma.state().gripper_n, 0.0);
  EXPECT_EQ(sigma.state().torque_nm, (std::array<double, 3>{}));
}

TEST(ForceDimension, TheSecondButtonOfOneOmegaIsItsFirst) {
  for (const int type : {33, 110}) {
    ForceDimensionBench bench("omega.3", {}, {.type = type}, FakeLibrary::kDrd);
    bench.hand().aim({50, 50, 5}, {}, 2U);
    bench.before_tick(0);
    bench.before_tick(kTick);
    const auto sample = bench.device()->read(kTick);
    ASSERT_TRUE(sample.has_value());
    EXPECT_EQ(sample->buttons, type == 110 ? 3U : 2U);
  }
}

TEST(ForceDimension, TheForceButtonIsThePersonsAlone) {
  ForceDimensionBench bench({});
  ASSERT_TRUE(run(bench, 0, 5 * kMs, {0, 0, 1}).has_value());
  bench.fake().press_force_button(bench.number());
  EXPECT_EQ(bench.world().held_force(), Force{});
  auto said = run(bench, 5 * kMs, 6 * kMs, {0, 0, 1});
  ASSERT_FALSE(said.has_value());
  EXPECT_EQ(said.error(), DeviceFault::kForcesOff);
  EXPECT_TRUE(bench.device()->read(6 * kMs).has_value()) << "it is still read";
  const DeviceStatus status = bench.device()->status();
  EXPECT_EQ(status.fault, DeviceFault::kForcesOff);
  EXPECT_THAT(std::string(status.vendor_words.view()), HasSubstr("force button"));
  EXPECT_EQ(status.vendor_code, 1);

  said = run(bench, 6 * kMs, 3000 * kMs, {});
  EXPECT_FALSE(said.has_value()) << "however long it is asked for nothing";
  EXPECT_EQ(bench.state().enables, 1);

  bench.fake().press_force_button(bench.number());
  EXPECT_EQ(bench.world().held_force(), Force{}) << "pressed again it holds nothing old";
  EXPECT_TRUE(run(bench, 3000 * kMs, 3002 * kMs, {}).has_value());
  EXPECT_TRUE(run(bench, 3002 * kMs, 3007 * kMs, {0, 0, 1}).has_value());
  EXPECT_EQ(bench.world().held_force().y, -1.0);
  EXPECT_FALSE(bench.device()->status().fault.has_value());
  EXPECT_EQ(bench.broken_rule(), "");
}

TEST(ForceDimension, AProgramThatHangsIsStoppedByTheWatchdogWithin32Ms) {
  ForceDimensionBench bench({});
  ASSERT_TRUE(run(bench, 0, 5 * kMs, {0, 0, 1}).has_value());
  bench.before_tick(30 * kMs);
  EXPECT_NE(bench.world().held_force(), Force{});
  bench.before_tick(37 * kMs);
  EXPECT_EQ(bench.world().held_force(), Force{});
  EXPECT_EQ(bench.state().mode, State::Mode::kBrake);
  EXPECT_EQ(bench.state().cause, 3);
  // The program resumes late and pushes immediately, which is refused.
  auto said = run(bench, 40 * kMs, 41 * kMs, {0, 0, 1});
  ASSERT_FALSE(said.has_value());
  EXPECT_EQ(said.error(), DeviceFault::kForcesOff);
  EXPECT_EQ(bench.world().held_force(), Force{});
  // As in the safety chain, the force starts at zero.
  EXPECT_TRUE(run(bench, 41 * kMs, 42 * kMs, {}).has_value());
  EXPECT_TRUE(run(bench, 42 * kMs, 43 * kMs, {0, 0, 0.1}).has_value());
  EXPECT_EQ(bench.state().mode, State::Mode::kForce);
  EXPECT_EQ(bench.broken_rule(), "");
}

TEST(ForceDimension, AfterTheSpeedGuardItRestsHalfASecond) {
  ForceDimensionBench bench("omega.3", {}, {.guard_m_per_s = 0.2}, FakeLibrary::kDrd);
  bench.world().stylus().hold({});
  bench.world().stylus().place({70, 70, -30});
  std::int64_t t = 0;
  for (; bench.state().mode != State::Mode::kBrake || t == 0; t += kTick) {
    ASSERT_TRUE(run(bench, t, t + kTick, {3, 0, 0}).has_value() || t > 0);
    ASSERT_LT(t, 500 * kMs) << "it is never fast";
  }
  EXPECT_EQ(bench.state().cause, 2);
  bench.world().stylus().place({70, 70, 0});
  EXPECT_FALSE(run(bench, t, t + 400 * kMs, {}).has_value());
  EXPECT_EQ(bench.state().enables, 1);
  EXPECT_TRUE(run(bench, t + 400 * kMs, t + 700 * kMs, {}).has_value());
  EXPECT_EQ(bench.state().enables, 2);
  EXPECT_EQ(bench.broken_rule(), "");
}

TEST(ForceDimension, StopWorksInAnyStateAndBrakes) {
  ForceDimensionBench bench({});
  bench.device()->stop();  // before the first tick
  ASSERT_TRUE(run(bench, 0, 5 * kMs, {0, 0, 1}).has_value());
  bench.device()->stop();
  EXPECT_EQ(bench.world().held_force(), Force{});
  EXPECT_EQ(bench.state().mode, State::Mode::kBrake);
  bench.device()->stop();
  EXPECT_TRUE(run(bench, 5 * kMs, 10 * kMs, {0, 0, 1}).has_value()) << "and goes on when asked";
  EXPECT_EQ(bench.world().held_force().y, -1.0);
  bench.close();
  EXPECT_EQ(bench.world().held_force(), Force{});
  EXPECT_FALSE(bench.state().is_open);
  EXPECT_EQ(bench.broken_rule(), "");
}

TEST(ForceDimension, AWriteThatFailsEndsNoReading) {
  ForceDimensionBench bench({{InjectedFault::kWriteError, 5 * kMs, 6 * kMs}});
  ASSERT_TRUE(run(bench, 0, 5 * kMs, {0, 0, 1}).has_value());
  auto said = run(bench, 5 * kMs, 5 * kMs + kTick, {0, 0, 1});
  ASSERT_FALSE(said.has_value());
  EXPECT_EQ(said.error(), DeviceFault::kDisconnected);
  EXPECT_EQ(bench.world().held_force(), Force{}) << "stop() has braked";
  EXPECT_THAT(std::string(bench.device()->status().vendor_words.view()),
              HasSubstr("communication error"));
  EXPECT_EQ(bench.device()->status().vendor_code, 2);
  run(bench, 5 * kMs + kTick, 6 * kMs, {});
  EXPECT_TRUE(bench.device()->read(6 * kMs).has_value());
  EXPECT_TRUE(run(bench, 60 * kMs, 61 * kMs, {0, 0, 1}).has_value());
  EXPECT_FALSE(bench.device()->status().fault.has_value());
  EXPECT_EQ(bench.broken_rule(), "");
}

TEST(ForceDimension, UnpluggedIsGoneForEverUntilOpenedAnew) {
  ForceDimensionBench bench({{InjectedFault::kUnplugged, 5 * kMs, 20 * kMs}});
  ASSERT_TRUE(run(bench, 0, 5 * kMs, {0, 0, 1}).has_value());
  bench.before_tick(5 * kMs);
  EXPECT_EQ(bench.world().held_force(), Force{});
  for (const std::int64_t t : {5 * kMs, 10 * kMs, 30 * kMs}) {
    bench.before_tick(t);
    const auto sample = bench.device()->read(t);
    ASSERT_FALSE(sample.has_value());
    EXPECT_EQ(sample.error(), DeviceFault::kDisconnected);
    if (t == 10 * kMs) {
      EXPECT_TRUE(bench.found().id.empty()) << "nor is it in the list";
    }
  }
  ASSERT_TRUE(bench.reconnect().has_value());
  EXPECT_TRUE(run(bench, 30 * kMs, 31 * kMs, {0, 0, 1}).has_value());
  EXPECT_EQ(bench.broken_rule(), "");
}

TEST(ForceDimension, WhoIsPluggedInInItsPlaceIsNotTakenForIt) {
  auto one = std::make_unique<ForceDimensionBench>("omega.3", std::vector<FaultWindow>{},
                                                   fake_dhd::Model{}, FakeLibrary::kDrd, false);
  ForceDimensionBench two("delta.3", {}, {.type = 63, .name = "delta.3"}, FakeLibrary::kDrd, false);
  const DeviceDescriptor was = one->found();
  one.reset();
  const auto opened = two.driver().open(was, {});
  ASSERT_FALSE(opened.has_value());
  EXPECT_EQ(opened.error().code, ErrorCode::kNotFound);
  EXPECT_FALSE(two.state().is_open);
}

TEST(ForceDimension, TheSmallerLibraryDrivesToo) {
  ForceDimensionBench bench("delta.3", {}, {.type = 63, .name = "delta.3"}, FakeLibrary::kDhd);
  EXPECT_EQ(bench.device()->descriptor().model, "delta.3");
  EXPECT_TRUE(run(bench, 0, 5 * kMs, {0, 0, 1}).has_value());
  EXPECT_EQ(bench.broken_rule(), "");
}

TEST(ForceDimension, WithoutALibraryThereIsNothingAndOpenSaysWhy) {
  const auto driver =
      make_forcedimension_driver({.library = "/no/such/libdrd.so", .pen_mass_kg = {}});
  EXPECT_TRUE(driver->find().empty());
  DeviceDescriptor any;
  any.id = "forcedimension:1";
  const auto opened = driver->open(any, {});
  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().message, HasSubstr("cannot open shared object file"));
}

TEST(ForceDimension, TheEnvironmentNamesTheLibrary) {
  ForceDimensionBench bench("omega.3", {}, {}, FakeLibrary::kDrd, false);
  ASSERT_EQ(setenv("FELT_FORCEDIMENSION_LIBRARY", FELT_FAKE_LIBDRD, 1), 0);
  const auto driver = make_forcedimension_driver();
  EXPECT_EQ(driver->find().size(), 1U);
  ASSERT_EQ(unsetenv("FELT_FORCEDIMENSION_LIBRARY"), 0);
}

// Uses a real thread and clock, while another thread reads the list of devices.
TEST(ForceDimension, RunsOnAThreadInRealTime) {
  ForceDimensionBench bench({});
  BenchDevice device(bench);
  Servo servo(device, {.period_ns = kMs, .limits = limits_for(device.capabilities())});
  RealtimeThread loop(servo, {.fifo_priority = 0, .lock_memory = false});
  ASSERT_TRUE(loop.start().has_value());
  servo.arm();
  std::uint64_t seen = 0;
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(8);
  while (seen < 200 && std::chrono::steady_clock::now() < give_up) {
    servo.heartbeat(loop.now_ns());
    static_cast<void>(bench.driver().find());
    PenSample sample;
    while (servo.for_edit().pop(sample)) ++seen;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  const DeviceStatus status = bench.device()->status();
  EXPECT_TRUE(loop.stop());
  EXPECT_GE(seen, 200U);
  EXPECT_GT(status.reads, 0U);
  EXPECT_EQ(bench.world().held_force(), Force{});
  EXPECT_EQ(bench.state().mode, State::Mode::kBrake);
  EXPECT_EQ(bench.broken_rule(), "");
}

}  // namespace
}  // namespace felt::forcedimension_test
