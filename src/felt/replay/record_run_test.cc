#include "felt/replay/record_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
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
#include "felt/replay/record_copy.h"
#include "felt/replay/testing/zigzag_driver.h"
#include "felt/tools/tool.h"
#include "tests/support/scratch_path.h"

namespace felt::record_run_test {
namespace {

struct Drawn {
  std::size_t strokes = 0;
  bool hangs = false;
  std::string error;
  bool ran_backwards = false;
  std::int64_t last_ns = 0;
};

Drawn draw(ZigzagWorld& world, const std::function<bool(const Session&)>& is_enough, bool forces,
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
  options.forces = forces;
  options.seconds = 60.0;  // if the program hangs, the test fails instead of hanging
  options.is_over = [&] { return is_enough(session); };
  RecordRun run(device, session, options);
  const Result<void> begun = run.begin();
  EXPECT_TRUE(begun) << begun.error().message;
  const Result<void> done = run.draw();
  if (!done) drawn.error = done.error().message;
  drawn.hangs = run.hangs();
  drawn.strokes = session.document().stroke_count();
  return drawn;
}

TEST(RecordRunTest, DrawsGoesOnAfterTheDeviceWasGoneAndKeepsTheInk) {
  ZigzagWorld world;
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
  ZigzagWorld world;
  double reported_n = 0.0;
  RecordOptions options;
  options.force_limit_n = 0.3;
  draw(
      world,
      [&](const Session& session) {
        reported_n = session.device().advised_force_n;
        return session.document().stroke_count() >= 1;
      },
      false, options);
  EXPECT_EQ(reported_n, 0.3);
}

TEST(RecordRunTest, APortThatIsNotFreeYetIsTriedAgain) {
  ZigzagWorld world;
  world.refusals = 2;
  const Drawn drawn = draw(
      world, [](const Session& session) { return session.document().stroke_count() >= 3; }, false);
  EXPECT_EQ(drawn.error, "");
  EXPECT_EQ(world.refused, 2);
  EXPECT_EQ(world.opened, 2);
}

// Otherwise the program would ask a user who refused twice a second.
TEST(RecordRunTest, WhatAPersonRefusedWaitsForThem) {
  ZigzagWorld world;
  world.refusals = 1 << 30;
  world.refusal = ErrorCode::kUnsupported;
  int turns = 0;
  bool pressed = false;
  RecordOptions options;
  options.enter_pressed = [&] {
    if (world.refused > 0) ++turns;  // one attempt in half a second
    return turns == 3 && !std::exchange(pressed, true);
  };
  const Drawn drawn = draw(
      world, [&](const Session&) { return world.refused >= 2; }, false, options);
  EXPECT_EQ(drawn.error, "");
  EXPECT_TRUE(pressed);
  EXPECT_EQ(turns, 3) << "asked again before somebody wanted it";
}

TEST(RecordRunTest, EndsWithTheInkWhereTheDeviceStaysAway) {
  ZigzagWorld world;
  world.never_comes_back = true;
  int asked = 0;
  const Drawn drawn = draw(
      world, [&](const Session&) { return world.is_gone && ++asked > 3; }, false);
  EXPECT_GE(drawn.strokes, 1U);
}

TEST(RecordRunTest, ForcesComeOnlyWhenAskedFor) {
  ZigzagWorld world;
  world.is_calm = true;
  world.gone_after_reads = 1 << 30;
  int turns = 0;
  RecordOptions options;
  // Arms repeatedly, because late ticks on a busy machine latch the safety chain.
  options.enter_pressed = [&] { return ++turns % 300 == 0; };
  draw(
      world, [&](const Session&) { return world.largest_n > 0.0; }, true, options);
  EXPECT_GT(world.largest_n.load(), 0.0);
  EXPECT_LE(world.largest_n.load(), 2.7 + 1e-9);  // 0.9 of its maximum
}

TEST(RecordRunTest, ForcesStayOffAfterALostDeviceUntilSomebodyAllowsThem) {
  ZigzagWorld world;
  world.is_calm = true;
  bool was_lost = false;
  int turns_without = 0;
  double without_n = -1.0;
  RecordOptions options;
  options.enter_pressed = [&] {
    if (world.opened < 2 || ++turns_without % 300 != 0) return false;
    // Arms repeatedly, because late ticks on a busy machine latch the safety chain.
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
  ZigzagWorld world;
  world.is_calm = true;
  world.gone_after_reads = 1 << 30;
  int turns = 0;
  double after_first_n = -1.0;
  RecordOptions options;
  int asked = 0;
  options.ask_consent = [&] { ++asked; };
  options.enter_pressed = [&] {
    if (++turns == 300) after_first_n = world.largest_n;
    return turns == 1 || turns % 300 == 0;
  };
  draw(
      world, [&](const Session&) { return turns > 300 && world.largest_n > 0.0; }, false, options);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(after_first_n, 0.0);
  EXPECT_GT(world.largest_n.load(), 0.0);
}

TEST(RecordRunTest, WhileTheProgramIsStoppedThereIsNoForceAndNoneAfterwards) {
  ZigzagWorld world;
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
  static ZigzagWorld world;  // static, because the abandoned thread may resume at any time
  world.hangs_after_reads = 1000;
  world.gone_after_reads = 1 << 30;
  const Drawn drawn = draw(
      world, [](const Session&) { return false; }, false);
  EXPECT_TRUE(drawn.hangs);
  EXPECT_GE(drawn.strokes, 1U);
  EXPECT_THAT(drawn.error, ::testing::HasSubstr("stopped responding"));
  EXPECT_EQ(world.opened, 1);
  EXPECT_EQ(world.stops, 0);
  world.hangs = false;
  while (world.stops == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(RecordRunTest, ACopyOfTheDrawingIsThereWhileItIsMade) {
  ZigzagWorld world;
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

/// Moves a pen along a circle without forces. The pressure shows that the pen touches.
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

/// Returns the content of a new copy, read as the program reads it. A copy is not due at every
/// turn, because the next one waits for 50 times as long as the last one took.
std::vector<StrokePtr> read_copy(RecordCopy& copy, const Session& session) {
  std::filesystem::remove(copy.path());
  for (int turn = 0; turn < 2000 && !std::filesystem::exists(copy.path()); ++turn) {
    copy.keep(session);
    copy.wait();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  Result<Imported> opened = read_drawing(copy.path());
  if (!opened) return {};
  return visible_strokes(opened->drawing.document);
}

TEST(RecordCopyTest, HasTheStrokeInProgress) {
  const std::string path = scratch_path("in_progress");
  RecordCopy copy(path, std::chrono::seconds(0));
  Session session(make_tools(), {});
  draw_arc(session, 0, 2000);
  ASSERT_EQ(session.document().stroke_count(), 0U);
  const std::vector<StrokePtr> one = read_copy(copy, session);
  ASSERT_EQ(one.size(), 1U);
  draw_arc(session, 2000, 4000);  // more of the same stroke, without an edit
  const std::vector<StrokePtr> more = read_copy(copy, session);
  ASSERT_EQ(more.size(), 1U);
  const auto length_mm = [](const Stroke& stroke) {
    double length = 0.0;
    for (int i = 0; i < stroke.segment_count(); ++i) length += control_length(stroke.segment(i));
    return length;
  };
  EXPECT_NEAR(length_mm(*one[0]), 40.0 * 0.002 * 2000, 3.0);
  EXPECT_NEAR(length_mm(*more[0]), 40.0 * 0.002 * 4000, 3.0);
  ASSERT_TRUE(session.finish());
  copy.note_edit();
  EXPECT_EQ(read_copy(copy, session).size(), session.document().stroke_count());
  copy.remove();
}

TEST(RecordCopyTest, IsNotWrittenBeforeThereIsInk) {
  RecordCopy copy(scratch_path("no_ink"), std::chrono::seconds(0));
  Session session(make_tools(), {});
  draw_arc(session, 0, 6);
  ASSERT_TRUE(session.gesture_in_progress());
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
  // After a restart of the machine another process has this id: it began after the last write.
  const std::string older = folder + "/b.felt.unsaved-" + std::to_string(getpid()) + ".ndjson";
  std::filesystem::last_write_time(
      older, std::filesystem::file_time_type::clock::now() - std::chrono::hours(24 * 365));
  EXPECT_EQ(find_record_copies({folder}), (std::vector<std::string>{dead, older}));
  std::filesystem::remove_all(folder);
}

TEST(LiveLoopTest, LimitsCountThePlanesScaleAndThePersonsWishes) {
  ZigzagWorld world;
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
    const SafetyLimits right = limits_for(plane.to_page(limited), 3.0);
    auto loop = LiveLoop::start(device, {}, 3.0, {});
    ASSERT_TRUE(loop) << loop.error().message;
    const SafetyLimits& used = (*loop)->servo().options().limits;
    EXPECT_EQ(used.max_stiffness_n_per_m, right.max_stiffness_n_per_m) << own_frame;
    EXPECT_EQ(used.max_damping_n_s_per_m, right.max_damping_n_s_per_m) << own_frame;
    EXPECT_EQ(used.cut_m_per_s, right.cut_m_per_s) << own_frame;
    EXPECT_EQ(used.jump_mm_per_ms, right.jump_mm_per_ms) << own_frame;
    EXPECT_EQ(used.peak_force_n, right.peak_force_n) << own_frame;
    EXPECT_EQ((*loop)->device().capabilities().max_stiffness_n_per_m,
              plane.to_page(limited).max_stiffness_n_per_m);
    EXPECT_EQ((*loop)->device().capabilities().max_force_n, plane.to_page(limited).max_force_n);
    EXPECT_TRUE((*loop)->stop());
  }
}

}  // namespace
}  // namespace felt::record_run_test
