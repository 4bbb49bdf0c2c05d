// Tests the driver of Haply's devices with a fake of Haply's service, as far as they are specific
// to that service.
#include "felt/devices/haply/haply_driver.h"
#include "felt/base/constants.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <thread>

#include "felt/devices/haply/haply_device.h"
#include "felt/devices/haply/service_address.h"
#include "felt/driver/open_device.h"
#include "felt/driver/testing/fake_system.h"
#include "felt/geometry/tilt.h"
#include "felt/rt/servo.h"
#include "tests/devices/drivers/haply/fake_service.h"
#include "tests/devices/drivers/said.h"

namespace felt::haply::haply_driver_test {
namespace {

using ::testing::HasSubstr;

// The service's axes are x right, y away, z up; the surface lies on the desk, in the middle.
PlaneCalibration fixture() {
  return *PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}, {40, 40, 0});
}

class Table {
 public:
  explicit Table(FakeServiceOptions options = {}, std::vector<FaultWindow> faults = {})
      : world(*find_stylus_preset("inverse3"), faults),
        service(world, faults, fixture(), std::move(options)) {
    HaplyOptions haply;
    haply.connect = [this](const std::string& host, std::uint16_t port, std::int64_t) {
      return service.connect(host, port);
    };
    haply.system = &system;
    haply.seed = 7;
    driver = make_haply_driver(haply);
  }

  Result<void> open() {
    const std::vector<DeviceDescriptor> found = driver->find();
    if (found.empty()) return fail(ErrorCode::kNotFound, "nothing found");
    auto opened = driver->open(found.front(), {});
    if (!opened) return tl::unexpected(opened.error());
    device = *std::move(opened);
    return {};
  }

  struct Ticked {
    tl::expected<PenSample, DeviceFault> read;
    tl::expected<void, DeviceFault> written;
  };
  Ticked tick(const Force& force = {}) {
    service.tick(now_ns);
    auto read = device->read(now_ns);
    auto written = device->write(force);
    now_ns += kMs;
    return {read, written};
  }

  /// Runs as many ticks as a force needs to rise to this value.
  Ticked push(const Force& force) {
    for (int i = 0; i < 12; ++i) static_cast<void>(tick(force));
    return tick(force);
  }

  FakeSystem system;
  FakeWorld world;
  FakeService service;
  std::unique_ptr<Driver> driver;
  std::unique_ptr<DriverDevice> device;
  std::int64_t now_ns = 0;
};

TEST(HaplyDriver, FindsAndOpens) {
  Table table;
  const std::vector<DeviceDescriptor> found = table.driver->find();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].id, "haply:049D");
  EXPECT_EQ(found[0].model, "inverse3");
  EXPECT_EQ(found[0].label, "Haply Inverse3");
  EXPECT_EQ(found[0].serial, "049D");
  EXPECT_EQ(found[0].version, "Inverse Service 3.4.2.0, firmware 7.4");
  const Result<void> opened = table.open();
  ASSERT_TRUE(opened.has_value()) << opened.error().message;
  EXPECT_EQ(table.service.profile(), "org.feltline:drawing");
  EXPECT_EQ(table.service.preset(), "arm_front_centered");
  EXPECT_EQ(table.service.broken_rule(), "");
  EXPECT_THAT(std::string(table.device->status().notice.view()), HasSubstr("force gate (0.30)"));
}

// A force on the surface must reach the hand in the intended direction on each axis, through the
// plane that is used until the user has calibrated another.
TEST(HaplyDriver, ForcesPointTheRightWayThroughTheUsualPlane) {
  const struct {
    Force on_page, at_service;
  } kAxes[] = {{{1, 0, 0}, {1, 0, 0}},   // right is right
               {{0, 1, 0}, {0, -1, 0}},  // down the page is towards the user
               {{0, 0, 1}, {0, 0, 1}}};  // out of the surface is up
  for (const auto& axis : kAxes) {
    Table table;
    ASSERT_TRUE(table.open().has_value());
    const PlaneCalibration plane = table.driver->default_plane(table.device->descriptor(), {});
    EXPECT_TRUE(plane.mirrors()) << "the device's axes are right-handed, the page's are not";
    OpenDevice device(*table.device, plane);
    for (std::int64_t t = 0; t < 10 * kMs; t += kMs) {
      table.service.tick(t);
      ASSERT_TRUE(device.read(t).has_value());
      ASSERT_TRUE(device.write(axis.on_page).has_value());
    }
    EXPECT_EQ(table.service.asked(), axis.at_service);
    EXPECT_EQ(device.held_force(), axis.on_page);
    const Force& held = table.world.held_force();
    EXPECT_GT(dot(held, axis.on_page), 0.9);
  }
}

TEST(HaplyDriver, PlacesAreMillimetresOfTheServicesFrame) {
  Table table;
  ASSERT_TRUE(table.open().has_value());
  table.world.stylus().place({50, 30, 5});
  table.world.stylus().hold({});
  const auto [read, written] = table.tick();
  ASSERT_TRUE(read.has_value());
  EXPECT_NEAR(read->position.x, 10.0, 0.1);
  EXPECT_NEAR(read->position.y, 10.0, 0.1);
  EXPECT_NEAR(read->position.z, 5.0, 0.1);
}

TEST(HaplyDriver, TheForceHasTheNameOfTheServicesVersion) {
  for (const auto& [version, key] : {std::pair{"3.4.2.0", "values"},
                                     {"3.5.0.0", "vector"},
                                     {"3.6.1", "vector"},
                                     {"strange", "values"}}) {
    Table table({.version = version, .key = key});
    ASSERT_TRUE(table.open().has_value());
    table.push({0.5, 0, 0});
    EXPECT_EQ(table.service.asked(), (Force{0.5, 0, 0})) << version;
    EXPECT_EQ(table.service.ignored_forces(), 0);
  }
}

// The vendor's pages and examples disagree on the key. A service silently ignores the wrong key.
// Forces must not return with a kick.
TEST(HaplyDriver, AForceThatIsNotHeardIsAskedForByItsOtherName) {
  Table table({.version = "3.5.0.0", .key = "values"});
  ASSERT_TRUE(table.open().has_value());
  int ticks = 0;
  Table::Ticked ticked = table.tick({0, 0, 0.5});
  for (; ticked.written.has_value() && ticks < 1000; ++ticks) ticked = table.tick({0, 0, 0.5});
  EXPECT_EQ(ticked.written.error(), DeviceFault::kForcesOff);
  EXPECT_GE(ticks, HaplyDevice::kDeafStates);
  EXPECT_LT(ticks, HaplyDevice::kDeafStates + 5);
  EXPECT_EQ(table.service.asked(), Force{}) << "it says so before it pushes";
  EXPECT_THAT(std::string(table.device->status().vendor_words.view()), HasSubstr("values"));
  EXPECT_TRUE(table.push({0, 0, 0.5}).written.has_value());
  EXPECT_EQ(table.service.asked(), (Force{0, 0, 0.5}));
}

TEST(HaplyDriver, AServiceThatShowsNoForceIsNotAskedForEver) {
  Table table({.shows_force = false});
  ASSERT_TRUE(table.open().has_value());
  int refused = 0;
  for (int i = 0; i < 2000; ++i) refused += table.tick({0, 0, 0.5}).written ? 0 : 1;
  EXPECT_EQ(refused, 1);
  EXPECT_EQ(static_cast<HaplyDevice&>(*table.device).force_key(), ForceKey::kVector);
}

TEST(HaplyDriver, ForcesAreBounded) {
  Table table;
  ASSERT_TRUE(table.open().has_value());
  table.push({0, 0, 1000});
  EXPECT_LE(table.service.largest_asked_n(), 3.0 + 1e-5);
  const auto written = table.tick({std::nan(""), 0, 0}).written;
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error(), DeviceFault::kBadData);
  EXPECT_EQ(table.service.asked(), Force{});
  table.push({0, HUGE_VAL, 0});
  EXPECT_TRUE(is_finite(table.service.asked()));
}

TEST(HaplyDriver, ALateStateIsHeldAndThenAFault) {
  Table table({}, {{InjectedFault::kNoAnswer, 5 * kMs, 40 * kMs}});
  ASSERT_TRUE(table.open().has_value());
  PenSample before;
  for (int i = 0; i < 6; ++i) before = table.tick().read.value();
  int held = 0;
  auto read = table.tick().read;
  for (; read.has_value(); read = table.tick().read, ++held) {
    EXPECT_NEAR(norm(read->position - before.position), 0.0, 0.5);
    EXPECT_EQ(read->time_ns, 5 * kMs) << "a state that is repeated keeps its time";
  }
  EXPECT_EQ(held, HaplyDevice::kMaxHeldNs / kMs);
  EXPECT_EQ(read.error(), DeviceFault::kOther);
  while (table.now_ns < 45 * kMs) table.tick();
  EXPECT_TRUE(table.tick().read.has_value());
  EXPECT_EQ(table.device->status().fault, DeviceFault::kForcesOff) << "until it is prompt again";
  for (int i = 0; i < 1200; ++i) table.tick();
  EXPECT_EQ(table.device->status().fault, std::nullopt);
  EXPECT_EQ(table.device->status().faults, 1u);

  table.service.be_silent(true);
  std::optional<DeviceFault> fault;
  for (int i = 0; i < HaplyDevice::kMaxSilentNs / kMs + 20; ++i) {
    if (const auto silent = table.tick().read; !silent) fault = silent.error();
  }
  EXPECT_EQ(fault, DeviceFault::kDisconnected);
  table.service.be_silent(false);
  EXPECT_EQ(table.tick().read.error(), DeviceFault::kDisconnected) << "for ever";
}

// Forces within one tick of the service add up. At most one force may wait for a stalled service,
// regardless of the duration of the stall and of its answers.
TEST(HaplyDriver, ForcesDoNotPileUpBeforeAServiceThatStandsStill) {
  for (const bool answers_once : {false, true}) {
    for (const std::int64_t stands_ms : {1, 2, 3, 5, 9, 30, 200}) {
      Table table({.answers_once = answers_once},
                  {{InjectedFault::kNoAnswer, 50 * kMs, (50 + stands_ms) * kMs}});
      ASSERT_TRUE(table.open().has_value());
      for (int i = 0; i < 50; ++i) ASSERT_TRUE(table.tick({3, 0, 0}).read.has_value());
      for (std::int64_t i = 0; i < stands_ms; ++i) table.tick({3, 0, 0});
      // After a long stall forces are off; they return when the service has answered promptly for a
      // second.
      for (int i = 0; i < (stands_ms < 9 ? 10 : 1500); ++i) table.tick({3, 0, 0});
      EXPECT_LE(table.service.largest_asked_n(), 3.0 + 1e-5) << stands_ms << " ms";
      EXPECT_TRUE(table.tick({3, 0, 0}).read.has_value()) << "it is heard again";
      EXPECT_EQ(table.service.asked(), (Force{3, 0, 0})) << "and pushes again";
      EXPECT_EQ(table.device->status().fault, std::nullopt);
      EXPECT_EQ(table.service.broken_rule(), "");
    }
  }
}

// Homing discards the unanswered messages, but it must not forget the force that waits in the
// service.
TEST(HaplyDriver, AfterLookingForHomeBeforeAServiceThatStandsStillNoForceGoesUnasked) {
  Table table({}, {{InjectedFault::kNoAnswer, 50 * kMs, 250 * kMs}});
  ASSERT_TRUE(table.open());
  for (std::int64_t t = 0; t < 60 * kMs; t += kMs) {
    table.service.tick(t);
    (void)table.device->read(t);
    (void)table.device->write({3, 0, 0});
  }
  (void)table.device->find_home();
  (void)table.device->write({3, 0, 0});  // without a read(), which would request a state
  for (std::int64_t t = 60 * kMs; t < 300 * kMs; t += kMs) {
    table.service.tick(t);
    (void)table.device->read(t);
    (void)table.device->write({});
  }
  EXPECT_LE(table.service.largest_asked_n(), 3.0 + 1e-9);
}

// The service continues after it was disconnected, with the force that waited there: stop()
// releases it.
TEST(HaplyDriver, AServiceThatWasGivenUpIsToldToLetGoWhenItGoesOn) {
  const std::int64_t stands_ms = HaplyDevice::kMaxSilentNs / kMs + 100;
  Table table({.watchdog_ns = 10'000 * kMs},
              {{InjectedFault::kNoAnswer, 50 * kMs, (50 + stands_ms) * kMs}});
  ASSERT_TRUE(table.open().has_value());
  for (std::int64_t i = 0; i < 50 + stands_ms; ++i) table.tick({3, 0, 0});
  ASSERT_EQ(table.tick().read.error(), DeviceFault::kDisconnected);
  table.tick();
  table.device->stop();
  EXPECT_EQ(table.world.held_force(), Force{});
}

// The service stalls again and again, for some ticks each time.
TEST(HaplyDriver, ForcesDoNotPileUpBeforeAServiceThatStutters) {
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    std::mt19937 random(seed);
    const auto some = [&random](int largest) {
      return static_cast<int>(random() % static_cast<unsigned>(largest));
    };
    std::vector<FaultWindow> faults;
    for (std::int64_t at = 10; at < 400;) {
      const int lasts = 1 + some(7);
      faults.push_back({InjectedFault::kNoAnswer, at * kMs, (at + lasts) * kMs});
      at += lasts + 1 + some(5);
    }
    Table table({.answers_once = some(2) == 0}, faults);
    ASSERT_TRUE(table.open().has_value());
    for (int i = 0; i < 420; ++i) table.tick({0, 3, 0});
    EXPECT_LE(table.service.largest_asked_n(), 3.0 + 1e-5) << "seed " << seed;
    EXPECT_LE(table.service.max_waiting(), 2u) << "seed " << seed;
    EXPECT_EQ(table.service.broken_rule(), "") << "seed " << seed;
    EXPECT_LE(table.device->status().faults, 1u) << "seed " << seed;
  }
}

struct LateService {
  const char* what;
  InjectedFault fault;
  double amount;
  bool is_off;  // if the fault lasts, it takes the force away
};
constexpr LateService kLateServices[] = {
    {"1.2 ms", InjectedFault::kSlowAnswers, 1.2, false},
    {"2 ms", InjectedFault::kSlowAnswers, 2.0, true},
    {"2.1 ms", InjectedFault::kSlowAnswers, 2.1, true},
    {"5 ms", InjectedFault::kSlowAnswers, 5.0, true},
    {"30 ms", InjectedFault::kSlowAnswers, 30.0, true},
    {"every second answer", InjectedFault::kLostAnswers, 0.0, true},
    {"bursts", InjectedFault::kBurstAnswers, 4.0, true},
    {"long bursts", InjectedFault::kBurstAnswers, 25.0, true},
    {"100 ms", InjectedFault::kSlowAnswers, 100.0, true},
    {"late once", InjectedFault::kLateAnswer, 2.6, false},
    {"later once", InjectedFault::kLateAnswer, 6.0, false},
    {"9 ms late", InjectedFault::kLateAnswer, 9.0, false},
    {"12 ms late", InjectedFault::kLateAnswer, 12.0, false},
    {"15 ms late", InjectedFault::kLateAnswer, 15.0, false}};

/// Returns how many messages may wait at the same time.
std::size_t may_wait(const LateService& late) {
  if (late.amount > 50.0 && late.fault == InjectedFault::kSlowAnswers) return 4;  // RequestWindow
  return late.fault == InjectedFault::kBurstAnswers ? 2 : 1;
}

constexpr std::int64_t kForever = INT64_MAX;

// Whatever the service does: messages do not pile up, the force is neither interrupted nor jumps,
// each fault gives one sentence, and the driver reports the force that it really sent.
TEST(HaplyDriver, R49_ALateServiceNeitherPilesUpNorChopsTheForce) {
  for (const LateService& late : kLateServices) {
    SCOPED_TRACE(late.what);
    Table table({}, {{late.fault, 100 * kMs, kForever, late.amount}});
    ASSERT_TRUE(table.open().has_value());
    int falls = 0, faults_reported = 0;
    std::optional<DeviceFault> reported;
    double last_n = 0.0;
    for (int i = 0; i < 3000; ++i) {
      table.tick({0, 0, 2});
      const double sent_n = norm(table.service.newest_force());
      falls += sent_n < last_n && last_n > 1.99 ? 1 : 0;
      last_n = sent_n;
      EXPECT_NEAR(norm(*table.device->held_force() - table.service.newest_force()), 0.0, 1e-5);
      const std::optional<DeviceFault> fault = table.device->status().fault;
      faults_reported += fault && fault != reported ? 1 : 0;
      reported = fault;
    }
    EXPECT_LE(table.service.max_waiting(), may_wait(late));
    EXPECT_LE(table.service.largest_rise_n(), 0.6 + 1e-5);
    EXPECT_EQ(table.service.broken_rule(), "");
    EXPECT_EQ(falls, late.is_off ? 1 : 0) << "to zero once, or never";
    EXPECT_EQ(last_n, late.is_off ? 0.0 : 2.0);
    EXPECT_EQ(table.device->status().faults, late.is_off ? 1u : 0u);
    EXPECT_EQ(faults_reported, late.is_off ? 1 : 0);
    EXPECT_EQ(table.device->status().vendor_words.empty(), !late.is_off);
  }
}

TEST(HaplyDriver, R49_ForcesOffIsOnTheWireInTheSameTickHoweverLateTheServiceIs) {
  for (const LateService& late : kLateServices) {
    for (const int after : {0, 1, 2, 3, 7, 20, 60}) {
      SCOPED_TRACE(std::string(late.what) + " for " + std::to_string(after) + " ms");
      Table table({}, {{late.fault, 100 * kMs, kForever, late.amount}});
      ASSERT_TRUE(table.open().has_value());
      for (int i = 0; i < 100 + after; ++i) table.tick({0, 0, 2});
      table.tick();
      EXPECT_EQ(table.service.newest_force(), Force{});
      const int messages = table.service.messages();
      for (int i = 0; i < 12; ++i) table.tick();
      EXPECT_EQ(table.service.newest_force(), Force{});
      if (late.amount <= 6.0) {  // it handles two messages one after the other
        EXPECT_EQ(table.world.held_force(), Force{});
      }
      EXPECT_LE(table.service.messages(), messages + 12);
    }
  }
}

// Drawing continues during a short stall of the service: no ink is lost, and nothing counts as a
// jump.
TEST(HaplyDriver, R49_AStallWhileTheHandDrawsIsNotAJump) {
  for (const int stall_ms : {5, 8, 12, 16, 19}) {
    for (const double mm_per_ms : {0.1, 0.2, 0.35, 0.5}) {
      for (const bool with_forces : {false, true}) {
        SCOPED_TRACE(std::to_string(stall_ms) + " ms at " + std::to_string(mm_per_ms));
        Table table({}, {{InjectedFault::kNoAnswer, 700 * kMs, (700 + stall_ms) * kMs}});
        ASSERT_TRUE(table.open().has_value());
        table.world.stylus().hold({});
        const ServoOptions options{.limits = limits_for(table.device->capabilities())};
        const auto servo = std::make_unique<Servo>(*table.device, options);
        if (with_forces) servo->arm();
        Vec3 pen{10, 30, -1};
        for (; table.now_ns < 800 * kMs; table.now_ns += kMs) {
          if (table.now_ns > 650 * kMs) pen.x += mm_per_ms;
          table.world.stylus().place(pen);
          table.service.tick(table.now_ns);
          servo->heartbeat(table.now_ns);
          servo->step(table.now_ns);
        }
        int samples = 0;
        std::optional<double> last_x;
        for (PenSample sample; servo->for_edit().pop(sample); ++samples) {
          if (!last_x) last_x = sample.position.x;
          EXPECT_TRUE(in_contact(sample));
          EXPECT_LE(sample.position.x - *last_x, (stall_ms + 4) * mm_per_ms);
          last_x = sample.position.x;
        }
        EXPECT_GE(samples, 800 - stall_ms - 4);
        EXPECT_NEAR(last_x.value_or(0.0), pen.x - 40.0, 1.0);
        EXPECT_EQ(servo->latest().ink_cuts, 0u);
        const SafetyReport& safety = servo->latest().safety;
        EXPECT_NE(safety.fault, SafetyFault::kPositionJump);
        EXPECT_NE(safety.fault, SafetyFault::kTooFast);
        EXPECT_TRUE(!with_forces || stall_ms > 15 || safety.state == SafetyState::kActive);
      }
    }
  }
}

// A late service must not hide another fault that takes the force away.
TEST(HaplyDriver, R49_ABrakeIsToldWhileTheServiceIsLate) {
  Table table({}, {{InjectedFault::kSlowAnswers, 100 * kMs, kForever, 3.0}});
  ASSERT_TRUE(table.open().has_value());
  for (int i = 0; i < 500; ++i) table.tick({0, 0, 2});
  const auto words = [&] { return std::string(table.device->status().vendor_words.view()); };
  EXPECT_THAT(words(), HasSubstr("too slowly"));
  EXPECT_EQ(table.device->status().faults, 1u);
  table.service.report(
      R"({"name":"device-safety-triggered","category":"device","level":"error",)"
      R"("data":{"device_id":"049D","safety_type":"ebrake_triggered"},"message":"The brake"})");
  for (int i = 0; i < 50; ++i) table.tick({0, 0, 2});
  EXPECT_EQ(words(), "The brake");
  EXPECT_EQ(table.device->status().faults, 2u);
  table.service.report(
      R"({"name":"device-safety-triggered","category":"device","level":"error",)"
      R"("data":{"device_id":"049D","safety_type":"ebrake_released"},"message":"released"})");
  for (int i = 0; i < 50; ++i) table.tick({0, 0, 2});
  EXPECT_THAT(words(), HasSubstr("too slowly"));
  table.service.options().has_power = false;
  for (int i = 0; i < 50; ++i) table.tick({0, 0, 2});
  EXPECT_THAT(words(), HasSubstr("no power"));
  EXPECT_EQ(table.device->status().faults, 3u) << "that it is late was told";
}

// The last force is held, then released, and at most one message carries it.
TEST(HaplyDriver, R49_AForceIsHeldWhileAnAnswerIsLateAndThenGoesToZero) {
  Table table({}, {{InjectedFault::kNoAnswer, 50 * kMs, 500 * kMs}});
  ASSERT_TRUE(table.open().has_value());
  while (table.now_ns < 50 * kMs) table.tick({0, 0, 2});
  while (table.now_ns < 56 * kMs) table.tick({0, 0, 2});
  EXPECT_EQ(table.service.newest_force(), (Force{0, 0, 2}));
  while (table.now_ns < 70 * kMs) table.tick({0, 0, 2});
  EXPECT_EQ(table.service.newest_force(), Force{});
  EXPECT_EQ(*table.device->held_force(), Force{});
  while (table.now_ns < 490 * kMs) table.tick({0, 0, 2});
  EXPECT_EQ(table.service.max_waiting(), 2u);
  EXPECT_EQ(table.service.broken_rule(), "");
}

TEST(HaplyDriver, ADeviceThatLosesItsPowerIsAFault) {
  Table table;
  ASSERT_TRUE(table.open().has_value());
  table.push({0, 0, 1});
  table.service.options().has_power = false;
  table.tick({0, 0, 1});
  EXPECT_EQ(table.tick({0, 0, 1}).written.error(), DeviceFault::kForcesOff);
  for (int i = 0; i < 100; ++i) table.tick({0, 0, 1});
  EXPECT_EQ(table.service.asked(), Force{});
  EXPECT_THAT(std::string(table.device->status().vendor_words.view()), HasSubstr("no power"));
  EXPECT_EQ(table.device->status().faults, 1u);
  EXPECT_TRUE(table.tick().read.has_value()) << "it draws";
  table.service.options().has_power = true;
  table.tick();
  table.tick();
  EXPECT_EQ(table.device->status().fault, std::nullopt);
  EXPECT_TRUE(table.push({0, 0, 1}).written.has_value());
}

TEST(HaplyDriver, AForceHoldsForOneMessage) {
  Table table;
  ASSERT_TRUE(table.open().has_value());
  table.push({0, 0, 1});
  EXPECT_EQ(table.world.held_force(), (Force{0, 0, 1}));
  table.device->stop();
  EXPECT_EQ(table.world.held_force(), Force{});
  table.tick({0, 0, 1});
  table.service.tick(table.now_ns + 100 * kMs);  // all messages have stopped
  EXPECT_EQ(table.world.held_force(), Force{});
  table.tick({0, 0, 1});
  table.device.reset();
  EXPECT_EQ(table.world.held_force(), Force{});
}

std::string safety_event(const std::string& type, const std::string& words) {
  return R"({"name":"device-safety-triggered","category":"device","level":"error",)"
         R"("data":{"device_id":"049D","safety_type":")" +
         type + R"("},"message":")" + words + "\"}";
}

TEST(HaplyDriver, ABrakeTakesTheForceAndLeavesThePen) {
  Table table;
  ASSERT_TRUE(table.open().has_value());
  table.tick({0, 0, 1});
  table.service.report(safety_event("ebrake_triggered", "Emergency brake engaged"));
  const auto [read, written] = table.tick({0, 0, 1});
  EXPECT_TRUE(read.has_value());
  EXPECT_EQ(written.error(), DeviceFault::kForcesOff);
  EXPECT_EQ(table.service.asked(), Force{});
  EXPECT_EQ(table.device->status().vendor_words.view(), "Emergency brake engaged");
  EXPECT_EQ(table.tick({0, 0, 1}).written.error(), DeviceFault::kForcesOff)
      << "as long as it holds";
  table.service.report(safety_event("ebrake_released", "released"));
  EXPECT_TRUE(table.push({0, 0, 1}).written.has_value());
  EXPECT_EQ(table.service.asked(), (Force{0, 0, 1}));
}

TEST(HaplyDriver, AStallIsToldOnce) {
  Table table;
  ASSERT_TRUE(table.open().has_value());
  table.service.report(safety_event("stall_detected", "Motor stall"));
  EXPECT_EQ(table.tick({0, 0, 1}).written.error(), DeviceFault::kForcesOff);
  EXPECT_EQ(table.service.asked(), Force{});
  EXPECT_TRUE(table.tick({0, 0, 1}).written.has_value());
  table.service.report(R"({"name":"device-battery-low","level":"warning",)"
                       R"("data":{"device_id":"61548"},"message":"Battery at 9 %"})");
  EXPECT_TRUE(table.tick({0, 0, 1}).written.has_value());
  EXPECT_EQ(table.device->status().notice.view(), "Battery at 9 %");
}

TEST(HaplyDriver, WithoutTheEventsItDrawsAndSaysSo) {
  Table table({.has_events = false});
  ASSERT_TRUE(table.open().has_value());
  EXPECT_TRUE(table.tick({0, 0, 1}).written.has_value());
  EXPECT_THAT(std::string(table.device->status().notice.view()), HasSubstr("events"));
}

TEST(HaplyDriver, ALostDeviceIsGoneForEverAndFoundAgain) {
  Table table({}, {{InjectedFault::kUnplugged, 5 * kMs, 8 * kMs}});
  ASSERT_TRUE(table.open().has_value());
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(table.tick({0, 0, 1}).read.has_value());
  table.tick({0, 0, 1});
  EXPECT_EQ(table.world.held_force(), Force{});
  EXPECT_EQ(table.tick({0, 0, 1}).read.error(), DeviceFault::kDisconnected);
  EXPECT_TRUE(table.driver->find().empty());
  EXPECT_FALSE(table.open().has_value());
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(table.tick({0, 0, 1}).read.error(), DeviceFault::kDisconnected);
    EXPECT_FALSE(table.tick({0, 0, 1}).written.has_value());
  }
  EXPECT_EQ(table.world.held_force(), Force{});
  ASSERT_TRUE(table.open().has_value());
  EXPECT_TRUE(table.tick().read.has_value());
}

TEST(HaplyDriver, ARestartedServiceIsALostDevice) {
  Table table;
  ASSERT_TRUE(table.open().has_value());
  table.tick();
  table.service.hang_up();
  table.tick();
  EXPECT_EQ(table.tick().read.error(), DeviceFault::kDisconnected);
  ASSERT_TRUE(table.open().has_value());
  EXPECT_TRUE(table.tick().read.has_value());
}

TEST(HaplyDriver, NonsenseIsAFaultAndNoPlace) {
  for (const char* text : {"{", "[]", "null",
                           R"({"inverse3":[{"device_id":"049D","state":)"
                           R"({"cursor_position":{"x":null,"y":0,"z":0}}}]})"}) {
    Table table;
    ASSERT_TRUE(table.open().has_value());
    ASSERT_TRUE(table.tick().read.has_value());
    table.service.say_instead(text);
    table.tick();
    EXPECT_EQ(table.tick().read.error(), DeviceFault::kBadData) << text;
    table.service.say_instead("");
    table.tick();
    EXPECT_TRUE(table.tick().read.has_value()) << "it is over";
  }
}

TEST(HaplyDriver, MessagesInPiecesWithPingsBetween) {
  Table table({.fragments = true});
  ASSERT_TRUE(table.open().has_value());
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(table.tick({0, 0, 0.5}).read.has_value());
  EXPECT_EQ(table.device->status().faults, 0u);
  EXPECT_EQ(table.service.broken_rule(), "");
}

TEST(HaplyDriver, ItIsCalibratedInItsInkwell) {
  Table table({.is_calibrated = false, .calibrates_after = 6});
  ASSERT_TRUE(table.open().has_value());
  EXPECT_EQ(table.device->homing(), Homing::kInkwell);
  EXPECT_THAT(table.device->homing_words(), HasSubstr("inkwell"));
  EXPECT_EQ(table.tick().read.error(), DeviceFault::kNotCalibrated);
  while (!table.service.options().is_calibrated) table.tick();  // the user holds it there
  table.service.tick(table.now_ns);
  EXPECT_TRUE(table.device->find_home().has_value());
  EXPECT_EQ(table.device->homing(), Homing::kNone);
  EXPECT_TRUE(table.tick().read.has_value());
}

TEST(HaplyDriver, GripsOfAllKindsHaveButtons) {
  for (const char* family : {"verse_grip", "wireless_verse_grip", "custom_verse_grip"}) {
    Table table({.grip_family = family});
    ASSERT_TRUE(table.open().has_value());
    table.world.stylus().aim({40, 40, 10}, {}, 5);
    table.tick();
    table.tick();
    EXPECT_EQ(table.tick().read.value().buttons, 5u) << family;
  }
}

TEST(HaplyDriver, AGripTellsHowItIsHeld) {
  Table table;
  ASSERT_TRUE(table.open().has_value());
  for (const double held_deg : {0.0, 32.5, 60.0, 90.0}) {
    table.world.stylus().aim({{40, 40, 10}, {}, 0, held_deg});
    for (int i = 0; i < 60; ++i) table.tick();
    const std::optional<Vec3> axis = table.device->pen_axis();
    ASSERT_TRUE(axis.has_value());
    EXPECT_EQ(tilt_of_axis(fixture().turn_to_page(*axis)), held_deg);
  }
}

TEST(HaplyDriver, WhereNobodyListensNothingIsFound) {
  FakeSystem system;
  HaplyOptions options;
  int asked = 0;
  options.system = &system;
  options.connect = [&](const std::string& host, std::uint16_t port,
                        std::int64_t) -> Result<std::unique_ptr<ByteStream>> {
    ++asked;
    EXPECT_EQ(host + ":" + std::to_string(port), "127.0.0.9:123");
    return fail(ErrorCode::kNotFound, host + ": Connection refused");
  };
  system.set_environment("FELT_HAPLY_URL", "ws://127.0.0.9:123/");
  const auto driver = make_haply_driver(options);
  EXPECT_TRUE(driver->find().empty());
  EXPECT_EQ(asked, 1);
  DeviceDescriptor device;
  device.id = "haply:049D";
  const auto opened = driver->open(device, {});
  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().message, HasSubstr("feltline doctor"));
}

TEST(HaplyDoctor, NothingInstalledIsNoProblem) {
  Table table;
  const auto findings = table.driver->diagnose(table.system);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].level, FindingLevel::kAbsent);
}

TEST(HaplyDoctor, AServiceThatDoesNotRunIsStarted) {
  Table table;
  table.system.add_file("/lib/systemd/system/haply-inverse-service.service");
  const std::string text = said(table.driver->diagnose(table.system));
  EXPECT_THAT(text, HasSubstr("is not running"));
  EXPECT_THAT(text, HasSubstr("systemctl enable --now haply-inverse-service"));
}

TEST(HaplyDoctor, AnotherPortIsReadFromTheServicesConfiguration) {
  Table table;
  table.system.add_file(kConfigFile, R"({"communication/websocket/port": 8500, "x": [1]})");
  EXPECT_THAT(said(table.driver->diagnose(table.system)), HasSubstr("localhost:8500"));
  table.system.add_file(kConfigFile, "{");
  EXPECT_THAT(said(table.driver->diagnose(table.system)), HasSubstr("not valid JSON"));
  table.system.set_environment(kUrlVariable, "ws://localhost:77x");
  EXPECT_THAT(said(table.driver->diagnose(table.system)), HasSubstr("not a valid address"));
}

TEST(HaplyDoctor, ARunningServiceSaysTheRest) {
  Table table({.has_gravity_compensation = false});
  table.system.add_listener(10001);
  table.system.add_listener(10020);
  std::string text = said(table.driver->diagnose(table.system));
  EXPECT_THAT(text, HasSubstr("version 3.4.2.0"));
  EXPECT_THAT(text, HasSubstr("gravity compensation is off"));
  EXPECT_THAT(text, HasSubstr("force gate 0.30"));
  table.service.options().version = "3.0.7";
  table.service.options().has_power = false;
  table.service.tick(0);
  text = said(table.driver->diagnose(table.system));
  EXPECT_THAT(text, HasSubstr("too old"));
  EXPECT_THAT(text, HasSubstr("no power"));
}

TEST(HaplyDoctor, NoDeviceAndAnotherProgramOnThePort) {
  Table table({}, {{InjectedFault::kUnplugged, 0, 100 * kMs}});
  table.system.add_listener(10001);
  EXPECT_THAT(said(table.driver->diagnose(table.system)), HasSubstr("does not detect a device"));
  table.system.set_environment(kUrlVariable, "localhost:9999");
  table.system.add_listener(9999);
  EXPECT_THAT(said(table.driver->diagnose(table.system)), HasSubstr("does not answer like"));
}

TEST(HaplyDoctor, AnotherComputersServiceIsLookedForThere) {
  Table table;
  table.system.set_environment(kUrlVariable, "ws://10.0.0.7:10001");
  table.system.add_listener(10001);  // a listener on this computer, which is another program
  EXPECT_THAT(said(table.driver->diagnose(table.system)), HasSubstr("nothing listens at 10.0.0.7"));
  table.system.add_listener(10001, "10.0.0.7");
  EXPECT_THAT(said(table.driver->diagnose(table.system)), HasSubstr("version 3.4.2.0"));
}

// A listening socket of the fake, with a thread that serves every client. Each message of a session
// advances the world by a millisecond.
class SocketServer {
 public:
  SocketServer(FakeService& service, bool is_events) : service_(service), is_events_(is_events) {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(listen(listener_, 4), 0);
    socklen_t size = sizeof address;
    getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
  }
  SocketServer(const SocketServer&) = delete;
  SocketServer& operator=(const SocketServer&) = delete;
  ~SocketServer() {
    for (Client& client : clients_) ::close(client.socket);
    ::close(listener_);
  }
  [[nodiscard]] std::uint16_t port() const { return port_; }

  // Waits some ms for bytes and serves them.
  void serve() {
    std::vector<pollfd> waits{{listener_, POLLIN, 0}};
    for (const Client& client : clients_) waits.push_back({client.socket, POLLIN, 0});
    if (poll(waits.data(), waits.size(), 5) <= 0) return;
    for (std::size_t i = clients_.size(); i > 0; --i) {
      if (waits[i].revents != 0 && !talk(clients_[i - 1])) {
        ::close(clients_[i - 1].socket);
        clients_.erase(clients_.begin() + static_cast<std::ptrdiff_t>(i - 1));
      }
    }
    if (waits[0].revents == 0) return;
    const int other = accept(listener_, nullptr, nullptr);
    if (other >= 0) {
      clients_.push_back({other, std::make_unique<FakeService::Port>(service_, is_events_)});
    }
  }

 private:
  struct Client {
    int socket;
    std::unique_ptr<FakeService::Port> port;
  };

  bool talk(Client& client) {
    std::array<std::byte, 4096> room{};
    const ssize_t count = recv(client.socket, room.data(), room.size(), 0);
    if (count <= 0) return false;
    if (!is_events_) service_.tick(now_ns_ += kMs);
    const bool goes_on = client.port->take(std::span(room).first(static_cast<std::size_t>(count)));
    std::string& out = client.port->out();
    while (!out.empty()) {
      const ssize_t sent = ::send(client.socket, out.data(), out.size(), MSG_NOSIGNAL);
      if (sent <= 0) return false;
      out.erase(0, static_cast<std::size_t>(sent));
    }
    return goes_on && !client.port->is_answered();
  }

  FakeService& service_;
  bool is_events_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  std::int64_t now_ns_ = 0;
  std::vector<Client> clients_;
};

// Only tests that it works with real sockets and a real thread on the other end.
TEST(HaplyDriver, SpeaksThroughRealSockets) {
  FakeWorld world(*find_stylus_preset("inverse3"));
  FakeService service(world, {}, fixture());
  SocketServer control(service, false), events(service, true);
  std::atomic<bool> is_over{false};
  std::thread server([&] {
    while (!is_over) {
      control.serve();
      events.serve();
    }
  });
  {
    FakeSystem system;
    system.set_environment(kUrlVariable, "ws://localhost:" + std::to_string(control.port()));
    system.set_environment(kEventsUrlVariable, "127.0.0.1:" + std::to_string(events.port()));
    HaplyOptions options;
    options.system = &system;
    const auto driver = make_haply_driver(options);
    std::vector<DeviceDescriptor> found;
    for (int i = 0; i < 100 && found.empty(); ++i) found = driver->find();
    EXPECT_EQ(found.size(), 1u);
    if (!found.empty()) {
      auto device = driver->open(found[0], {});
      EXPECT_TRUE(device.has_value()) << (device ? "" : device.error().message);
      int good = 0;
      for (std::int64_t i = 0; device && i < 5000 && (*device)->status().reads < 25; ++i) {
        if ((*device)->read(i * kMs)) ++good;
        // On a busy machine the service is late, and the forces end.
        const auto written = (*device)->write({0.0, 0.0, 0.1});
        if (!written) {
          EXPECT_EQ(written.error(), DeviceFault::kForcesOff);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      EXPECT_GE(good, 25);
    }
  }
  is_over = true;
  server.join();
  EXPECT_EQ(service.broken_rule(), "");
  EXPECT_EQ(service.ignored_forces(), 0);
  EXPECT_GT(service.messages(), 20);
}

}  // namespace
}  // namespace felt::haply::haply_driver_test
