// Tests the parts that are specific to OpenHaptics, with the driver's real code and a libHD of our
// own: names and identity, frames, the error stack, switches, warm motors, homing, the scheduler as
// host.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <thread>

#include "felt/base/constants.h"
#include "felt/devices/openhaptics/hd_abi.h"
#include "felt/devices/openhaptics/openhaptics_driver.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/document/visible_strokes.h"
#include "felt/driver/device_models.h"
#include "felt/driver/open_device.h"
#include "felt/geometry/tilt.h"
#include "felt/rt/realtime_thread.h"
#include "felt/rt/servo.h"
#include "felt/session/session.h"
#include "tests/devices/drivers/fake_world.h"
#include "tests/devices/drivers/ink_difference.h"
#include "tests/devices/drivers/openhaptics/fake_slots.h"
#include "tests/devices/drivers/openhaptics/hd_world.h"

namespace felt::openhaptics_test {
namespace {

using ::testing::HasSubstr;

class OpenHaptics : public ::testing::Test {
 protected:
  OpenHaptics() { plug_in(); }

  void plug_in() {
    const FakeHdWorld behind = world.world();
    fake->plug_in(&model, &behind);
  }
  Result<std::unique_ptr<DriverDevice>> try_open(std::string id = "openhaptics:default") {
    DeviceDescriptor wanted;
    wanted.id = std::move(id);
    return driver->open(wanted, {});
  }
  void open() {
    auto opened = try_open();
    ASSERT_TRUE(opened.has_value()) << opened.error().message;
    device = *std::move(opened);
  }
  // Makes the loop call `in_tick` at each step().
  void start() {
    open();
    ASSERT_TRUE(
        device->loop_host()
            ->start_loop([](void* self) noexcept { static_cast<OpenHaptics*>(self)->tick(); }, this)
            .has_value());
  }
  void tick() noexcept { in_tick(); }
  void step(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) {
      now_ns += kMs;
      fake->step(now_ns);
    }
  }
  void read_and_write() {
    said = device->read(now_ns);
    done = device->write(force);
  }
  // Returns the held force in the frame of the surface.
  [[nodiscard]] const Force& held() const { return motors.held_force(); }
  void TearDown() override {
    device.reset();
    EXPECT_STREQ(fake->broken_rule(), "");
    EXPECT_EQ(fake->open_devices(), 0);
    EXPECT_EQ(fake->callbacks(), 0);
    EXPECT_EQ(held(), Force{});
  }

  FakeSlot fake;
  FakeWorld motors{*find_stylus_preset("touch")};
  SimulatedStylus& stylus = motors.stylus();
  HdWorld world{motors.device(), hd_plane(stylus.capabilities())};
  FakeHdModel model = hd_model(stylus.capabilities(), world.plane(), "Touch");
  std::unique_ptr<Driver> driver =
      make_openhaptics_driver({.library = fake.path(), .device = "Ours"});
  std::unique_ptr<DriverDevice> device;
  std::int64_t now_ns = 0;
  std::function<void()> in_tick = [this] { read_and_write(); };
  Force force;
  tl::expected<PenSample, DeviceFault> said = tl::unexpected(DeviceFault::kOther);
  tl::expected<void, DeviceFault> done;
};

// ------------------------------------------------------------------------------------ opening

TEST_F(OpenHaptics, IsFoundWhereItsLibraryIs) {
  const auto found = driver->find();
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].id, "openhaptics:default");
  EXPECT_TRUE(found[0].has_own_frame);
  EXPECT_EQ(fake->open_devices(), 0) << "looking opens nothing";
  EXPECT_TRUE(
      make_openhaptics_driver({.library = "/nowhere/libHD.so", .device = {}})->find().empty());
}

TEST_F(OpenHaptics, SaysWhatItIs) {
  open();
  const DeviceDescriptor& said_to_be = device->descriptor();
  EXPECT_EQ(said_to_be.label, "3D Systems Touch");
  EXPECT_EQ(said_to_be.model, "touch");
  EXPECT_EQ(said_to_be.serial, "FAKE-0001");
  EXPECT_EQ(said_to_be.version, "fake 3.4");
  EXPECT_EQ(device->capabilities().workspace_max.x - device->capabilities().workspace_min.x, 160.0);
  EXPECT_TRUE(driver->find()[0].is_connected) << "since it is open";
  device.reset();
  EXPECT_EQ(driver->find()[0].serial, "FAKE-0001") << "remembered";
}

TEST_F(OpenHaptics, OfRowAndDeviceTheLesserCounts) {
  model.max_force_n = 2.0;
  model.continuous_force_n = 5.0;
  plug_in();
  open();
  EXPECT_EQ(device->capabilities().max_force_n, 2.0);
  EXPECT_EQ(device->capabilities().continuous_force_n,
            find_device_model("touch")->capabilities.continuous_force_n);
}

TEST_F(OpenHaptics, AModelThatNobodyKnowsIsTheWeakestAndKeepsItsName) {
  model.type = "Touch\x01 of 2031";
  model.max_force_n = 300.0;
  plug_in();
  open();
  EXPECT_EQ(device->descriptor().model, "touch");
  device.reset();
  model.type = "Phantom of the Opera";
  plug_in();
  open();
  EXPECT_EQ(device->descriptor().model, "generic-3dof");
  EXPECT_EQ(device->descriptor().label, "Phantom of the Opera");
  EXPECT_EQ(device->capabilities().max_force_n, generic_device_model().capabilities.max_force_n);
}

TEST_F(OpenHaptics, TriesTheNamesThatDriversUse) {
  model.opens_without_name = 0;
  for (const char* name : {"Default PHANToM", "Default Device", "Ours"}) {
    model.name = name;
    plug_in();
    open();
    EXPECT_NE(device, nullptr) << name;
    device.reset();
  }
  model.name = "Left";
  plug_in();
  EXPECT_TRUE(try_open("openhaptics:Left").has_value());
  const auto opened = try_open();
  ASSERT_FALSE(opened.has_value());
  for (const char* words : {"the first device: Fake: device fault (0x300, internal 1)",
                            "\"Default PHANToM\": ", "\"Default Device\": ", "\"Ours\": "}) {
    EXPECT_THAT(opened.error().message, HasSubstr(words));
  }
}

TEST_F(OpenHaptics, ServesOneDeviceAtATime) {
  open();
  const auto second = try_open();
  ASSERT_FALSE(second.has_value());
  EXPECT_THAT(second.error().message, HasSubstr("one at a time"));
  const auto elsewhere = make_openhaptics_driver({.library = fake.path(), .device = {}})
                             ->open(device->descriptor(), {});
  EXPECT_FALSE(elsewhere.has_value()) << "another driver object has the same library";
  device.reset();
  open();
}

TEST_F(OpenHaptics, AnotherProgramThatHasItIsNamedAsACause) {
  fake->occupy(1);
  const auto opened = try_open();
  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().message, HasSubstr("already initiated (0x301"));
  EXPECT_THAT(opened.error().message, HasSubstr("no other program"));
}

TEST_F(OpenHaptics, ALibraryThatIsNoneIsAnError) {
  const auto open_with = [](const std::string& library) {
    DeviceDescriptor wanted;
    wanted.id = "openhaptics:default";
    return make_openhaptics_driver({.library = library, .device = {}})->open(wanted, {});
  };
  const auto missing = open_with("/nowhere/libHD.so");
  ASSERT_FALSE(missing.has_value());
  EXPECT_THAT(missing.error().message, HasSubstr("/nowhere/libHD.so: cannot open"));
  EXPECT_THAT(missing.error().message, HasSubstr("feltline doctor"));
  const auto other = open_with("libm.so.6");
  ASSERT_FALSE(other.has_value());
  EXPECT_THAT(other.error().message, HasSubstr("it lacks hdInitDevice, hdDisableDevice"));
}

TEST_F(OpenHaptics, AllOfTheLibrarysOwnProtectionsAreOn) {
  open();
  for (const hd::Enum what :
       {hd::capability::kMaxForceClamping, hd::capability::kForceRamping,
        hd::capability::kSoftwareForceLimit, hd::capability::kOneFrameLimit,
        hd::parameter::kSoftwareVelocityLimit, hd::parameter::kSoftwareImpulseLimit}) {
    EXPECT_TRUE(fake->is_enabled(what)) << std::hex << what;
  }
  EXPECT_FALSE(fake->is_enabled(hd::capability::kForceOutput)) << "not before the loop runs";
}

// ------------------------------------------------------------------------------------ frames

TEST_F(OpenHaptics, EachTickIsOneFrameInTheMakersAxes) {
  start();
  stylus.place({40, 30, 7});
  force = {0, 0.5, 0};
  step(10);
  ASSERT_TRUE(said && done);
  EXPECT_EQ(fake->frames(), 10U);
  EXPECT_EQ(said->time_ns, now_ns);
  const Vec3 on_page = world.plane().to_page(said->position);
  EXPECT_NEAR(on_page.x, 40.0, 1.0);
  EXPECT_NEAR(on_page.z, 7.0, 1.0);
  EXPECT_GT(held().z, 0.49) << "up from the desk";
  EXPECT_EQ(device->status().reads, 10U - 10U % 16U) << "told now and then";
}

TEST_F(OpenHaptics, TellsHowItsStylusIsHeld) {
  start();
  const auto tilt = [this]() -> std::optional<double> {
    step(60);
    const std::optional<Vec3> axis = device->pen_axis();
    if (!axis) return {};
    return tilt_of_axis(world.plane().turn_to_page(*axis));
  };
  for (const double held_deg : {0.0, 32.5, 60.0, 90.0}) {
    stylus.aim({{40, 30, 7}, {}, 0, held_deg});
    EXPECT_EQ(tilt(), held_deg);
  }
}

TEST_F(OpenHaptics, AStylusThatLiesNowhereHasNoTilt) {
  start();
  step(2);
  EXPECT_TRUE(device->pen_axis());
  const FakeHdWorld mad{nullptr,
                        [](void*, std::int64_t, FakeHdPen* pen) {
                          *pen = {{0, 0, 0}, {0, 0, 0}, 0, {std::nan(""), 0, 1}};
                          return 0;
                        },
                        [](void*, const double*) { return 0; }, [](void*) {}};
  fake->plug_in(&model, &mad);
  step();
  EXPECT_TRUE(said) << "its place is as good as ever";
  EXPECT_FALSE(device->pen_axis());
  plug_in();
  step();
  EXPECT_TRUE(device->pen_axis());
}

TEST_F(OpenHaptics, ATickThatOnlyReadsEndsItsFrameWithoutForce) {
  start();
  force = {0.5, 0, 0};
  step(3);
  EXPECT_EQ(held().x, 0.5);
  in_tick = [this] { said = device->read(now_ns); };
  step(3);
  EXPECT_EQ(fake->frames(), 6U);
  EXPECT_EQ(held(), Force{});
}

TEST_F(OpenHaptics, ATickThatOnlyWritesHasItsFrameToo) {
  start();
  force = {0.2, 0, 0};
  in_tick = [this] { done = device->write(force); };
  step(3);
  EXPECT_EQ(fake->frames(), 3U);
  EXPECT_TRUE(done);
  EXPECT_EQ(held().x, 0.2);
}

TEST_F(OpenHaptics, ReadingTwiceIsTheSameFrameAndWritingTwiceLetsGo) {
  start();
  force = {0.5, 0, 0};
  in_tick = [this] {
    said = device->read(now_ns);
    EXPECT_EQ(device->read(now_ns), said);
    EXPECT_TRUE(device->write(force));
    EXPECT_EQ(device->read(now_ns), said);
    done = device->write({1.0, 0, 0});
  };
  step(2);
  EXPECT_EQ(fake->frames(), 2U);
  EXPECT_EQ(done, tl::unexpected(DeviceFault::kOther));
  EXPECT_EQ(held(), Force{});
  in_tick = [this] { read_and_write(); };
  step(2);
  EXPECT_TRUE(done);
  EXPECT_EQ(held().x, 0.5) << "the next tick is a new one";
}

TEST_F(OpenHaptics, OutsideOfTheLoopNothingIsReadAndNothingPushes) {
  open();
  EXPECT_EQ(device->read(0), tl::unexpected(DeviceFault::kOther));
  EXPECT_FALSE(device->write({1, 0, 0}));
  EXPECT_TRUE(device->write({}));
  device->stop();
  EXPECT_EQ(fake->frames(), 0U);
}

TEST_F(OpenHaptics, StopLetsGoWhereverItComes) {
  start();
  force = {0.5, 0, 0};
  step(3);
  in_tick = [this] {
    read_and_write();
    device->stop();  // after the frame
  };
  step();
  EXPECT_FALSE(fake->is_enabled(hd::capability::kForceOutput));
  in_tick = [] {};
  step();
  EXPECT_EQ(held(), Force{});
  in_tick = [this] { read_and_write(); };
  step(2);
  EXPECT_EQ(held().x, 0.5) << "and goes on when it is asked";
  in_tick = [this] {
    said = device->read(now_ns);
    device->stop();  // within it
  };
  step(2);
  EXPECT_EQ(held(), Force{});
  in_tick = [this] { device->stop(); };  // before it
  step(2);
  device->stop();  // and between ticks
  EXPECT_EQ(held(), Force{});
}

// ------------------------------------------------------------------------------------ errors

TEST_F(OpenHaptics, ErrorsOfForcesPassAndAreToldInTheMakersWords) {
  start();
  force = {0.5, 0, 0};
  step(2);
  for (const hd::Enum error : {hd::error::kTooMuchForce, hd::error::kTooSuddenForce,
                               hd::error::kTooFast, hd::error::kForceError}) {
    fake->push_error(error, 42);
    step();
    EXPECT_EQ(done, tl::unexpected(DeviceFault::kForcesOff)) << std::hex << error;
    EXPECT_TRUE(said) << "it is read all the same";
    const DeviceStatus status = device->status();
    EXPECT_EQ(status.fault, DeviceFault::kForcesOff);
    EXPECT_EQ(status.vendor_code, static_cast<std::int64_t>(error));
    EXPECT_THAT(std::string(status.vendor_words.view()), HasSubstr("Fake: "));
    step();
    EXPECT_TRUE(said && done);
    EXPECT_FALSE(device->status().fault.has_value());
    EXPECT_EQ(device->status().last_fault, DeviceFault::kForcesOff);
  }
  fake->push_error(hd::error::kWarmMotors, 0);
  step();
  EXPECT_EQ(done, tl::unexpected(DeviceFault::kOverheated));
  EXPECT_EQ(device->status().faults, 5U);
}

TEST_F(OpenHaptics, ErrorsOfTheDeviceAreForEver) {
  for (const hd::Enum error : {hd::error::kDeviceFault, hd::error::kCommunication,
                               hd::error::kCommunicationSetup, hd::error::kTimer}) {
    start();
    force = {0.5, 0, 0};
    step(2);
    fake->push_error(error, 3);
    step();
    EXPECT_EQ(said, tl::unexpected(DeviceFault::kDisconnected)) << std::hex << error;
    EXPECT_EQ(done, tl::unexpected(DeviceFault::kDisconnected));
    EXPECT_EQ(device->status().fault, DeviceFault::kDisconnected);
    EXPECT_EQ(device->status().vendor_code, static_cast<std::int64_t>(error));
    const std::uint64_t frames = fake->frames();
    step(20);
    EXPECT_EQ(said, tl::unexpected(DeviceFault::kDisconnected));
    EXPECT_EQ(fake->frames(), frames) << "it is left alone";
    EXPECT_EQ(held(), Force{});
    device.reset();
  }
}

TEST_F(OpenHaptics, ACallThatTheLibraryDoesNotLikeIsAFaultOfThatTick) {
  start();
  step(2);
  fake->push_error(hd::error::kInvalidOperation, 0);
  step();
  EXPECT_EQ(said, tl::unexpected(DeviceFault::kOther));
  step();
  EXPECT_TRUE(said && done);
}

TEST_F(OpenHaptics, OfManyErrorsTheGravestIsToldAndATickHearsABoundedNumber) {
  start();
  force = {0.5, 0, 0};
  step(2);
  fake->push_error(hd::error::kWarmMotors, 0);  // the oldest error on the stack
  fake->push_error(hd::error::kTooFast, 0);
  fake->push_error(hd::error::kTooFast, 0);
  step();
  EXPECT_EQ(done, tl::unexpected(DeviceFault::kOverheated));
  for (int i = 0; i < 100; ++i) fake->push_error(hd::error::kTooFast, i);
  int ticks = 0;
  for (done = tl::unexpected(DeviceFault::kForcesOff); !done; ++ticks) step();
  EXPECT_EQ(ticks, 5) << "32 a tick";
}

TEST_F(OpenHaptics, WhatIsNoPlaceIsBadData) {
  start();
  step(2);
  const FakeHdWorld nowhere{nullptr,
                            [](void*, std::int64_t, FakeHdPen* pen) {
                              *pen = {{1e9, 0, 0}, {0, 0, 0}, 0xFFFFFFF0, {}};
                              return 0;
                            },
                            [](void*, const double*) { return 0; }, [](void*) {}};
  fake->plug_in(&model, &nowhere);
  step();
  EXPECT_EQ(said, tl::unexpected(DeviceFault::kBadData));
  plug_in();
  step();
  EXPECT_TRUE(said);
}

// ------------------------------------------------------------------------- switches and motors

TEST_F(OpenHaptics, AnOpenSafetySwitchTakesTheForceButNotThePen) {
  start();
  force = {0.5, 0, 0};
  step(3);
  fake->set_safety_switch(0);
  step(2);
  EXPECT_TRUE(said);
  EXPECT_EQ(done, tl::unexpected(DeviceFault::kForcesOff));
  EXPECT_EQ(held(), Force{});
  EXPECT_EQ(device->status().vendor_words.view(), "the safety switch is open");
  fake->set_safety_switch(1);
  step(2);
  EXPECT_TRUE(done);
  EXPECT_EQ(held().x, 0.5);
}

TEST_F(OpenHaptics, ADeviceWithoutASwitchNeverHadItClosed) {
  fake->set_safety_switch(0);
  start();
  force = {0.5, 0, 0};
  step(3);
  EXPECT_TRUE(done);
  EXPECT_EQ(held().x, 0.5);
}

TEST_F(OpenHaptics, InItsInkwellTheStylusIsNotPushed) {
  start();
  force = {0.5, 0, 0};
  step(3);
  fake->set_inkwell(1);
  step(2);
  EXPECT_EQ(done, tl::unexpected(DeviceFault::kForcesOff));
  EXPECT_EQ(held(), Force{});
  EXPECT_EQ(device->status().vendor_words.view(), "the stylus is in its inkwell");
}

TEST_F(OpenHaptics, WarmMotorsSinkToWhatTheyStandForGood) {
  start();
  force = {1.1, 0, 0};  // short enough for the limit of the mean force
  step(5);
  EXPECT_EQ(held().x, 1.1);
  fake->set_temperature(0.75);
  for (int i = 0; i < 1100; ++i) {
    step();
    fake->set_temperature(0.75);
  }
  EXPECT_TRUE(done) << "that is no fault";
  const double continuous = device->capabilities().continuous_force_n;
  EXPECT_NEAR(held().x, continuous, 1e-9);
  EXPECT_NEAR(*device->status().motor_temperature, 0.75, 0.01);
  for (int i = 0; i < 300; ++i) {
    step();
    fake->set_temperature(0.2);
  }
  EXPECT_EQ(held().x, 1.1);
}

// Even if a program requests the maximum force for ten minutes, the motors do not overheat.
TEST_F(OpenHaptics, NoRequestOverheatsTheMotors) {
  start();
  force = {100.0, 0, 0};
  double warmest = 0.0;
  for (int i = 0; i < 600'000; i += 100) {
    step(100);
    warmest = std::max(warmest, fake->temperature());
    ASSERT_TRUE(done) << i;
  }
  EXPECT_LT(warmest, 1.0);
  EXPECT_GT(warmest, 0.3) << "else nothing was tried";
  EXPECT_LE(fake->largest_asked_n(), 2.5);
}

TEST_F(OpenHaptics, AnOlderLibraryWithoutThermometersIsNoFault) {
  model.has_thermometers = 0;
  plug_in();
  start();
  force = {0.5, 0, 0};
  step(100);
  EXPECT_TRUE(said && done);
  const DeviceStatus status = device->status();
  EXPECT_FALSE(status.motor_temperature.has_value());
  EXPECT_EQ(status.rate_hz, 0.0);
  EXPECT_EQ(status.faults, 0U);
}

TEST_F(OpenHaptics, TellsItsRate) {
  start();
  step(100);
  EXPECT_EQ(device->status().rate_hz, 1000.0);
}

// ------------------------------------------------------------------------------------ homing

TEST_F(OpenHaptics, AnInkwellIsItsHome) {
  fake->set_home(0);
  open();
  EXPECT_EQ(device->homing(), Homing::kInkwell);
  EXPECT_THAT(device->homing_words(), HasSubstr("inkwell"));
  fake->set_inkwell(1);
  EXPECT_TRUE(device->find_home().has_value());
  EXPECT_EQ(device->homing(), Homing::kNone);
  EXPECT_EQ(device->homing_words(), "");
  EXPECT_FALSE(fake->is_running());
}

TEST_F(OpenHaptics, ARestPoseIsTheHomeOfOthers) {
  model.calibration_style = hd::calibration::kEncoderReset;
  plug_in();
  fake->set_home(0);
  open();
  EXPECT_EQ(device->homing(), Homing::kRestPose);
  EXPECT_THAT(device->homing_words(), HasSubstr("rest pose"));
  fake->set_at_rest(1);
  EXPECT_TRUE(device->find_home().has_value());
  EXPECT_EQ(device->homing(), Homing::kNone);
}

TEST_F(OpenHaptics, OneThatFindsItselfNeedsNobodyOnceItHasSeenEnough) {
  model.calibration_style = hd::calibration::kAuto | hd::calibration::kInkwell;
  plug_in();
  fake->set_home(0);
  open();
  EXPECT_EQ(device->homing(), Homing::kRestPose);
  EXPECT_THAT(device->homing_words(), HasSubstr("Move the stylus"));
  fake->set_at_rest(1);
  EXPECT_EQ(device->homing(), Homing::kNone);
}

TEST_F(OpenHaptics, AHomeThatIsNotFoundIsAnErrorWithTheNextStep) {
  fake->set_home(0);
  open();
  const auto found = device->find_home();
  ASSERT_FALSE(found.has_value());
  EXPECT_THAT(found.error().message, HasSubstr("inkwell"));
  EXPECT_FALSE(fake->is_running());
}

TEST_F(OpenHaptics, WithoutAHomeItIsNotRead) {
  fake->set_home(0);
  start();
  force = {0.5, 0, 0};
  step(2);
  EXPECT_EQ(said, tl::unexpected(DeviceFault::kNotCalibrated));
  fake->set_home(1);
  step();
  EXPECT_TRUE(said);
}

// ------------------------------------------------------------------------------------ the loop

// The owner of the loop may be destroyed right after stop_loop().
TEST_F(OpenHaptics, ACallThatBeginsWhileTheLoopIsStoppedDoesNothing) {
  open();
  int ticks = 0;
  ASSERT_TRUE(device->loop_host()
                  ->start_loop([](void* count) noexcept { ++*static_cast<int*>(count); }, &ticks)
                  .has_value());
  fake->step(kMs);
  EXPECT_EQ(ticks, 1);
  fake->call_while_stopping();
  device->loop_host()->stop_loop();
  EXPECT_EQ(ticks, 1);
}

TEST_F(OpenHaptics, ASchedulerThatDoesNotStartSaysWhy) {
  open();
  fake->refuse_scheduler(hd::error::kTimer);
  const auto started = device->loop_host()->start_loop([](void*) noexcept {}, nullptr);
  ASSERT_FALSE(started.has_value());
  EXPECT_THAT(started.error().message, HasSubstr("Fake: timer error"));
  EXPECT_EQ(fake->callbacks(), 0);
  EXPECT_FALSE(fake->is_running());
  fake->refuse_scheduler(0);
  EXPECT_TRUE(device->loop_host()->start_loop([](void*) noexcept {}, nullptr).has_value());
  EXPECT_FALSE(device->loop_host()->start_loop([](void*) noexcept {}, nullptr).has_value());
  EXPECT_FALSE(device->find_home().has_value()) << "not while the loop runs";
  device->loop_host()->stop_loop();
  device->loop_host()->stop_loop();
}

// A pencil line of a second and a half, and the resulting drawing.
struct Drawing {
  explicit Drawing(Device& pen)
      : servo(std::make_unique<Servo>(pen, ServoOptions{.limits = limits_for(pen.capabilities())})),
        session(make_tools(), {.device = pen.capabilities()}) {}

  static Vec3 aim(std::int64_t ns) {
    const double s = 1e-9 * static_cast<double>(ns);
    const double z = s < 0.8 || s > 2.2 ? 6.0 : -3.0;
    return {30.0 + 25.0 * std::max(s - 0.8, 0.0), 40.0 + 6.0 * std::sin(4.0 * s), z};
  }
  void drain() {
    PenSample sample;
    while (servo->for_edit().pop(sample)) EXPECT_TRUE(session.sample(sample).has_value());
    while (servo->for_autosave().pop(sample)) {
    }
    servo->publish(session.force());
  }

  std::unique_ptr<Servo> servo;
  Session session;
  std::int64_t now_ns = 0;
};

TEST_F(OpenHaptics, ADrawingSessionRunsWithinTheSchedulersCallbacks) {
  open();
  OpenDevice pen(*device, world.plane());
  Drawing driven(pen);
  ASSERT_TRUE(device->loop_host()
                  ->start_loop(
                      [](void* drawing) noexcept {
                        Drawing& d = *static_cast<Drawing*>(drawing);
                        d.servo->step(d.now_ns);
                      },
                      &driven)
                  .has_value());
  SimulatedStylus other{*find_stylus_preset("touch")};
  Drawing plain(other);
  double largest_n = 0.0;
  for (Drawing* drawing : {&driven, &plain}) {
    SimulatedStylus& held_body = drawing == &driven ? stylus : other;
    held_body.place(Drawing::aim(0));
    drawing->servo->arm();
    for (std::int64_t now = 0; now < 2500 * kMs; now += kMs) {
      held_body.aim(Drawing::aim(now), {}, 0);
      drawing->servo->heartbeat(now);
      drawing->now_ns = now;
      drawing == &driven ? fake->step(now) : static_cast<void>(drawing->servo->step(now));
      largest_n = std::max(largest_n, norm(held_body.acting_force()));
      if (now % (4 * kMs) == 0) drawing->drain();
    }
    drawing->drain();
    EXPECT_TRUE(drawing->session.finish().has_value());
    EXPECT_EQ(drawing->servo->latest().safety.hard_faults, 0U);
  }
  device->loop_host()->stop_loop();
  driven.servo->stop();
  plain.servo->stop();
  EXPECT_GT(largest_n, 0.5) << "it pushed back";
  EXPECT_EQ(fake->frames(), 2500U);
  ASSERT_EQ(driven.session.document().stroke_count(), 1U);
  const InkDifference difference = ink_difference(visible_strokes(plain.session.document()),
                                                  visible_strokes(driven.session.document()));
  EXPECT_EQ(difference.other, "");
  EXPECT_LT(std::max({difference.ends_mm, difference.curve_mm, difference.width_mm}), 0.1);
}

// Uses the library's real thread. Expects no times, because the machine may be busy.
TEST_F(OpenHaptics, TheLibrarysOwnThreadRunsTheLoop) {
  fake->use_thread(1);
  open();
  OpenDevice pen(*device, world.plane());
  const auto servo =
      std::make_unique<Servo>(pen, ServoOptions{.limits = limits_for(pen.capabilities())});
  stylus.place({40, 30, -2});
  for (int round = 0; round < 2; ++round) {
    RealtimeThread loop(*servo, {}, device->loop_host());
    const auto started = loop.start();
    ASSERT_TRUE(started.has_value()) << started.error().message;
    EXPECT_EQ(loop.status().scheduling, LoopScheduling::kHost);
    servo->arm();
    PenSample sample;
    while (servo->for_edit().pop(sample)) {  // skip samples of the previous round
    }
    for (int samples = 0; samples < 150;) {
      while (servo->for_edit().pop(sample)) ++samples;
      stylus.aim({40, 30, -2}, {}, 0);
      servo->heartbeat(loop.now_ns());
      static_cast<void>(device->status());
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(loop.stop());
    EXPECT_FALSE(fake->is_running());
    EXPECT_GE(loop.stats().ticks(), 150U);
  }
  EXPECT_GE(fake->frames(), 300U);
}

}  // namespace
}  // namespace felt::openhaptics_test
