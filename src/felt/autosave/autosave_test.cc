#include "felt/autosave/autosave.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "felt/autosave/folder_lock.h"
#include "felt/autosave/live_ink.h"
#include "felt/autosave/testing/autosave_fixture.h"

namespace felt::autosave_test {
namespace {

using testing::AutosaveFixture;
using testing::TestFolder;

TEST(Autosave, WhateverWasDrawnIsThereAtAnyStep) {
  for (int steps = 1; steps < 320; steps += 1 + steps % 7) {
    const TestFolder folder;
    AutosaveFixture fixture({.roots = {folder.path}});
    fixture.autosave->process();
    for (int i = 0; i < steps; ++i) {
      fixture.step();
      if (i % 5 == 2) fixture.autosave->process();
      if (i % 60 == 57 && i % 240 > 180) fixture.apply(UndoEvent{});
      if (i % 60 == 58 && i % 120 > 60) fixture.apply(LayerEvent{LayerEvent::Do::kAdd, {}, "L"});
    }
    fixture.autosave->process();
    const Recovered recovered = fixture.crashed();
    EXPECT_TRUE(recovered.problems.empty()) << recovered.problems.front();
    EXPECT_TRUE(recovered.drawing.document == fixture.ended()) << steps << " steps";
  }
}

/// Every tool except the pencil is in the middle of a gesture when the process dies.
TEST(Autosave, EveryToolsGestureIsThere) {
  for (const char* tool : {"pull", "smooth", "width", "eraser", "lasso", "transform", "connect"}) {
    for (const int steps : {20, 35, 52, 90}) {
      const TestFolder folder;
      AutosaveFixture fixture({.roots = {folder.path}});
      fixture.draw(7, 12);
      fixture.apply(SelectStrokes{});
      fixture.apply(SelectTool{tool});
      fixture.apply(SetOption{"ink.color", "#2040a0"});
      for (int i = 0; i < steps; ++i) {
        fixture.step();
        if (i % 5 == 2) fixture.autosave->process();
      }
      fixture.autosave->process();
      const Recovered recovered = fixture.crashed();
      EXPECT_TRUE(recovered.drawing.document == fixture.ended()) << tool << ' ' << steps;
      EXPECT_EQ(recovered.drawing.color, (Rgba{0x20, 0x40, 0xa0, 255}));
    }
  }
}

/// The process dies in a line that had to add its layer.
TEST(Autosave, ALineIsThereAlthoughNoLayerWasOpen) {
  for (const auto what : {LayerEvent::Do::kLock, LayerEvent::Do::kHide}) {
    for (const int steps : {6, 12, 30, 52, 80}) {
      const TestFolder folder;
      AutosaveFixture fixture({.roots = {folder.path}});
      fixture.apply(LayerEvent{what, fixture.session->layer()});
      for (int i = 0; i < steps; ++i) {
        fixture.step();
        if (i % 5 == 2) fixture.autosave->process();
      }
      fixture.autosave->process();
      const Recovered recovered = fixture.crashed();
      EXPECT_TRUE(recovered.problems.empty()) << recovered.problems.front();
      EXPECT_EQ(recovered.drawing.document.layers().size(), 2u) << steps;
      EXPECT_TRUE(recovered.drawing.document == fixture.ended()) << steps;
    }
  }
}

/// The edit thread hangs at every point of a gesture, and the user continues to draw.
TEST(Autosave, AHungEditThreadCostsNoInk) {
  for (const char* tool : {"pencil", "pull", "eraser", "transform"}) {
    for (int reported = 40; reported <= 125; reported += 5) {
      for (const int more : {1, 20, 64, 130}) {
        const TestFolder folder;
        AutosaveFixture fixture({.roots = {folder.path}});
        fixture.draw(7, 12);
        fixture.apply(SelectStrokes{});
        fixture.apply(SelectTool{tool});
        fixture.steps(reported);
        fixture.autosave->process();
        fixture.hangs = true;
        for (int i = 0; i < more; ++i) {
          fixture.step();
          if (i % 5 == 0) fixture.autosave->process();
        }
        fixture.autosave->process();
        const Recovered recovered = fixture.crashed();
        for (int i = 0; i < more; ++i) {
          PenSample late = AutosaveFixture::sample(reported + i);
          late.time_ns += AutosaveFixture::kOffsetNs;
          ASSERT_TRUE(fixture.session->sample(late));
        }
        EXPECT_TRUE(recovered.drawing.document == fixture.ended())
            << tool << ": told " << reported << ", then " << more;
      }
    }
  }
}

/// Samples of a tilted pen that the session has not received are saved with their tilt; samples
/// without tilt are saved in the older form.
TEST(LiveInk, KeepsHowThePenTilts) {
  for (const std::optional<double> tilt : {std::optional<double>(), std::optional(32.5)}) {
    LiveInk live;
    live.clear();
    std::vector<PenSample> reported;
    for (int i = 0; i < 20; ++i) {
      const double z = i < 5 ? 3.0 : -0.3;
      reported.push_back({i * 1'000'000, {0.1 * i, 5.0, z}, {}, {}, 0});
      if (i > 8) reported.back().tilt_deg = tilt;
      live.add_loop_sample(reported.back());
    }
    LiveStretch stretch;
    for (const LiveChunk& chunk : live.take_changes().chunks) {
      if (chunk.kind != LiveKind::kContext) {
        EXPECT_EQ(chunk.kind, tilt ? LiveKind::kTilted : LiveKind::kSamples);
      }
      ASSERT_TRUE(read_live_chunk(chunk.kind, chunk.bytes, stretch));
      LiveStretch damaged;
      EXPECT_FALSE(read_live_chunk(chunk.kind, chunk.bytes + "x", damaged));
    }
    EXPECT_EQ(stretch.overhang, reported);
  }
}

/// Another tool is chosen in the middle of a line, which ends the line. The rest of the contact is
/// not a gesture, neither in the session nor after recovery.
TEST(Autosave, TheRestOfALineIsNoOtherGesture) {
  for (const char* tool : {"eraser", "pull", "pencil"}) {
    for (const int reported : {22, 30, 49, 52, 60}) {
      for (const bool hangs : {false, true}) {
        const TestFolder folder;
        AutosaveFixture fixture({.roots = {folder.path}});
        fixture.draw(7, 12);
        fixture.apply(SelectTool{"smooth"});
        fixture.steps(20);
        fixture.apply(SelectTool{tool});
        fixture.steps(reported - 20);
        fixture.autosave->process();
        fixture.hangs = hangs;
        fixture.steps(70);
        fixture.autosave->process();
        const Recovered recovered = fixture.crashed();
        for (int i = 0; hangs && i < 70; ++i) {
          PenSample late = AutosaveFixture::sample(reported + i);
          late.time_ns += AutosaveFixture::kOffsetNs;
          ASSERT_TRUE(fixture.session->sample(late));
        }
        EXPECT_TRUE(recovered.drawing.document == fixture.ended())
            << tool << ' ' << reported << hangs;
      }
    }
  }
}

/// The process dies while the pen touches in a ring of tools, or after the ring was closed during
/// that touch. The touch is not ink; the next one is.
TEST(Autosave, ATouchInARingIsNoInk) {
  for (const bool hangs : {false, true}) {
    const TestFolder folder;
    AutosaveFixture fixture({.roots = {folder.path}});
    fixture.steps(2);
    fixture.apply(UseRing{true, {60.0, 70.0}, {60.0, 54.0}, {76.0, 70.0}});
    fixture.autosave->process();
    const auto die = [&](int steps) {
      for (int i = 0; i < steps; ++i) {
        fixture.step();
        if (i % 5 == 0) fixture.autosave->process();
      }
      fixture.autosave->process();
      return fixture.crashed().drawing.document;
    };
    fixture.hangs = hangs;
    EXPECT_EQ(die(28).stroke_count(), 0u) << hangs;
    fixture.hangs = false;
    fixture.apply(UseRing{});
    fixture.autosave->process();
    fixture.hangs = hangs;
    EXPECT_EQ(die(15).stroke_count(), 0u) << hangs;
    fixture.hangs = false;
    const Document drawn = die(50);
    EXPECT_GT(drawn.stroke_count(), 0u);
    EXPECT_TRUE(drawn == fixture.ended());
  }
}

/// The pen bounces off the surface after the ring was closed during a touch.
TEST(LiveInk, ABounceAfterARingIsNoNewTouch) {
  LiveInk live;
  live.clear();
  const auto is_saved = [&] { return !live.take_changes().chunks.empty(); };
  std::int64_t time_ns = 0;
  const auto add = [&](double z) {
    PenSample sample;
    sample.time_ns = time_ns += 4'000'000;
    sample.position = {10.0, 10.0, z};
    live.add_loop_sample(sample);
    live.event_applied({sample.time_ns, PenEvent{sample.position, {}, 0, {}}}, false);
  };
  add(2.0);
  live.event_applied({time_ns, UseRing{true, {10, 10}, {10, 0}, {20, 10}}}, false);
  for (const double z : {2.0, -0.2, -0.2}) add(z);
  live.event_applied({time_ns, UseRing{}}, false);
  for (const double z : {-0.2, 0.1, -0.2, -0.2}) add(z);
  EXPECT_FALSE(is_saved());
  for (int i = 0; i < 10; ++i) add(2.0);
  add(-0.2);
  EXPECT_TRUE(is_saved());
}

/// The edit that adds the layer of a line comes between its hover samples and its first sample in
/// contact. Recovery needs the hover samples to tell how fast the pen lands.
TEST(LiveInk, TheLayerOfALineKeepsItsHoverSamples) {
  const Edit layer{"Add layer", {}, {{{2}, std::nullopt, LayerState{"Layer 2"}, 0, 1}}};
  Edit ink{"Draw", {{}}};
  for (const bool knows_touch : {false, true}) {  // from the haptic loop, before the session does
    LiveInk live;
    live.clear();
    std::int64_t time_ns = 0;
    const auto event = [&](double z) {
      live.event_applied({time_ns += 4'000'000, PenEvent{{10.0, 10.0, z}, {}, 0, {}}}, false);
    };
    const auto script = [&] {
      LiveStretch stretch;
      for (const LiveChunk& chunk : live.take_changes().chunks) {
        EXPECT_TRUE(read_live_chunk(chunk.kind, chunk.bytes, stretch));
      }
      return std::pair(std::count(stretch.script.begin(), stretch.script.end(), '\n'),
                       stretch.overhang.size());
    };
    for (int i = 0; i < 5; ++i) event(5.0 - i);
    if (knows_touch) {
      for (int i = 1; i <= 3; ++i) {
        PenSample sample;
        sample.time_ns = time_ns + 4'000'000 * i;
        sample.position = {10.0, 10.0, i < 2 ? 0.5 : -0.2};
        live.add_loop_sample(sample);
      }
      EXPECT_EQ(script(), std::pair(5L, 3UL));
      event(0.5);
    }
    live.edit_applied(layer);
    event(-0.2);
    event(-0.2);
    EXPECT_EQ(script().first, knows_touch ? 8 : 7) << "hover samples and contact";
    live.edit_applied(ink);
    for (int i = 0; i < 3; ++i) event(5.0);
    event(-0.2);
    EXPECT_LE(script().first, 4) << "those of the last line are not of the next";
  }
}

/// A pen that lands is thrown back for longer than LiveInk::kNoEditNs. The line goes on, so it
/// stays saved.
TEST(LiveInk, ALongBounceOfALandingPenKeepsTheLine) {
  LiveInk live;
  live.clear();
  std::int64_t time_ns = 0;
  const auto add = [&](double z) {
    PenSample sample;
    sample.time_ns = time_ns += 1'000'000;
    sample.position = {10.0 + 1e-9 * static_cast<double>(time_ns), 10.0, z};
    live.add_loop_sample(sample);
    live.event_applied({sample.time_ns, PenEvent{sample.position, {}, 0, {}}}, false);
  };
  for (double z = 6.0; z > -1.0; z -= 0.075) add(z);
  for (double z = -1.0; z < 0.0; z += 0.03) add(z);
  EXPECT_FALSE(live.take_changes().chunks.empty());
  for (double t = 0.0; t < 0.3; t += 0.001) {
    add(30.0 * t - 100.0 * t * t);  // at most 2.25 mm high
    EXPECT_FALSE(live.take_changes().clear) << t;
  }
  for (int i = 0; i < 50; ++i) add(-0.5);
  const LiveInk::Changes after = live.take_changes();
  EXPECT_FALSE(after.clear);
  EXPECT_FALSE(after.chunks.empty());
  for (int i = 0; i < 300; ++i) add(5.0);  // lifted, and no edit came of it
  EXPECT_TRUE(live.take_changes().clear);
}

TEST(LiveInk, AStretchBeforeTheFirstSampleOfTheSessionEnds) {
  LiveInk live;
  PenSample sample;
  sample.time_ns = 1'000'000;
  sample.position = {10, 10, -0.3};
  live.add_loop_sample(sample);
  EXPECT_FALSE(live.take_changes().chunks.empty()) << "the loop has drawn";
  bool is_over = false;  // the session sees a pen that hovers, because it lifts it
  for (std::int64_t t = 1; t < 300; ++t) {
    live.event_applied({t * 1'000'000, PenEvent{{10, 10, 5.0}, {}, 0, {}}}, false);
    is_over = is_over || live.take_changes().clear;
    EXPECT_TRUE(!is_over || t * 1'000'000 > LiveInk::kNoEditNs);
  }
  EXPECT_TRUE(is_over);
}

/// The edit thread resumes after it hung. Its late events are samples that the autosave already has
/// from the haptic loop.
TEST(Autosave, WhatIsToldLateIsNoInkTwice) {
  for (int reported = 44; reported <= 120; reported += 4) {
    const TestFolder folder;
    AutosaveFixture fixture({.roots = {folder.path}});
    fixture.steps(reported);
    fixture.hangs = true;
    for (int i = 0; i < 90; ++i) {
      fixture.step();
      if (i % 5 == 0) fixture.autosave->process();
    }
    fixture.hangs = false;
    for (int i = 0; i < 90; ++i) {
      PenSample late = AutosaveFixture::sample(reported + i);
      late.time_ns += AutosaveFixture::kOffsetNs;
      ASSERT_TRUE(fixture.session->sample(late));
      if (i % 17 == 3) fixture.autosave->process();
    }
    fixture.steps(13);
    fixture.autosave->process();
    EXPECT_TRUE(fixture.crashed().drawing.document == fixture.ended()) << reported;
  }
}

/// An event ends a line, the edit thread hangs during the rest of the contact until the pen touches
/// again, and then resumes. It reports the rest of the contact after the autosave has started to
/// save the next gesture.
TEST(Autosave, TheRestOfALineIsNoOtherGestureIfItIsReportedLate) {
  for (const char* tool : {"pencil", "pull", "width"}) {
    for (int late_steps = 1; late_steps <= 60; late_steps += 7) {
      const TestFolder folder;
      AutosaveFixture fixture({.roots = {folder.path}});
      fixture.autosave->process();
      fixture.steps(20);
      fixture.apply(SelectTool{"eraser"});
      fixture.apply(SelectTool{tool});
      fixture.hangs = true;
      fixture.steps(70);
      fixture.autosave->process();
      for (int i = 0; i < late_steps; ++i) {
        PenSample late = AutosaveFixture::sample(20 + i);
        late.time_ns += AutosaveFixture::kOffsetNs;
        ASSERT_TRUE(fixture.session->sample(late));
      }
      fixture.autosave->process();
      const Recovered recovered = fixture.crashed();
      for (int i = late_steps; i < 70; ++i) {
        PenSample late = AutosaveFixture::sample(20 + i);
        late.time_ns += AutosaveFixture::kOffsetNs;
        ASSERT_TRUE(fixture.session->sample(late));
      }
      EXPECT_TRUE(recovered.drawing.document == fixture.ended()) << tool << ' ' << late_steps;
    }
  }
}

TEST(Autosave, ANewBaseTakesTheOldOnesPlaceAndLosesNothing) {
  const TestFolder folder;
  AutosaveFixture fixture({.roots = {folder.path}, .max_log_bytes = 6'000});
  fixture.draw(1, 3000);
  for (std::uint64_t i = 2; i < 60; ++i) {
    fixture.draw(i, 2);
    fixture.autosave->process();
    if (i % 9 == 0) {
      const Recovered recovered = fixture.crashed();
      EXPECT_TRUE(recovered.problems.empty());
      EXPECT_TRUE(recovered.drawing.document == fixture.session->document()) << i;
      EXPECT_LT(recovered.edits, 30u);
    }
  }
  EXPECT_EQ(fixture.ring->dropped(), 0u);
}

TEST(Autosave, WhatIsSavedLeavesNothingAndWhatIsNotStays) {
  const TestFolder folder;
  {
    AutosaveFixture fixture({.roots = {folder.path}});
    fixture.draw(1);
    fixture.autosave->process();
    EXPECT_TRUE(find_abandoned_autosaves({folder.path}).empty()) << "its owner lives";
    fixture.autosave->post({.name = "a.felt", .path = "/a.felt"});
    fixture.autosave->post({.modified = false});
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path));
  {
    AutosaveFixture fixture({.roots = {folder.path}});
    fixture.draw(1, 3);
    fixture.autosave->post({.name = "b.felt", .path = "/b.felt"});
  }
  std::vector<AbandonedAutosave> left = find_abandoned_autosaves({folder.path});
  ASSERT_EQ(left.size(), 1u);
  const Recovered recovered = recover_autosave(left[0].folder).value();
  EXPECT_TRUE(recovered.has_changes);
  EXPECT_EQ(recovered.drawing.document.stroke_count(), 3u);
  EXPECT_EQ(recovered.name, "b.felt");
  EXPECT_EQ(recovered.path, "/b.felt");
  EXPECT_TRUE(find_abandoned_autosaves({folder.path}).empty()) << "we have it";
  ASSERT_TRUE(std::move(left[0]).remove());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path));
}

TEST(Autosave, AnotherDrawingBeginsAnotherStore) {
  const TestFolder folder;
  AutosaveFixture fixture({.roots = {folder.path}});
  fixture.draw(1, 5);
  fixture.autosave->process();
  const std::string first = fixture.autosave->status().folder;
  fixture.listener->session_began(*fixture.session, fixture.drawing(), "next", "", false);
  fixture.draw(2);
  fixture.autosave->process();
  EXPECT_NE(fixture.autosave->status().folder, first);
  EXPECT_FALSE(std::filesystem::exists(first));
  EXPECT_TRUE(fixture.crashed().drawing.document == fixture.session->document());
}

TEST(Autosave, APlaceThatFailsIsLeftForTheNext) {
  const TestFolder folder;
  const std::string no_folder = folder.at("file");
  std::fclose(std::fopen(no_folder.c_str(), "w"));
  std::vector<AutosaveStatus> reported;
  AutosaveOptions options{.roots = {no_folder, folder.at("second")}};
  options.on_status = [&reported](const AutosaveStatus& status) { reported.push_back(status); };
  options.retry_first = std::chrono::milliseconds(0);
  AutosaveFixture fixture(options);
  fixture.draw(1);
  fixture.autosave->process();
  ASSERT_EQ(reported.size(), 1u);
  EXPECT_EQ(reported[0].state, AutosaveStatus::State::kElsewhere);
  EXPECT_NE(reported[0].why.find(no_folder), std::string::npos) << reported[0].why;
  fixture.draw(2);
  fixture.autosave->process();
  EXPECT_TRUE(fixture.crashed().drawing.document == fixture.session->document());
  EXPECT_EQ(reported.size(), 1u);
  // The first folder works again.
  std::filesystem::remove(no_folder);
  fixture.draw(3);
  fixture.autosave->process();
  ASSERT_EQ(reported.size(), 2u);
  EXPECT_EQ(reported[1].state, AutosaveStatus::State::kWorking);
  EXPECT_TRUE(fixture.crashed().drawing.document == fixture.session->document());
  EXPECT_TRUE(std::filesystem::is_empty(folder.at("second")));
}

TEST(Autosave, WhereNoPlaceWorksItTriesAgain) {
  const TestFolder folder;
  const std::string no_folder = folder.at("file");
  std::fclose(std::fopen(no_folder.c_str(), "w"));
  AutosaveOptions options{.roots = {no_folder}};
  options.retry = std::chrono::milliseconds(0);
  AutosaveFixture fixture(options);
  fixture.draw(1);
  fixture.autosave->process();
  EXPECT_EQ(fixture.autosave->status().state, AutosaveStatus::State::kFailing);
  fixture.draw(2);
  fixture.autosave->process();
  std::filesystem::remove(no_folder);
  fixture.steps(30);
  fixture.autosave->process();
  EXPECT_EQ(fixture.autosave->status().state, AutosaveStatus::State::kWorking);
  EXPECT_TRUE(fixture.crashed().drawing.document == fixture.ended());
}

TEST(Autosave, AThreadCommitsByItself) {
  const TestFolder folder;
  Document document;
  {
    AutosaveFixture fixture({.roots = {folder.at("unused")}});
    Autosave autosave({.roots = {folder.at("used")}});
    autosave.session_began(*fixture.session, fixture.drawing(), "n", "", true);
    fixture.listener = &autosave;
    fixture.draw(4, 2);
    autosave.flush();
    document = fixture.session->document();
    const Result<Recovered> recovered = recover_autosave(autosave.status().folder);
    ASSERT_TRUE(recovered);
    EXPECT_TRUE(recovered->drawing.document == document);
    fixture.listener = nullptr;
  }
  EXPECT_EQ(find_abandoned_autosaves({folder.at("used")}).size(), 1u);
}

TEST(FolderLock, BelongsToOneAtATime) {
  const TestFolder folder;
  std::optional<FolderLock> lock = FolderLock::take(folder.path).value();
  EXPECT_FALSE(FolderLock::take(folder.path));
  lock.reset();
  EXPECT_TRUE(FolderLock::take(folder.path));
  EXPECT_FALSE(FolderLock::take(folder.at("nowhere")));
  EXPECT_EQ(FolderLock::take(folder.at("nowhere")).error().code, ErrorCode::kNotFound);
}

TEST(FolderLock, PrivateFoldersArePrivate) {
  const TestFolder folder;
  ASSERT_TRUE(make_private_folder(folder.at("a/b/c")));
  using std::filesystem::perms;
  EXPECT_EQ(std::filesystem::status(folder.at("a/b/c")).permissions(), perms::owner_all);
  std::filesystem::permissions(folder.at("a/b/c"), perms::all);
  ASSERT_TRUE(make_private_folder(folder.at("a/b/c")));
  EXPECT_EQ(std::filesystem::status(folder.at("a/b/c")).permissions(), perms::owner_all);
  std::fclose(std::fopen(folder.at("file").c_str(), "w"));
  EXPECT_FALSE(make_private_folder(folder.at("file")));
  EXPECT_FALSE(make_private_folder(folder.at("file/below")));
}

}  // namespace
}  // namespace felt::autosave_test
