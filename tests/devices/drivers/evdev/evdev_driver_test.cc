// Tests the parts that are specific to the driver of joysticks and wheels. The suites test the
// rest.
#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <thread>

#include "felt/base/constants.h"
#include "felt/devices/evdev/evdev_driver.h"
#include "felt/devices/evdev/known_sticks.h"
#include "felt/devices/evdev/stick_axes.h"
#include "felt/devices/evdev/stick_device.h"
#include "felt/rt/servo.h"
#include "tests/devices/drivers/evdev/fake_stick.h"

namespace felt::evdev_driver_test {
namespace {

/// The fixture: a stick, its driver and a clock.
struct Fixture {
  FakeStick stick;
  std::unique_ptr<Driver> driver;
  std::unique_ptr<DriverDevice> device;
  std::int64_t now_ns = 0;

  explicit Fixture(std::vector<FaultWindow> faults = {}, std::vector<std::uint16_t> effects = {})
      : stick(std::move(faults), std::move(effects)) {
    EvdevOptions options;
    options.system = &stick.system();
    options.open = [this](const std::string& path) { return stick.open(path); };
    options.has_thread = false;
    driver = make_evdev_driver(std::move(options));
    stick.world().stylus().place({FakeStick::kMiddle.x, FakeStick::kMiddle.y, 10.0});
  }
  Result<void> open() {
    const auto found = driver->find();
    if (found.empty()) return fail(ErrorCode::kNotFound, "none");
    stick.set_haptic_thread(false);
    auto opened = driver->open(found.front(), {});
    if (!opened) return tl::unexpected(opened.error());
    device = *std::move(opened);
    return {};
  }
  void aim(double x, double y, double z) {
    stick.world().stylus().aim({FakeStick::kMiddle.x + x, FakeStick::kMiddle.y + y, z}, {}, 0);
  }
  void serve() {
    stick.set_haptic_thread(false);
    dynamic_cast<EffectServed&>(*device).serve(now_ns);
    stick.set_haptic_thread(true);
  }
  void close() {
    stick.set_haptic_thread(false);
    device.reset();
  }
  tl::expected<PenSample, DeviceFault> read() {
    now_ns += kMs;
    stick.tick(now_ns);
    serve();
    return device->read(now_ns);
  }
  /// Runs ticks with this force. Returns the result of the last write().
  tl::expected<void, DeviceFault> push(const Force& force, int ticks) {
    tl::expected<void, DeviceFault> done;
    for (int i = 0; i < ticks; ++i) {
      static_cast<void>(read());
      done = device->write(force);
    }
    return done;
  }
  [[nodiscard]] Force held() { return stick.world().held_force(); }
};

TEST(EvdevDriver, FindsTheStickAndNothingElse) {
  Fixture fixture;
  const auto found = fixture.driver->find();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].id, "evdev:045e:001b");
  EXPECT_EQ(found[0].label, "Microsoft SideWinder Force Feedback 2");
  EXPECT_EQ(found[0].model, "ff-stick");
  EXPECT_FALSE(found[0].has_own_frame);
  EXPECT_EQ(found[0].capabilities.actuated_axes, 2);
  EXPECT_EQ(found[0].capabilities.max_force_n, 8.0);
}

TEST(EvdevDriver, UnknownSticksCountAsStrongAndGamepadsAreNone) {
  InputNode node;
  node.name = "Brand new stick";
  node.axes[evdev::kAbsX] = node.axes[evdev::kAbsY] = true;
  node.keys[evdev::kButtonTrigger] = true;
  EXPECT_FALSE(stick_kind(node)) << "no motors";
  node.effects[evdev::kFfRumble] = true;
  EXPECT_FALSE(stick_kind(node)) << "it only rumbles";
  node.effects[evdev::kFfConstant] = true;
  ASSERT_TRUE(stick_kind(node));
  EXPECT_EQ(stick_kind(node)->forces.full_force_n, 10.0);
  EXPECT_FALSE(stick_kind(node)->is_known);
  node.name = "Somebody's RACING Wheel";
  EXPECT_TRUE(stick_kind(node)->is_wheel);
  EXPECT_EQ(stick_kind(node)->forces.full_force_n, 60.0);
  EXPECT_FALSE(stick_kind(node)->forces.has_y);
  node.vendor = 0x046D;
  node.product = 0xC24F;
  EXPECT_EQ(stick_kind(node)->label, "Logitech G29");
  EXPECT_EQ(stick_kind(node)->forces.full_force_n, 18.0);
  node.keys.reset();
  EXPECT_FALSE(stick_kind(node)) << "no button to draw with";
}

/// Tests the direction of the force on each axis, through springs, or through constant effects if
/// the stick has no springs.
TEST(EvdevDriver, ForcesPushTheRightWayOnEachAxis) {
  for (const std::vector<std::uint16_t>& effects :
       {std::vector<std::uint16_t>{}, std::vector<std::uint16_t>{evdev::kFfConstant}}) {
    Fixture fixture({}, effects);
    ASSERT_TRUE(fixture.open());
    for (const Force& force : {Force{0.5, 0, 0}, Force{-0.5, 0, 0}, Force{0, 0.5, 0},
                               Force{0, -0.5, 0}, Force{0.3, -0.4, 0}}) {
      ASSERT_TRUE(fixture.push(force, 60));
      const Force held = fixture.held();
      EXPECT_NEAR(held.x, force.x, 0.06) << force.x << " " << force.y;
      EXPECT_NEAR(held.y, force.y, 0.06) << force.x << " " << force.y;
    }
    EXPECT_EQ(fixture.stick.broken_rule(), "");
  }
}

TEST(EvdevDriver, ASpringIsRenderedByTheDeviceItself) {
  Fixture fixture;
  ASSERT_TRUE(fixture.open());
  constexpr double kStiffness = 0.08;  // N/mm, towards the middle
  for (int ms = 0; ms < 1500; ++ms) {
    fixture.aim(12.0 * std::sin(0.008 * ms), 0.0, 5.0);
    const auto pen = fixture.read();
    ASSERT_TRUE(pen);
    ASSERT_TRUE(fixture.device->write({-kStiffness * pen->position.x, 0, 0}));
  }
  double stiffness = 0.0;
  for (const auto& [id, effect] : fixture.stick.effects()) {
    if (effect.type != evdev::kFfSpring) continue;
    stiffness = effect.conditions[0].right_coefficient / 32767.0 * FakeStick::kFullN /
                FakeStick::kHalfWayMm;
  }
  EXPECT_NEAR(stiffness, kStiffness, 0.15 * kStiffness);
  EXPECT_EQ(fixture.stick.broken_rule(), "");
}

TEST(EvdevDriver, AForceThatIsNoneSilencesAtOnce) {
  Fixture fixture;
  ASSERT_TRUE(fixture.open());
  ASSERT_TRUE(fixture.push({0.8, 0, 0}, 60));
  ASSERT_GT(fixture.held().x, 0.5);
  ASSERT_TRUE(fixture.device->write({}));
  fixture.serve();
  EXPECT_EQ(fixture.held(), Force{}) << "in the same tick, whenever uploads are due";
  ASSERT_TRUE(fixture.push({0.8, 0, 0}, 60));
  ASSERT_GT(fixture.held().x, 0.5);
  fixture.device->stop();
  fixture.serve();
  EXPECT_EQ(fixture.held(), Force{});
  ASSERT_TRUE(fixture.push({0.8, 0, 0}, 60));
  EXPECT_EQ(fixture.device->write({std::nan(""), 0, 0}).error(), DeviceFault::kBadData);
  fixture.serve();
  EXPECT_EQ(fixture.held(), Force{});
  EXPECT_EQ(fixture.stick.broken_rule(), "");
}

TEST(EvdevDriver, AProgramThatHangsLeavesNoForce) {
  Fixture fixture;
  ASSERT_TRUE(fixture.open());
  ASSERT_TRUE(fixture.push({0.8, 0, 0}, 60));
  ASSERT_GT(fixture.held().x, 0.5);
  for (int ms = 0; ms < 110; ++ms) fixture.stick.tick(fixture.now_ns += kMs);  // without the worker
  EXPECT_EQ(fixture.held(), Force{});
}

TEST(EvdevDriver, EverythingIsErasedAtTheEnd) {
  Fixture fixture;
  ASSERT_TRUE(fixture.open());
  ASSERT_TRUE(fixture.push({0.8, 0.2, 0}, 60));
  EXPECT_GT(fixture.stick.effects_kept(), 0u);
  fixture.close();
  EXPECT_EQ(fixture.stick.effects_kept(), 0u);
  EXPECT_EQ(fixture.held(), Force{});
  EXPECT_EQ(fixture.stick.broken_rule(), "");
}

TEST(EvdevDriver, WhatTheKernelRefusesIsForcesOffWithItsWords) {
  for (const int error : {EIO, ENOSPC, EINVAL}) {
    Fixture fixture;
    ASSERT_TRUE(fixture.open());
    ASSERT_TRUE(fixture.push({0.8, 0, 0}, 30));
    fixture.stick.refuse_uploads(error);
    EXPECT_EQ(fixture.push({0.8 - 0.1, 0.3, 0}, 20).error(), DeviceFault::kForcesOff);
    EXPECT_EQ(fixture.held(), Force{}) << "half of a force is none";
    EXPECT_TRUE(fixture.read()) << "the drawing goes on";
    const DeviceStatus status = fixture.device->status();
    EXPECT_EQ(status.fault, DeviceFault::kForcesOff);
    EXPECT_EQ(status.vendor_code, error);
    EXPECT_FALSE(status.vendor_words.empty());
    // The driver tries it again from time to time, and it works again.
    fixture.stick.refuse_uploads(0);
    EXPECT_TRUE(fixture.push({}, 20));
    EXPECT_TRUE(fixture.push({0.8, 0, 0}, 40));
    EXPECT_GT(fixture.held().x, 0.5);
    EXPECT_FALSE(fixture.device->status().fault);
  }
}

TEST(EvdevDriver, UnpluggedIsForEver) {
  Fixture fixture({{InjectedFault::kUnplugged, 100 * kMs, 200 * kMs, 1.0}});
  ASSERT_TRUE(fixture.open());
  ASSERT_TRUE(fixture.push({0.8, 0, 0}, 90));
  EXPECT_EQ(fixture.push({0.8, 0, 0}, 20).error(), DeviceFault::kDisconnected);
  EXPECT_EQ(fixture.read().error(), DeviceFault::kDisconnected);
  EXPECT_TRUE(fixture.driver->find().empty());
  static_cast<void>(fixture.push({}, 150));
  EXPECT_EQ(fixture.read().error(), DeviceFault::kDisconnected) << "though it is back";
  EXPECT_EQ(fixture.driver->find().size(), 1u);
  ASSERT_TRUE(fixture.open());
  EXPECT_TRUE(fixture.read());
  EXPECT_EQ(fixture.held(), Force{});
}

TEST(EvdevDriver, LostEventsAreAskedForAnew) {
  Fixture fixture;
  ASSERT_TRUE(fixture.open());
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(fixture.read());
  fixture.aim(20, -10, 5);
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(fixture.read());
  fixture.stick.drop_events();
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(fixture.read());
  const auto pen = fixture.read();
  ASSERT_TRUE(pen);
  EXPECT_NEAR(pen->position.x, 20.0, 1.0);
  EXPECT_NEAR(pen->position.y, -10.0, 1.0);
  EXPECT_EQ(fixture.stick.broken_rule(), "");
}

/// If the worker hangs in the kernel, the drawing must not use the last position as the pen's
/// position.
TEST(EvdevDriver, LostEventsThatNobodyAsksForAreBadData) {
  Fixture fixture;
  ASSERT_TRUE(fixture.open());
  ASSERT_TRUE(fixture.read());
  fixture.stick.set_haptic_thread(true);
  fixture.stick.drop_events();
  const std::int64_t stale_ns = fixture.now_ns + StickAxes::kStaleNs + 2 * kMs;
  tl::expected<PenSample, DeviceFault> pen;
  while (fixture.now_ns < stale_ns) {
    fixture.stick.tick(fixture.now_ns += kMs);
    pen = fixture.device->read(fixture.now_ns);
  }
  EXPECT_EQ(pen.error(), DeviceFault::kBadData);
  EXPECT_EQ(fixture.stick.broken_rule(), "");
  EXPECT_TRUE(fixture.read()) << "the worker answers";
  EXPECT_TRUE(fixture.read());
}

/// The stick moves from one end to the other between two reports, which no hand can do.
TEST(EvdevDriver, AJumpTakesTheForceAway) {
  Fixture fixture({{InjectedFault::kJump, 400 * kMs, 500 * kMs, 80.0}});
  ASSERT_TRUE(fixture.open());
  fixture.stick.world().stylus().place({FakeStick::kMiddle.x - 40.0, FakeStick::kMiddle.y, 10.0});
  Servo servo(*fixture.device, {.limits = limits_for(fixture.device->capabilities())});
  servo.arm();
  bool was_cut = false;
  for (int ms = 0; ms < 450; ++ms) {
    fixture.now_ns += kMs;
    fixture.stick.tick(fixture.now_ns);
    fixture.serve();
    servo.heartbeat(fixture.now_ns);
    const TickReport& tick = servo.step(fixture.now_ns);
    was_cut = was_cut || tick.safety.fault == SafetyFault::kPositionJump ||
              tick.safety.fault == SafetyFault::kTooFast;
  }
  EXPECT_TRUE(was_cut);
}

TEST(EvdevDriver, WhatCannotWorkIsRefusedWithTheNextStep) {
  Fixture fixture;
  fixture.stick.set_slots(2);
  Result<void> opened = fixture.open();
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().message.find("2 effects, but three are needed"), std::string::npos);
  fixture.stick.set_slots(16);
  fixture.stick.fake_system().forbid("/dev/input/event7");
  opened = fixture.open();
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().message.find("Permission denied"), std::string::npos);
  EXPECT_NE(opened.error().message.find("feltline doctor"), std::string::npos);
  const auto findings = fixture.driver->diagnose(fixture.stick.system());
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].level, FindingLevel::kProblem);
  ASSERT_TRUE(findings[0].fix);
  EXPECT_EQ(findings[0].fix->content,
            "KERNEL==\"event*\", SUBSYSTEM==\"input\", ATTRS{id/vendor}==\"045e\", "
            "ATTRS{id/product}==\"001b\", TAG+=\"uaccess\"\n");
  fixture.stick.fake_system().allow("/dev/input/event7");
  EXPECT_EQ(fixture.driver->diagnose(fixture.stick.system())[0].level, FindingLevel::kOk);
}

TEST(EvdevDriver, DoctorNamesSticksWithoutMotors) {
  FakeSystem system;
  const auto driver = make_evdev_driver();
  EXPECT_EQ(driver->diagnose(system)[0].level, FindingLevel::kAbsent);
  system.add_file("/sys/class/input/event3/device/name", "Old wheel")
      .add_file("/sys/class/input/event3/device/capabilities/abs", "1")
      .add_file("/sys/class/input/event3/device/capabilities/key", "100000000 0 0 0 0");
  const auto findings = driver->diagnose(system);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].level, FindingLevel::kWarning);
  EXPECT_NE(findings[0].what.find("Old wheel"), std::string::npos);
}

/// An input device that only counts calls. Safe to call from any thread.
class CountingPort final : public EvdevPort {
 public:
  struct Counts {
    std::atomic<int> uploads{0}, plays{0}, stops{0}, erased{0};
  };
  explicit CountingPort(Counts& counts) : counts_(counts) {}
  tl::expected<bool, int> next(EvdevEvent&) noexcept override { return false; }
  tl::expected<EvdevAxis, int> axis(std::uint16_t) noexcept override {
    return EvdevAxis{0, -100, 100, 0};
  }
  tl::expected<bool, int> key(std::uint16_t) noexcept override { return false; }
  tl::expected<int, int> slots() noexcept override { return 16; }
  tl::expected<std::int16_t, int> upload(const EvdevEffect& effect) noexcept override {
    ++counts_.uploads;
    return effect.id < 0 ? std::int16_t{0} : effect.id;
  }
  tl::expected<void, int> erase(std::int16_t) noexcept override {
    ++counts_.erased;
    return {};
  }
  tl::expected<void, int> send(const EvdevEvent& event) noexcept override {
    if (event.code < evdev::kFfGain) ++(event.value > 0 ? counts_.plays : counts_.stops);
    return {};
  }

 private:
  Counts& counts_;
};

/// With a worker thread: it uploads without being called, and closing stops and erases the effects.
TEST(EvdevDriver, AThreadOfItsOwnUploads) {
  FakeStick stick({});
  CountingPort::Counts counts;
  EvdevOptions options;
  options.system = &stick.system();
  options.open = [&counts](const std::string&) -> Result<std::unique_ptr<EvdevPort>> {
    return std::make_unique<CountingPort>(counts);
  };
  const auto driver = make_evdev_driver(std::move(options));
  auto device = driver->open(driver->find().front(), {});
  ASSERT_TRUE(device) << device.error().message;
  std::int64_t now_ns = 0;
  while (counts.plays == 0) {
    ASSERT_TRUE((*device)->read(now_ns += kMs));
    ASSERT_TRUE((*device)->write({0.5, 0, 0}));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  device->reset();
  EXPECT_GE(counts.uploads, 1);
  EXPECT_GE(counts.stops, 1);
  EXPECT_GE(counts.erased, 1);
}

}  // namespace
}  // namespace felt::evdev_driver_test
