// Tests the driver of the 2DIY with a fake of its board, as far as they are specific to that board.
#include "felt/devices/pantograph/pantograph_driver.h"
#include "felt/base/constants.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <thread>

#include "felt/devices/pantograph/pantograph_device.h"
#include "felt/devices/pantograph/ports.h"
#include "felt/driver/open_device.h"
#include "felt/driver/testing/fake_system.h"
#include "tests/devices/drivers/pantograph/fake_board.h"
#include "tests/devices/drivers/said.h"

namespace felt::pantograph::pantograph_driver_test {
namespace {

using ::testing::HasSubstr;

constexpr const char* kPath = "/dev/ttyACM0";

// Returns a preset with the same frame for page and device.
StylusPreset preset_of(const BoardModel& model) {
  StylusPreset preset = *find_stylus_preset("inverse3");
  preset.capabilities.workspace_min = model.reach_min - Vec3{0, 0, 30};
  preset.capabilities.workspace_max = model.reach_max + Vec3{0, 0, 30};
  preset.capabilities.position_step_mm = 0.0;
  return preset;
}

class Table {
 public:
  explicit Table(std::string_view make = "v1", const std::vector<FaultWindow>& faults = {})
      : model(*find_board_model(make)),
        world(preset_of(model), faults),
        board(world, faults, model, PlaneCalibration()) {
    world.stylus().hold({});
    system.add_file(kPath);
    system.set_environment(kPortVariable, kPath + (":" + std::string(make)));
    PantographOptions options;
    options.open = [this](const std::string& path) { return board.open(path); };
    options.system = &system;
    driver = make_pantograph_driver(options);
  }

  Result<void> open(const OpenOptions& options = {}) {
    auto opened = driver->open(driver->find().at(0), options);
    if (!opened) return tl::unexpected(opened.error());
    device = *std::move(opened);
    return {};
  }
  bool open_at_home() { return open().has_value() && device->find_home().has_value(); }

  struct Ticked {
    tl::expected<PenSample, DeviceFault> read;
    tl::expected<void, DeviceFault> written;
  };
  Ticked tick(const Force& force = {}) {
    board.tick(now_ns);
    auto read = device->read(now_ns);
    auto written = device->write(force);
    now_ns += kMs;
    return {read, written};
  }
  /// Runs as many ticks as a force needs to rise to this value.
  Ticked push(const Force& force) {
    for (int i = 0; i < 8; ++i) static_cast<void>(tick(force));
    return tick(force);
  }

  const BoardModel& model;
  FakeSystem system;
  FakeWorld world;
  FakeBoard board;
  std::unique_ptr<Driver> driver;
  std::unique_ptr<DriverDevice> device;
  std::int64_t now_ns = 0;
};

TEST(PantographDriver, NobodyKnowsTheMake) {
  Table table;
  const auto named = table.driver->find();
  ASSERT_EQ(named.size(), 1u);
  EXPECT_EQ(named[0].id, "pantograph:v1:ttyACM0");
  EXPECT_FALSE(named[0].is_connected);
  EXPECT_EQ(named[0].capabilities.actuated_axes, 2);
  table.system.set_environment(kPortVariable, "");
  EXPECT_TRUE(table.driver->find().empty());
  const std::string name = "usb-Arduino__www.arduino.cc__Arduino_Due-if00";
  table.system.add_file("/dev/ttyACM3").add_link("/dev/serial/by-id/" + name, "../../ttyACM3");
  table.system.add_link("/dev/serial/by-id/usb-Quectel_modem-if00", "../../ttyACM4");
  const auto found = table.driver->find();
  ASSERT_EQ(found.size(), 3u) << "once for each make";
  EXPECT_EQ(found[1].id, "pantograph:v2:" + name);
}

TEST(PantographDriver, EachMakeSaysWhereItIsAndPushesTheRightWay) {
  for (const BoardModel& model : board_models()) {
    Table table(model.id);
    ASSERT_TRUE(table.open_at_home());
    const Vec3 middle = 0.5 * (model.reach_min + model.reach_max);
    table.world.stylus().place(middle);
    table.tick();
    const auto read = table.tick().read;
    ASSERT_TRUE(read.has_value());
    EXPECT_NEAR(read->position.x, middle.x, 0.3) << model.id;
    EXPECT_NEAR(read->position.y, middle.y, 0.3) << model.id;
    for (const Force& force : {Force{1, 0, 0}, Force{0, 1, 0}, Force{-0.6, 0.8, 0}}) {
      ASSERT_TRUE(table.push(force).written.has_value());
      EXPECT_NEAR(norm(table.world.held_force() - force), 0.0, 0.01) << model.id;
    }
    EXPECT_EQ(table.board.broken_rule(), "") << model.id;
  }
}

// The device cannot push out of the surface; along it, forces have the direction of the page's
// axes.
TEST(PantographDriver, ForcesPointTheRightWayThroughTheUsualPlane) {
  Table table;
  ASSERT_TRUE(table.open_at_home());
  const PlaneCalibration plane = table.driver->default_plane(table.device->descriptor(), {});
  EXPECT_TRUE(plane.mirrors());
  OpenDevice device(*table.device, plane);
  std::int64_t t = 0;
  const auto held = [&](const Force& on_page) {
    for (int i = 0; i < 8; ++i, t += kMs) {
      table.board.tick(t);
      EXPECT_TRUE(device.read(t).has_value());
      EXPECT_TRUE(device.write(on_page).has_value());
    }
    return table.world.held_force();
  };
  EXPECT_NEAR(norm(held({1, 0, 0}) - Force{-1, 0, 0}), 0.0, 0.01) << "right is the board's -x";
  EXPECT_NEAR(norm(held({0, 1, 0}) - Force{0, 1, 0}), 0.0, 0.01) << "down is towards the person";
  EXPECT_EQ(held({0, 0, 1}), Force{});
  EXPECT_NEAR(device.read(t)->position.x, 0.0, 5.0) << "the middle of the reach is the origin";
  EXPECT_NEAR(device.read(t)->position.y, 0.0, 5.0);
}

TEST(PantographDriver, AKeySaysWhenThePenTouches) {
  Table table;
  ASSERT_TRUE(table.open({.pen_begins_down = false}).has_value());
  ASSERT_TRUE(table.device->find_home().has_value());
  EXPECT_GT(table.tick().read->position.z, 0.0);
  table.device->set_pen_down(true);
  EXPECT_LT(table.tick().read->position.z, 0.0);
  EXPECT_TRUE(in_contact(*table.tick().read));
  EXPECT_EQ(table.tick().read->velocity.z, 0.0);
}

TEST(PantographDriver, ItCountsFromRest) {
  Table table;
  ASSERT_TRUE(table.open().has_value());
  EXPECT_EQ(table.device->homing(), Homing::kRestPose);
  EXPECT_EQ(table.tick({1, 0, 0}).read.error(), DeviceFault::kNotCalibrated);
  EXPECT_EQ(table.board.largest_asked_n(), 0.0) << "no force before it knows where it is";
  EXPECT_FALSE(table.device->homing_words().empty());
  ASSERT_TRUE(table.device->find_home().has_value());
  EXPECT_EQ(table.device->homing(), Homing::kNone);
  EXPECT_TRUE(table.tick().read.has_value());
}

TEST(PantographDriver, ForcesAreBoundedAndFadeWhereTheArmsComeIntoLine) {
  Table table("v2");
  ASSERT_TRUE(table.open_at_home());
  table.push({100, 0, 0});
  EXPECT_LE(table.board.largest_asked_n(), 1.5);
  EXPECT_EQ(table.tick({std::nan(""), 0, 0}).written.error(), DeviceFault::kBadData);
  EXPECT_EQ(table.world.held_force(), Force{});
  table.push({HUGE_VAL, 0, 0});
  EXPECT_LE(table.board.largest_asked_n(), 1.5);
  Table far("v2");
  ASSERT_TRUE(far.open_at_home());
  FakeWorld& world = far.world;
  world.stylus().place({0, 125, 0});
  far.tick();
  far.push({0, 1, 0});
  EXPECT_NEAR(norm(world.held_force()), 1.0, 0.02);
}

TEST(PantographDriver, R49_WhatIsLoggedIsWhatTheTorquesPushWith) {
  Table table("v2");
  ASSERT_TRUE(table.open_at_home());
  const auto is_true = [&] {
    return norm(*table.device->held_force() - table.board.newest_force()) < 1e-4;
  };
  table.world.stylus().place({0, 125, 0});
  table.tick();
  table.push({0, 0.4, 0});
  EXPECT_TRUE(is_true());
  EXPECT_NEAR(norm(*table.device->held_force()), 0.4, 1e-4);
  table.board.refuse_frames(1);
  table.tick({0, 1, 0});
  EXPECT_TRUE(is_true()) << "a frame that did not go pushes with nothing";
  table.push({0.3, 0.8, 0});
  EXPECT_TRUE(is_true());
  table.device->stop();
  EXPECT_EQ(table.device->held_force(), Force{});
}

TEST(PantographDriver, ShortAnswersWrongIdsAndNoiseAreFaultsAndOver) {
  Table table;
  ASSERT_TRUE(table.open_at_home());
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(table.tick().read.has_value());

  table.board.answer_as(9);
  table.tick({1, 0, 0});
  const auto wrong = table.tick({1, 0, 0});
  EXPECT_EQ(wrong.read.error(), DeviceFault::kBadData);
  EXPECT_EQ(table.world.held_force(), Force{}) << "no force where it does not know the angles";
  table.board.answer_as(kDeviceId);
  table.tick();
  EXPECT_TRUE(table.tick().read.has_value());

  table.board.babble({std::byte{5}, std::byte{5}, std::byte{0xFF}});
  bool was_bad = false;
  for (int i = 0; i < 6; ++i) was_bad = !table.tick().read.has_value() || was_bad;
  EXPECT_TRUE(was_bad);
  EXPECT_TRUE(table.tick().read.has_value()) << "what waits is thrown away, the next is whole";

  table.board.cut_answers(3);
  std::optional<DeviceFault> fault;
  for (int i = 0; i < 3 * PantographDevice::kMaxMissed && !fault; ++i) {
    if (const auto read = table.tick().read; !read) fault = read.error();
  }
  EXPECT_EQ(fault, DeviceFault::kBadData);
  table.board.cut_answers(0);
  for (int i = 0; i < 8; ++i) table.tick();
  EXPECT_TRUE(table.tick().read.has_value());
}

TEST(PantographDriver, ASilentBoardIsAFaultAndThenGone) {
  Table table;
  ASSERT_TRUE(table.open_at_home());
  table.tick();
  table.board.be_silent(true);
  table.tick();
  for (int i = 0; i < PantographDevice::kMaxMissed; ++i) {
    EXPECT_TRUE(table.tick().read.has_value()) << i;
  }
  EXPECT_EQ(table.tick({1, 0, 0}).read.error(), DeviceFault::kOther);
  EXPECT_EQ(table.world.held_force(), Force{});
  for (int i = 0; i < PantographDevice::kMaxSilentTicks; ++i) table.tick();
  EXPECT_EQ(table.tick().read.error(), DeviceFault::kDisconnected);
  table.board.be_silent(false);
  EXPECT_EQ(table.tick().read.error(), DeviceFault::kDisconnected) << "for ever";
}

// If a frame was not sent, the previous torque still holds, and the caller gets an error.
TEST(PantographDriver, AFrameThatDidNotGoIsAFault) {
  Table table;
  ASSERT_TRUE(table.open_at_home());
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(table.tick({1, 0, 0}).written.has_value());
  table.board.refuse_frames(1);
  const auto ticked = table.tick({0.5, 0, 0});
  EXPECT_TRUE(ticked.read.has_value());
  ASSERT_FALSE(ticked.written.has_value());
  EXPECT_EQ(ticked.written.error(), DeviceFault::kOther);
  EXPECT_GT(norm(table.world.held_force()), 0.9);
  EXPECT_EQ(table.device->status().last_fault, DeviceFault::kOther);
  EXPECT_THAT(std::string(table.device->status().vendor_words.view()),
              HasSubstr("does not accept data"));
  ASSERT_TRUE(table.tick({0.5, 0, 0}).written.has_value()) << "the next goes";
  EXPECT_NEAR(norm(table.world.held_force()), 0.5, 0.01);
}

TEST(PantographDriver, LettingGoIsTriedAgain) {
  Table table;
  ASSERT_TRUE(table.open_at_home());
  table.tick({1, 0, 0});
  table.board.refuse_frames(PantographDevice::kStopTries - 1);
  table.device->stop();
  EXPECT_EQ(table.world.held_force(), Force{});
  table.push({1, 0, 0});
  EXPECT_GT(norm(table.world.held_force()), 0.9);
  table.board.refuse_frames(PantographDevice::kEndTries - 1);
  table.device.reset();
  EXPECT_EQ(table.world.held_force(), Force{}) << "at the end there is more time";
}

// The port accepts nothing for a moment while the board is set up. A board that was not set up
// ignores torques, but still releases the motors. Found by device_fuzz, seed 1005974.
TEST(PantographDriver, ABoardThatIsNotSetUpHearsNoTorques) {
  Table table;
  table.board.refuse_frames(1);
  EXPECT_FALSE(table.open().has_value()) << "it could not be told to begin anew";
  EXPECT_EQ(table.board.broken_rule(), "");
  EXPECT_EQ(table.board.resets(), 1) << "it was in the end";

  ASSERT_TRUE(table.open_at_home());
  table.push({1, 0, 0});
  EXPECT_GT(norm(table.world.held_force()), 0.9);
  table.board.refuse_frames(1);
  EXPECT_FALSE(table.device->find_home().has_value());
  const auto ticked = table.tick({1, 0, 0});
  EXPECT_FALSE(ticked.read.has_value());
  ASSERT_FALSE(ticked.written.has_value());
  EXPECT_EQ(ticked.written.error(), DeviceFault::kNotCalibrated);
  table.device->stop();
  EXPECT_EQ(table.world.held_force(), Force{});
  EXPECT_EQ(table.board.broken_rule(), "");
  ASSERT_TRUE(table.device->find_home().has_value());
  EXPECT_TRUE(table.tick({1, 0, 0}).written.has_value());
}

// Returns the first fault within this number of ticks with a force.
std::optional<DeviceFault> first_fault(Table& table, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    const auto [read, written] = table.tick({1, 0, 0});
    if (!written) return written.error();
    if (!read) return read.error();
  }
  return std::nullopt;
}

// The hung board keeps its force whatever the driver sends. When it continues, none of the waiting
// messages leaves a force, and no force returns until the user has read of the fault.
TEST(PantographDriver, AHungBoardIsAFaultAndLetsGoWhenItGoesOn) {
  for (const std::size_t room : {std::size_t{0}, std::size_t{20}, std::size_t{4096}}) {
    Table table;
    ASSERT_TRUE(table.open_at_home());
    for (int i = 0; i < 5; ++i) table.tick({1, 0, 0});
    table.board.hang(room);
    ASSERT_EQ(first_fault(table, 20), DeviceFault::kOther) << room;
    table.device->stop();  // as the servo does, which then requests no force
    for (int i = 0; i < 20; ++i) table.tick({});
    EXPECT_GT(norm(table.world.held_force()), 0.9) << "nobody can help it";
    std::vector<std::byte> out;
    table.board.go_on(out);
    for (int i = 0; i < 2; ++i) table.tick({});
    EXPECT_EQ(table.world.held_force(), Force{}) << room;
    EXPECT_EQ(table.board.broken_rule(), "");
  }
}

TEST(PantographDriver, AGuardKnowsTheFrameThatLetsGo) {
  Table table;
  ASSERT_TRUE(table.open_at_home());
  table.push({1, 0, 0});
  ASSERT_GT(norm(table.world.held_force()), 0.9);
  std::vector<std::byte> out;
  table.board.take(table.board.last_words(), out);
  EXPECT_EQ(table.world.held_force(), Force{});
  EXPECT_TRUE(table.tick().read.has_value()) << "its answer is no harm";
}

// Its motors have no watchdog, so no force is allowed without the guard process that replaces it.
TEST(PantographDriver, WithoutAGuardNothingPushes) {
  Table table;
  table.board.refuse_guards(true);
  const auto opened = table.open();
  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().message, HasSubstr("The second process"));
  table.board.refuse_guards(false);
  ASSERT_TRUE(table.open());
  table.board.refuse_guards(true);
  const auto home = table.device->find_home();
  ASSERT_FALSE(home.has_value());
  EXPECT_THAT(home.error().message, HasSubstr("The second process"));
  for (int i = 0; i < 3; ++i) table.tick({1, 0, 0});
  EXPECT_EQ(table.world.held_force(), Force{});
  table.board.refuse_guards(false);
  ASSERT_TRUE(table.device->find_home().has_value());
  table.push({1, 0, 0});
  ASSERT_GT(norm(table.world.held_force()), 0.9);
  table.board.kill_guard();
  const auto written = table.tick({1, 0, 0}).written;
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error(), DeviceFault::kForcesOff);
  EXPECT_EQ(table.world.held_force(), Force{});
  ASSERT_TRUE(table.device->find_home().has_value()) << "with another one";
  table.tick({1, 0, 0});
  EXPECT_TRUE(table.tick({1, 0, 0}).written.has_value());
}

// The user states the make of the board. Before any force, the driver says what to measure.
TEST(PantographDriver, SaysWhichMakeItIsTakenFor) {
  for (const BoardModel& model : board_models()) {
    Table table(model.id);
    ASSERT_TRUE(table.open());
    const std::string words = table.device->homing_words();
    EXPECT_THAT(words, HasSubstr(std::string(model.label)));
    const bool warns = words.find("more than ten times as strong") != std::string::npos;
    EXPECT_EQ(warns, model.id != "v1") << words;
  }
}

TEST(PantographDriver, ABoardThatWasGivenUpIsLetGoOfAtTheEnd) {
  Table table;
  ASSERT_TRUE(table.open_at_home());
  for (int i = 0; i < 5; ++i) table.tick({1, 0, 0});
  table.board.hang(0);
  for (int i = 0; i < PantographDevice::kMaxSilentTicks + 5; ++i) table.tick({1, 0, 0});
  ASSERT_EQ(table.tick().read.error(), DeviceFault::kDisconnected);
  std::vector<std::byte> out;
  table.board.go_on(out);
  EXPECT_GT(norm(table.world.held_force()), 0.9);
  table.device.reset();
  EXPECT_EQ(table.world.held_force(), Force{});
}

TEST(PantographDriver, APulledPlugIsGoneForEver) {
  Table table("v1", {{InjectedFault::kUnplugged, 3 * kMs, 6 * kMs}});
  ASSERT_TRUE(table.open_at_home());
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(table.tick({1, 0, 0}).read.has_value());
  const auto [read, written] = table.tick({1, 0, 0});
  EXPECT_EQ(read.error(), DeviceFault::kDisconnected);
  EXPECT_EQ(written.error(), DeviceFault::kDisconnected);
  EXPECT_EQ(table.world.held_force(), Force{});
  EXPECT_FALSE(table.open().has_value()) << "there is no port";
  for (int i = 0; i < 5; ++i) table.board.tick(table.now_ns += kMs);
  EXPECT_TRUE(table.open_at_home()) << "plugged in again";
  EXPECT_TRUE(table.tick().read.has_value());
}

TEST(PantographDriver, SomethingElseOnThePortSaysSo) {
  Table table;
  table.board.be_silent(true);
  const auto opened = table.open();
  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().message, HasSubstr("does not answer like a 2DIY"));
}

TEST(PantographDoctor, SaysWhatIsMissing) {
  Table table;
  table.system.set_environment(kPortVariable, "");
  auto findings = table.driver->diagnose(table.system);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].level, FindingLevel::kAbsent);

  table.system.set_environment(kPortVariable, kPath);
  table.system.remove(kPath);
  EXPECT_THAT(said(table.driver->diagnose(table.system)), HasSubstr("does not exist"));
  EXPECT_TRUE(table.driver->find().empty());

  table.system.add_file(kPath).forbid(kPath).add_file("/usr/sbin/ModemManager");
  findings = table.driver->diagnose(table.system);
  EXPECT_THAT(said(findings), HasSubstr("Permission denied"));
  EXPECT_THAT(said(findings), HasSubstr("usermod -aG dialout ada"));
  EXPECT_THAT(said(findings), HasSubstr("ModemManager"));
  ASSERT_TRUE(findings[0].fix.has_value());
  EXPECT_THAT(findings[0].fix->content, HasSubstr("ID_MM_DEVICE_IGNORE"));

  table.system.set_user("ada", {"dialout"}).allow(kPath).add_file(findings[0].fix->path);
  findings = table.driver->diagnose(table.system);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].level, FindingLevel::kOk);
}

// Simulates the board at the other end of a line until `is_over`.
void answer(int line, FakeBoard& board, const std::atomic<bool>& is_over) {
  std::array<std::byte, 64> room{};
  std::vector<std::byte> out;
  while (!is_over) {
    pollfd waits{.fd = line, .events = POLLIN, .revents = 0};
    if (poll(&waits, 1, 20) <= 0) continue;
    const ssize_t count = ::read(line, room.data(), room.size());
    if (count <= 0) return;
    out.clear();
    board.take(std::span(room).first(static_cast<std::size_t>(count)), out);
    if (!out.empty() && ::write(line, out.data(), out.size()) < 0) return;
  }
}

// Only tests that it works with a real terminal and a real thread on the other end.
TEST(PantographDriver, SpeaksThroughARealTerminal) {
  const int board_end = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_GE(board_end, 0);
  ASSERT_EQ(grantpt(board_end), 0);
  ASSERT_EQ(unlockpt(board_end), 0);
  std::array<char, 128> name{};
  ASSERT_EQ(ptsname_r(board_end, name.data(), name.size()), 0);

  Table table;
  std::atomic<bool> is_over{false};
  // The computer's end is opened first, because the board would otherwise receive its own echo.
  auto port = SerialStream::open(name.data());
  ASSERT_TRUE(port.has_value()) << port.error().message;
  std::thread board([&] { answer(board_end, table.board, is_over); });
  {
    DeviceDescriptor descriptor = table.driver->find().at(0);
    PantographDevice device(*std::move(port), table.model, descriptor, {});
    const Result<void> home = device.find_home();
    EXPECT_TRUE(home.has_value()) << (home ? "" : home.error().message);
    int good = 0;
    for (std::int64_t i = 0; i < 2000 && good < 50; ++i) {
      if (device.read(i * kMs)) ++good;
      EXPECT_TRUE(device.write({0.1, 0, 0}).has_value());
      usleep(200);
    }
    EXPECT_EQ(good, 50);
  }
  is_over = true;
  board.join();
  ::close(board_end);
  EXPECT_EQ(table.board.broken_rule(), "");
}

}  // namespace
}  // namespace felt::pantograph::pantograph_driver_test
