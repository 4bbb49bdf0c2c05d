#include "record_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_reader.h"
#include "felt/tools/tool.h"
#include "felt/validate/driver_subject.h"
#include "record_copy.h"
#include "tests/support/scratch_path.h"

namespace felt::cli {
namespace {

/// What a driver and its devices have in common; written by the loop's thread, too.
struct World {
  std::atomic<int> opened{0};
  std::atomic<int> looks{0};
  std::atomic<double> largest_n{0.0};
  std::atomic<bool> is_gone{false};
  std::atomic<bool> hangs{false};
  std::atomic<int> stops{0};
  int gone_after_reads = 400;  ///< of the first device that is opened
  int hangs_after_reads = 1 << 30;
  bool never_comes_back = false;
  std::atomic<int> refusals{0};  ///< of open(), once the first was open
  std::atomic<int> refused{0};   ///< so far
  ErrorCode refusal = ErrorCode::kIo;
  bool is_calm = false;  ///< up and down without leaps, which latch the chain
};

/// A pen that draws zigzags into the plane by itself, 0.2 s down and 0.1 s up; real threads.
class ZigzagDevice final : public DriverDevice {
 public:
  ZigzagDevice(World& world, DeviceDescriptor descriptor, bool fails)
      : world_(world), descriptor_(std::move(descriptor)), fails_(fails) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "zigzag"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return descriptor_.capabilities;
  }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] DeviceStatus status() noexcept override {
    DeviceStatus status;
    if (is_gone_) {
      status.fault = status.last_fault = DeviceFault::kDisconnected;
      status.vendor_words = ShortText("cable error 17");
    }
    return status;
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    if (fails_ && ++reads_ > world_.gone_after_reads) is_gone_ = true;
    if (reads_ == world_.hangs_after_reads) world_.hangs = true;
    while (world_.hangs) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (is_gone_) world_.is_gone = true;
    if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
    const double t = 1e-9 * static_cast<double>(now_ns);
    const double phase = std::fmod(t, 0.3);
    PenSample sample;
    sample.time_ns = now_ns;
    // Each at a place of its own: strokes that meet may become one.
    const double row = std::fmod(std::floor(t / 0.3), 16.0);
    sample.position = {50.0 * phase + 40.0 * world_.opened,
                       12.0 * row + 2.0 * std::sin(20.0 * phase), phase < 0.2 ? -1.0 : 2.0};
    if (world_.is_calm) {
      sample.position = {20.0 + 10.0 * std::sin(3.0 * t), 10.0, 0.5 - 1.5 * std::sin(8.0 * t)};
    }
    return sample;
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    if (norm(force) > world_.largest_n.load()) world_.largest_n.store(norm(force));
    return {};
  }
  void stop() noexcept override { ++world_.stops; }

 private:
  World& world_;
  DeviceDescriptor descriptor_;
  bool fails_;
  int reads_ = 0;
  std::atomic<bool> is_gone_{false};
};

class ZigzagDriver final : public Driver {
 public:
  explicit ZigzagDriver(World& world) : world_(world) {
    device_.id = "zigzag:1";
    device_.driver = "zigzag";
    device_.label = "Zigzag";
    device_.has_own_frame = false;
    device_.capabilities.max_force_n = 3.0;
    device_.capabilities.continuous_force_n = 1.0;
    device_.capabilities.max_stiffness_n_per_m = 400.0;
    device_.capabilities.max_damping_n_s_per_m = 4.0;
  }
  [[nodiscard]] std::string_view name() const noexcept override { return "zigzag"; }
  [[nodiscard]] std::string_view label() const noexcept override { return "Zigzag"; }
  std::vector<DeviceDescriptor> find() override {
    if (world_.never_comes_back || ++world_.looks < 2) return {};
    return {device_};
  }
  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor&, const OpenOptions&) override {
    if (world_.opened > 0 && world_.refused < world_.refusals) {
      ++world_.refused;
      return fail(world_.refusal, "not now");
    }
    const bool is_first = world_.opened++ == 0;
    DeviceDescriptor open = device_;
    open.serial = serial_once_open_;
    return std::unique_ptr<DriverDevice>(std::make_unique<ZigzagDevice>(world_, open, is_first));
  }
  std::vector<Finding> diagnose(const SystemView&) override { return {}; }
  [[nodiscard]] const DeviceDescriptor& device() const noexcept { return device_; }
  void give_own_frame() { device_.has_own_frame = true; }
  void tell_serial_once_open(std::string serial) { serial_once_open_ = std::move(serial); }

 private:
  World& world_;
  DeviceDescriptor device_;
  std::string serial_once_open_;
};

struct Drawn {
  std::size_t strokes = 0;
  bool hangs = false;
  std::string error;
  bool ran_backwards = false;
  std::int64_t last_ns = 0;
};

Drawn draw(World& world, const std::function<bool(const Session&)>& is_enough, bool forces,
           RecordOptions options = {}) {
  ZigzagDriver driver(world);
  const RealDevice device{&driver, driver.device(), {.device_id = "zigzag:1"}};
  Drawn drawn;
  Session session(make_tools(), {.device = {},
                                 .document = {},
                                 .on_event =
                                     [&drawn](const Event& event) {
                                       drawn.ran_backwards |= event.time_ns < drawn.last_ns;
                                       drawn.last_ns = event.time_ns;
                                     },
                                 .on_edit = {}});
  Console console;
  console.set_quiet();
  options.asks = false;
  options.forces = forces;
  options.seconds = 60.0;  // a hang is a failure, not a hang
  options.is_over = [&] { return is_enough(session); };
  RecordRun run(device, session, console, nullptr, options);
  const Result<void> begun = run.begin();
  EXPECT_TRUE(begun) << begun.error().message;
  const Result<void> done = run.draw();
  if (!done) drawn.error = done.error().message;
  drawn.hangs = run.hangs();
  drawn.strokes = session.document().stroke_count();
  return drawn;
}

TEST(RecordRunTest, DrawsGoesOnAfterTheDeviceWasGoneAndKeepsTheInk) {
  World world;
  std::size_t before = 0;
  const Drawn drawn = draw(
      world,
      [&](const Session& session) {
        const std::size_t strokes = session.document().stroke_count();
        if (world.opened == 1) before = strokes;
        return world.opened == 2 && strokes >= before + 3;
      },
      false);
  EXPECT_EQ(drawn.error, "");
  EXPECT_EQ(world.opened, 2);
  EXPECT_GE(before, 1U);
  EXPECT_GE(drawn.strokes, before + 3);
  EXPECT_FALSE(drawn.ran_backwards);
  EXPECT_EQ(world.largest_n.load(), 0.0) << "nobody asked for forces";
}

TEST(RecordRunTest, R14_TheSessionKnowsTheForceLimit) {
  World world;
  double told_n = 0.0;
  RecordOptions options;
  options.force_limit_n = 0.3;
  draw(
      world,
      [&](const Session& session) {
        told_n = session.device().advised_force_n;
        return session.document().stroke_count() >= 1;
      },
      false, options);
  EXPECT_EQ(told_n, 0.3);
}

TEST(RecordRunTest, APortThatIsNotFreeYetIsTriedAgain) {
  World world;
  world.refusals = 2;
  const Drawn drawn = draw(
      world, [](const Session& session) { return session.document().stroke_count() >= 3; }, false);
  EXPECT_EQ(drawn.error, "");
  EXPECT_EQ(world.refused, 2);
  EXPECT_EQ(world.opened, 2);
}

// Or somebody who said no would be asked twice a second.
TEST(RecordRunTest, WhatAPersonRefusedWaitsForThem) {
  World world;
  world.refusals = 1 << 30;
  world.refusal = ErrorCode::kUnsupported;
  int turns = 0;
  bool pressed = false;
  RecordOptions options;
  options.enter_pressed = [&] {
    if (world.refused > 0) ++turns;  // one look in half a second
    return turns == 3 && !std::exchange(pressed, true);
  };
  const Drawn drawn = draw(
      world, [&](const Session&) { return world.refused >= 2; }, false, options);
  EXPECT_EQ(drawn.error, "");
  EXPECT_TRUE(pressed);
  EXPECT_EQ(turns, 3) << "asked again before somebody wanted it";
}

TEST(RecordRunTest, EndsWithTheInkWhereTheDeviceStaysAway) {
  World world;
  world.never_comes_back = true;
  int asked = 0;
  const Drawn drawn = draw(
      world, [&](const Session&) { return world.is_gone && ++asked > 3; }, false);
  EXPECT_GE(drawn.strokes, 1U);
}

TEST(RecordRunTest, ForcesComeOnlyWhenAskedFor) {
  World world;
  world.is_calm = true;
  world.gone_after_reads = 1 << 30;
  int turns = 0;
  RecordOptions options;
  // Again and again: late ticks of a busy machine latch the chain.
  options.enter_pressed = [&] { return ++turns % 300 == 0; };
  draw(
      world, [&](const Session&) { return world.largest_n > 0.0; }, true, options);
  EXPECT_GT(world.largest_n.load(), 0.0);
  EXPECT_LE(world.largest_n.load(), 2.7 + 1e-9);  // 0.9 of its maximum
}

TEST(RecordRunTest, ForcesStayOffAfterALostDeviceUntilSomebodyAllowsThem) {
  World world;
  world.is_calm = true;
  bool was_lost = false;
  int turns_without = 0;
  double without_n = -1.0;
  RecordOptions options;
  options.enter_pressed = [&] {
    if (world.opened < 2 || ++turns_without % 300 != 0) return false;
    // Again and again: late ticks of a busy machine latch the chain.
    if (without_n < 0.0) without_n = world.largest_n;
    return true;
  };
  draw(
      world,
      [&](const Session&) {
        if (world.opened == 2 && !std::exchange(was_lost, true)) world.largest_n = 0.0;
        return turns_without > 300 && world.largest_n > 0.0;
      },
      true, options);
  EXPECT_EQ(without_n, 0.0) << "forces came back by themselves";
  EXPECT_GT(world.largest_n.load(), 0.0) << "Enter allows them again";
}

TEST(RecordRunTest, TheFirstEnterShowsWhatOneAgreesTo) {
  World world;
  world.is_calm = true;
  world.gone_after_reads = 1 << 30;
  int turns = 0;
  double after_first_n = -1.0;
  RecordOptions options;
  options.consent = "It will push.";
  options.enter_pressed = [&] {
    if (++turns == 300) after_first_n = world.largest_n;
    return turns == 1 || turns % 300 == 0;
  };
  testing::internal::CaptureStderr();
  draw(
      world, [&](const Session&) { return turns > 300 && world.largest_n > 0.0; }, false, options);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::HasSubstr("It will push."));
  EXPECT_EQ(after_first_n, 0.0);
  EXPECT_GT(world.largest_n.load(), 0.0);
}

TEST(RecordRunTest, WhileTheProgramIsStoppedThereIsNoForceAndNoneAfterwards) {
  World world;
  world.is_calm = true;
  world.gone_after_reads = 1 << 30;
  int pauses = 0, turns_after = 0, stops_before_pause = 0;
  RecordOptions options;
  options.wants_pause = [&] { return pauses == 0 && world.largest_n > 0.0; };
  options.pause = [&] {
    ++pauses;
    stops_before_pause = world.stops;
    world.largest_n = 0.0;
  };
  const Drawn drawn = draw(
      world, [&](const Session&) { return pauses == 1 && ++turns_after > 400; }, true, options);
  EXPECT_EQ(drawn.error, "");
  EXPECT_EQ(pauses, 1);
  EXPECT_EQ(stops_before_pause, 1);
  EXPECT_EQ(world.largest_n.load(), 0.0) << "forces came back by themselves";
  EXPECT_FALSE(drawn.ran_backwards);
  EXPECT_EQ(world.opened, 1);
}

TEST(RecordRunTest, ADeviceThatHangsIsGivenUpAndTheInkStays) {
  static World world;  // the given-up one may come back at any time
  world.hangs_after_reads = 1000;
  world.gone_after_reads = 1 << 30;
  const Drawn drawn = draw(
      world, [](const Session&) { return false; }, false);
  EXPECT_TRUE(drawn.hangs);
  EXPECT_GE(drawn.strokes, 1U);
  EXPECT_THAT(drawn.error, testing::HasSubstr("hangs"));
  EXPECT_EQ(world.opened, 1);
  EXPECT_EQ(world.stops, 0);
  world.hangs = false;
  while (world.stops == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(RecordRunTest, ACopyOfTheDrawingIsThereWhileItIsMade) {
  World world;
  world.gone_after_reads = 1 << 30;
  const std::string output = scratch_path("record-copy.felt");
  RecordCopy copy(output, std::chrono::milliseconds(20));
  EXPECT_TRUE(copy.path().starts_with(output + ".unsaved-"));
  std::string kept;
  RecordOptions options;
  options.keep = [&](const Session& session) {
    copy.note_edit();
    copy.keep(session);
  };
  const Drawn drawn = draw(
      world,
      [&](const Session& session) {
        if (session.document().stroke_count() < 2) return false;
        std::ostringstream text;
        text << std::ifstream(copy.path()).rdbuf();
        kept = text.str();
        return std::count(kept.begin(), kept.end(), '\n') >= 2;
      },
      false, options);
  EXPECT_GE(drawn.strokes, 2U);
  EXPECT_EQ(kept.back(), '\n');
  EXPECT_EQ(kept.rfind("{\"id\":", 0), 0U) << kept.substr(0, 80);
  copy.remove();
  EXPECT_FALSE(std::filesystem::exists(copy.path()));
  EXPECT_TRUE(RecordCopy("-").path().starts_with(std::filesystem::temp_directory_path().string()));
}

/// A pen that is moved along a circle; no force, pressure says that it touches.
void draw_arc(Session& session, int from, int to) {
  for (int i = from; i < to; ++i) {
    PenSample sample;
    sample.time_ns = std::int64_t{1'000'000} * (i + 1);
    const double angle = 0.002 * i;
    sample.position = {40.0 * std::cos(angle), 40.0 * std::sin(angle), i < 5 ? 2.0 : -0.5};
    sample.pressure = i < 5 ? 0.0 : 0.5;
    ASSERT_TRUE(session.sample(sample));
  }
}

/// Returns what a new copy holds, read as the program reads it. A copy is not due at every turn:
/// the next one waits for 50 times as long as the last one took.
Sketch read_copy(RecordCopy& copy, const Session& session) {
  std::filesystem::remove(copy.path());
  for (int turn = 0; turn < 2000 && !std::filesystem::exists(copy.path()); ++turn) {
    copy.keep(session);
    copy.wait();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  Result<OpenedDrawing> opened = read_drawing(copy.path());
  return opened ? visible_strokes(opened->drawing.document) : Sketch();
}

TEST(RecordCopyTest, HasTheStrokeInProgress) {
  const std::string path = scratch_path("in_progress");
  RecordCopy copy(path, std::chrono::seconds(0));
  Session session(make_tools(), {});
  draw_arc(session, 0, 2000);
  ASSERT_EQ(session.document().stroke_count(), 0U);
  const Sketch one = read_copy(copy, session);
  ASSERT_EQ(one.size(), 1U);
  draw_arc(session, 2000, 4000);  // more of the same stroke, and no edit
  const Sketch more = read_copy(copy, session);
  ASSERT_EQ(more.size(), 1U);
  const auto length_mm = [](const Stroke& stroke) {
    double length = 0.0;
    for (int i = 0; i < stroke.segment_count(); ++i) length += control_length(stroke.segment(i));
    return length;
  };
  EXPECT_NEAR(length_mm(one[0].stroke), 40.0 * 0.002 * 2000, 3.0);
  EXPECT_NEAR(length_mm(more[0].stroke), 40.0 * 0.002 * 4000, 3.0);
  ASSERT_TRUE(session.finish());
  copy.note_edit();
  EXPECT_EQ(read_copy(copy, session).size(), session.document().stroke_count());
  copy.remove();
}

TEST(RecordCopyTest, IsNotWrittenBeforeThereIsInk) {
  RecordCopy copy(scratch_path("no_ink"), std::chrono::seconds(0));
  Session session(make_tools(), {});
  draw_arc(session, 0, 6);
  ASSERT_TRUE(session.gesture_in_work());
  copy.note_edit();
  copy.keep(session);
  copy.wait();
  EXPECT_FALSE(std::filesystem::exists(copy.path()));
}

TEST(RecordCopyTest, CopiesOfDeadProcessesAreFound) {
  const std::string folder = scratch_path("copies");
  std::filesystem::create_directories(folder);
  const std::string dead = folder + "/a.felt.unsaved-999999999.ndjson";
  for (const std::string& name :
       {dead, folder + "/b.felt.unsaved-" + std::to_string(getpid()) + ".ndjson",
        folder + "/c.felt.unsaved-x.ndjson", folder + "/d.ndjson"}) {
    std::ofstream(name) << "{}\n";
  }
  EXPECT_EQ(find_record_copies({folder, folder + "/none"}), std::vector<std::string>{dead});
  // After a restart of the machine another process has the number: it began after the last write.
  const std::string older = folder + "/b.felt.unsaved-" + std::to_string(getpid()) + ".ndjson";
  std::filesystem::last_write_time(
      older, std::filesystem::file_time_type::clock::now() - std::chrono::hours(24 * 365));
  EXPECT_EQ(find_record_copies({folder}), (std::vector<std::string>{dead, older}));
  std::filesystem::remove_all(folder);
}

TEST(LiveLoopTest, LimitsCountThePlanesScaleAndThePersonsWishes) {
  World world;
  world.gone_after_reads = 1 << 30;
  ZigzagDriver driver(world);
  for (const bool own_frame : {false, true}) {
    if (own_frame) driver.give_own_frame();
    RealDevice device{&driver, driver.device(), {.device_id = "zigzag:1"}};
    device.profile.force_limit_n = 0.5;
    device.profile.plane =
        PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}, {}, 2.0);
    ASSERT_TRUE(device.profile.plane);
    const PlaneCalibration plane = own_frame ? *device.profile.plane : PlaneCalibration();
    const Capabilities limited = limited_by(device.profile, driver.device().capabilities);
    const SafetyLimits right = limits_for(plane.to_sheet(limited), 3.0);
    auto loop = LiveLoop::start(device, {}, 3.0, false);
    ASSERT_TRUE(loop) << loop.error().message;
    const SafetyLimits& used = (*loop)->servo().options().limits;
    EXPECT_EQ(used.max_stiffness_n_per_m, right.max_stiffness_n_per_m) << own_frame;
    EXPECT_EQ(used.max_damping_n_s_per_m, right.max_damping_n_s_per_m) << own_frame;
    EXPECT_EQ(used.cut_m_per_s, right.cut_m_per_s) << own_frame;
    EXPECT_EQ(used.jump_mm_per_ms, right.jump_mm_per_ms) << own_frame;
    EXPECT_EQ(used.peak_force_n, right.peak_force_n) << own_frame;
    EXPECT_EQ((*loop)->capabilities().max_stiffness_n_per_m,
              plane.to_sheet(limited).max_stiffness_n_per_m);
    EXPECT_EQ((*loop)->capabilities().max_force_n, plane.to_sheet(limited).max_force_n);
    EXPECT_TRUE((*loop)->stop());
  }
}

// Some libraries tell a serial only of what is open.
TEST(LiveLoopTest, APlaneThatWasShownWithAnotherUnitIsNotUsed) {
  World world;
  world.gone_after_reads = 1 << 30;
  ZigzagDriver driver(world);
  driver.give_own_frame();
  driver.tell_serial_once_open("THIS-1");
  for (const bool same : {false, true}) {
    RealDevice device{&driver, driver.device(), {.device_id = "zigzag:1"}};
    device.profile.serial = same ? "THIS-1" : "OTHER-42";
    device.profile.plane =
        PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}, {900, 900, 70}, 1.0);
    ASSERT_TRUE(device.profile.plane);
    const Vec3 shown = device.profile.plane->to_sheet(driver.device().capabilities).workspace_min;
    auto loop = LiveLoop::start(device, {0, 0, 297, 210}, 3.0, false);
    ASSERT_TRUE(loop) << loop.error().message;
    EXPECT_EQ((*loop)->capabilities().workspace_min == shown, same);
    EXPECT_TRUE((*loop)->stop());
    DriverSubject subject(driver, driver.device(), {}, device.profile);
    ASSERT_TRUE(subject.open());
    EXPECT_EQ(subject.device()->capabilities().workspace_min == shown, same) << "device-test";
  }
}

}  // namespace
}  // namespace felt::cli
