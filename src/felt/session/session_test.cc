#include "felt/session/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/material/material_file.h"
#include "felt/session/old_defaults.h"
#include "felt/session/testing/fake_tools.h"

namespace felt::session_test {
namespace {

using ::testing::HasSubstr;

constexpr std::int64_t kTickNs = 1'000'000;

/// A session with a pen.
struct Fixture {
  explicit Fixture(SessionOptions options = {}) : session(fake_tools(), std::move(options)) {}

  void pen(double x, double y, double z) {
    const Result<void> done = session.apply({now_ns, PenEvent{{x, y, z}, {}, 0}});
    ASSERT_TRUE(done) << done.error().message;
    now_ns += kTickNs;
  }
  void put_down(double x, double y) {
    pen(x, y, 5);
    pen(x, y, -1);
  }
  void lift(double x, double y) { pen(x, y, 5); }
  void line(double x, double y) {
    put_down(x, y);
    pen(x + 5, y, -1);
    pen(x + 10, y, -1);
    lift(x + 10, y);
  }
  template <class What>
  Result<void> apply(What what) {
    return session.apply({now_ns, std::move(what)});
  }
  template <class What>
  void must(What what) {
    const Result<void> done = apply(std::move(what));
    ASSERT_TRUE(done) << done.error().message;
  }
  [[nodiscard]] std::size_t strokes() const { return session.document().stroke_count(); }

  std::int64_t now_ns = 0;
  Session session;
};

TEST(Session, StartsWithThePencil) {
  EXPECT_EQ(Fixture().session.tool().info().id, "pencil");
}

/// Uses the real tools. The pen must be lifted before the chosen tool may begin a gesture.
TEST(Session, AToolChosenWithThePenDownWaitsForTheLift) {
  Fixture fixture;
  fixture.session = Session(make_tools(), {});
  fixture.put_down(0, 0);
  fixture.pen(5, 0, -1);
  fixture.must(SelectTool{"eraser"});
  fixture.must(SelectTool{"pencil"});
  EXPECT_EQ(fixture.strokes(), 1U) << "the line that was being drawn stays";
  fixture.pen(10, 0, -1);
  fixture.pen(15, 0, 0.2);  // not lifted yet
  fixture.pen(20, 0, -1);
  fixture.lift(20, 0);
  EXPECT_EQ(fixture.strokes(), 1U);
  // The pen is just above the surface, then down again. The pencil has discarded its earlier state.
  fixture.pen(30, 0, 0.2);
  fixture.pen(30, 0, -1);
  fixture.pen(40, 0, -1);
  fixture.lift(40, 0);
  EXPECT_EQ(fixture.strokes(), 2U);
}

TEST(Session, AGestureIsOneStepOfUndo) {
  Fixture fixture;
  fixture.line(0, 0);
  fixture.line(0, 10);
  EXPECT_EQ(fixture.strokes(), 2U);
  EXPECT_EQ(fixture.session.history().undo_count(), 2U);
  const Document both = fixture.session.document();
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.strokes(), 1U);
  fixture.must(RedoEvent{});
  EXPECT_EQ(fixture.session.document(), both);
  fixture.must(UndoEvent{});
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.strokes(), 0U);
}

TEST(Session, NothingToUndoOrRedoIsNoError) {
  Fixture fixture;
  fixture.must(UndoEvent{});
  fixture.must(RedoEvent{});
  EXPECT_EQ(fixture.strokes(), 0U);
}

TEST(Session, ShowsAPreviewUntilTheRelease) {
  Fixture fixture;
  fixture.put_down(0, 0);
  fixture.pen(5, 0, -1);
  EXPECT_TRUE(fixture.session.gesture_in_progress());
  ASSERT_TRUE(fixture.session.preview());
  EXPECT_EQ(fixture.session.preview()->changes.size(), 1U);
  EXPECT_EQ(fixture.strokes(), 0U);
  Overlay overlay;
  fixture.session.draw(overlay);
  EXPECT_EQ(overlay.rings.size(), 2U);
  fixture.lift(5, 0);
  EXPECT_FALSE(fixture.session.preview());
  EXPECT_FALSE(fixture.session.gesture_in_progress());
  fixture.session.draw(overlay);
  EXPECT_TRUE(overlay.rings.empty());
  EXPECT_EQ(fixture.strokes(), 1U);
}

TEST(Session, UndoInAGestureTakesBackOnlyThat) {
  Fixture fixture;
  fixture.line(0, 0);
  fixture.put_down(0, 10);
  fixture.pen(5, 10, -1);
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.strokes(), 1U);
  EXPECT_FALSE(fixture.session.preview());
  fixture.pen(10, 10, -1);  // still down: draws nothing until it is lifted
  fixture.lift(10, 10);
  EXPECT_EQ(fixture.strokes(), 1U);
  fixture.line(0, 20);
  EXPECT_EQ(fixture.strokes(), 2U);
}

TEST(Session, UndoAtTheFirstTouchTakesBackOnlyThat) {
  Fixture fixture;
  fixture.line(0, 0);
  fixture.put_down(0, 10);  // no preview yet
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.strokes(), 1U);
}

TEST(Session, UndoRightAfterTheLiftTakesBackTheLineThatWaits) {
  Fixture fixture;
  fixture.line(0, 0);
  fixture.put_down(0, 10);
  fixture.pen(5, 10, -1);
  fixture.pen(5, 10, 0.1);  // the tool still expects a bounce
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.strokes(), 1U);
  EXPECT_TRUE(fixture.session.history().can_redo());
  fixture.lift(5, 10);
  EXPECT_EQ(fixture.strokes(), 1U);
  fixture.must(RedoEvent{});
  EXPECT_EQ(fixture.strokes(), 2U);
}

TEST(Session, RedoInAGestureDoesNothing) {
  Fixture fixture;
  fixture.line(0, 0);
  fixture.must(UndoEvent{});
  fixture.put_down(0, 10);
  fixture.must(RedoEvent{});
  EXPECT_EQ(fixture.strokes(), 0U);
  fixture.pen(5, 10, -1);
  fixture.lift(5, 10);
  EXPECT_EQ(fixture.strokes(), 1U);
  EXPECT_FALSE(fixture.session.history().can_redo());
}

TEST(Session, UndoWhileThePenIsStillDownAfterTheOutcome) {
  Fixture fixture;
  fixture.line(0, 0);
  fixture.line(0, 10);
  fixture.must(SelectTool{"eraser"});
  fixture.put_down(0, 0);
  EXPECT_EQ(fixture.strokes(), 1U);
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.strokes(), 2U);
  fixture.pen(1, 1, -1);  // does not erase again
  EXPECT_EQ(fixture.strokes(), 2U);
}

TEST(Session, CancelMeansItNeverWas) {
  Fixture fixture;
  fixture.put_down(0, 0);
  fixture.pen(5, 0, -1);
  fixture.must(CancelEvent{});
  EXPECT_FALSE(fixture.session.preview());
  fixture.pen(10, 0, -1);
  fixture.lift(10, 0);
  EXPECT_EQ(fixture.strokes(), 0U);
  EXPECT_FALSE(fixture.session.history().can_undo());
}

TEST(Session, WhatComesAfterAToolWasChosenInAGestureDoesNotEndTheWaitForTheLift) {
  Fixture fixture;
  fixture.line(0, 10);
  fixture.must(SelectTool{"eraser"});
  fixture.must(SelectTool{"pencil"});
  fixture.put_down(0, 0);
  fixture.pen(5, 0, -1);
  fixture.must(SelectTool{"eraser"});
  EXPECT_EQ(fixture.strokes(), 2U);
  fixture.must(SelectStrokes{SelectStrokes::What::kAll});
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.strokes(), 1U);
  fixture.pen(6, 0, -1);
  EXPECT_EQ(fixture.strokes(), 1U) << "the pen is still down";
  fixture.lift(6, 0);
  fixture.put_down(6, 0);
  EXPECT_EQ(fixture.strokes(), 0U);
}

TEST(Session, AToolChosenInAGestureKeepsTheInkAndWaitsForALift) {
  Fixture fixture;
  fixture.put_down(0, 0);
  fixture.pen(5, 0, -1);
  fixture.must(SelectTool{"eraser"});
  EXPECT_EQ(fixture.strokes(), 1U);
  EXPECT_FALSE(fixture.session.gesture_in_progress());
  fixture.pen(6, 0, -1);  // would erase it
  EXPECT_EQ(fixture.strokes(), 1U);
  fixture.lift(6, 0);
  fixture.put_down(6, 0);
  EXPECT_EQ(fixture.strokes(), 0U);
}

TEST(Session, AToolChosenInTheAirBeginsAtOnce) {
  Fixture fixture;
  fixture.line(0, 0);
  fixture.must(SelectTool{"eraser"});
  fixture.pen(0, 0, -1);
  EXPECT_EQ(fixture.strokes(), 0U);
  fixture.must(SelectTool{"pencil"});  // waits for a lift
  fixture.must(SelectTool{"pencil"});  // the same tool: no effect
  EXPECT_EQ(fixture.session.tool().info().id, "pencil");
}

TEST(Session, FinishEndsAGestureAsALiftWould) {
  Fixture lifted, finished;
  lifted.line(0, 0);
  finished.put_down(0, 0);
  finished.pen(5, 0, -1);
  finished.pen(10, 0, -1);
  ASSERT_TRUE(finished.session.finish());
  EXPECT_EQ(finished.session.document(), lifted.session.document());
  ASSERT_TRUE(finished.session.finish());
  EXPECT_EQ(finished.strokes(), 1U);
}

TEST(Session, ImportAddsOneStepOnTopAndKeepsTheInkInWork) {
  Fixture source;
  source.line(0, 0);
  source.line(0, 10);
  Fixture fixture;
  fixture.put_down(0, 20);
  fixture.pen(5, 20, -1);
  ASSERT_TRUE(fixture.session.import(fixture.now_ns, {"a.ndjson"},
                                     visible_strokes(source.session.document())));
  EXPECT_EQ(fixture.strokes(), 3U);
  EXPECT_EQ(visible_strokes(fixture.session.document())[1],
            visible_strokes(source.session.document())[0]);
  EXPECT_EQ(fixture.session.history().undo_count(), 2U);
  fixture.pen(8, 20, -1);
  fixture.lift(8, 20);
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.strokes(), 1U) << "a dot is no line to this tool, so the import was undone";
}

// Recordings leave out options that have their default.
TEST(Session, ARecordingWithOlderDefaultsGetsThem) {
  Session now(make_tools(), {}), old(make_tools(), {});
  ASSERT_TRUE(old.apply({0, SetOption{"pencil.reach_mm", 5.0}}));
  ASSERT_TRUE(old.apply({0, UseDevice{{}, 1}}));
  ASSERT_TRUE(now.apply({0, UseDevice{}}));
  EXPECT_EQ(old.option_defaults(), 1);
  EXPECT_EQ(now.option_defaults(), kOptionDefaults);
  EXPECT_EQ(old.option("pencil.reach_mm"), OptionValue(5.0)) << "was set, by --set of record";
  EXPECT_EQ(old.option("lasso.take"), OptionValue(std::string("points")));
  EXPECT_EQ(old.option("eraser.include_width"), OptionValue(false));
  for (const SetOption& changed : old_defaults(1)) {
    EXPECT_TRUE(now.option(changed.id)) << changed.id;
    EXPECT_NE(now.option(changed.id), changed.value) << changed.id;
    if (changed.id == "pencil.reach_mm") continue;
    EXPECT_EQ(old.option(changed.id), changed.value) << changed.id;
  }
  // Another device in the same recording does not change the options again.
  ASSERT_TRUE(old.apply({1, SetOption{"lasso.take", std::string("strokes")}}));
  ASSERT_TRUE(old.apply({1, UseDevice{{}, 1}}));
  EXPECT_EQ(old.option("lasso.take"), OptionValue(std::string("strokes")));
}

TEST(Session, EachVersionOfTheDefaultsHasItsOwn) {
  for (int version = 1; version <= kOptionDefaults; ++version) {
    Session session(make_tools(), {});
    ASSERT_TRUE(session.apply({0, UseDevice{{}, version}}));
    EXPECT_EQ(session.option("pencil.strength"), OptionValue(version < 3   ? 1.0
                                                             : version < 6 ? 0.5
                                                                           : 0.6));
    EXPECT_EQ(session.option("pencil.attraction_n"), OptionValue(version == 1 ? 0.6 : 0.2));
    EXPECT_EQ(session.option("pencil.retrace_n"), OptionValue(version < 8 ? 0.0 : 0.1));
    EXPECT_EQ(session.option("eraser.guard_n"), OptionValue(version < 9 ? 0.0 : 0.25));
    EXPECT_EQ(session.option("pull.yield_s"), OptionValue(version < 9 ? 0.0 : 0.01));
    const std::string take = version == 1 ? "points" : (version < 4 ? "strokes" : "parts");
    EXPECT_EQ(session.option("lasso.take"), OptionValue(take));
  }
}

TEST(Session, R14_RecordingsOfOlderVersionsKeepTheirPush) {
  for (const int version : {kFirmPushDefaults - 1, kFirmPushDefaults}) {
    Session session(make_tools(), {});
    const bool is_old = version < kFirmPushDefaults;
    const Capabilities strong{.max_force_n = 12.0, .continuous_force_n = 12.0};
    ASSERT_TRUE(session.apply({0, UseDevice{strong, version}}));
    EXPECT_EQ(session.device().full_push_n, is_old ? 2.0 : 1.2);
    std::int64_t now_ns = 0;
    for (int i = 0; i <= 400; ++i) {
      const double depth_mm = i < 400 ? 2.0 : -3.0;  // 1 N on paper
      ASSERT_TRUE(session.apply({now_ns += 1'000'000, PenEvent{{0.1 * i, 0.0, -depth_mm}, {}}}));
    }
    ASSERT_TRUE(session.finish());
    const StrokePtr line = session.document().find({1});
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->width_mm(0.5 * line->segment_count()), 0.3 + 5.7 * 0.9 / (is_old ? 1.9 : 1.1),
                0.2);
  }
}

TEST(Session, NamesStrokesSoThatTheyKeepTheirNames) {
  Fixture fixture;
  fixture.line(0, 0);
  fixture.line(0, 10);
  fixture.line(0, 20);
  const Document before = fixture.session.document();
  EXPECT_EQ(stroke_name(before.layers()[0].strokes[0]), "s1");
  EXPECT_EQ(stroke_name(before.layers()[0].strokes[2]), "s3");
  fixture.must(UndoEvent{});
  fixture.line(0, 30);
  const Document after = fixture.session.document();
  ASSERT_EQ(after.stroke_count(), 3U);
  EXPECT_EQ(visible_strokes(after)[1], visible_strokes(before)[1]);
  EXPECT_EQ(stroke_name(after.layers()[0].strokes[2]), "s4")
      << "an id never comes to name another stroke";
}

TEST(Session, StartsWithADocument) {
  Fixture source;
  source.line(0, 0);
  SessionOptions options;
  options.document = document_of(visible_strokes(source.session.document()));
  Fixture fixture(std::move(options));
  EXPECT_EQ(fixture.session.document(), source.session.document());
  EXPECT_FALSE(fixture.session.history().can_undo());
}

TEST(Session, SetsOptionsOfToolsAndOfTheSurface) {
  Fixture fixture;
  fixture.must(SetOption{"pencil.width_mm", 2.0});
  fixture.must(SetOption{"ink.color", std::string("#ff0000")});
  fixture.must(SetOption{"surface.material", std::string("glass")});
  EXPECT_EQ(fixture.session.option("pencil.width_mm"), OptionValue(2.0));
  EXPECT_EQ(fixture.session.option("ink.color"), OptionValue(std::string("#ff0000")));
  EXPECT_EQ(fixture.session.option("surface.material"), OptionValue(std::string("glass")));
  EXPECT_EQ(fixture.session.surface().id, "glass");
  fixture.line(0, 0);
  EXPECT_EQ(visible_strokes(fixture.session.document())[0]->width_mm(0), 2.0);
  EXPECT_EQ(visible_strokes(fixture.session.document())[0]->color(), (Rgba{255, 0, 0, 255}));
}

TEST(Session, FormerOptionIdsSetTheSameOptionsAndAreRecordedByTheirPresentIds) {
  std::vector<Event> recorded;
  SessionOptions options;
  options.on_event = [&recorded](const Event& event) { recorded.push_back(event); };
  Fixture fixture(std::move(options));
  fixture.must(SetOption{"sheet.material", std::string("glass")});
  fixture.must(SetOption{"sheet.color", std::string("#ff0000")});
  EXPECT_EQ(fixture.session.surface().id, "glass");
  EXPECT_EQ(fixture.session.ink_color(), (Rgba{255, 0, 0, 255}));
  EXPECT_EQ(fixture.session.option("sheet.color").value(),
            fixture.session.option("ink.color").value());
  EXPECT_EQ(recorded, (std::vector<Event>{{0, SetOption{"surface.material", std::string("glass")}},
                                          {0, SetOption{"ink.color", std::string("#ff0000")}}}));
}

TEST(Session, EveryListedOptionCanBeReadAndSet) {
  Fixture fixture;
  for (const std::string& id : fixture.session.option_ids()) {
    const Result<OptionValue> value = fixture.session.option(id);
    ASSERT_TRUE(value) << id;
    fixture.must(SetOption{id, *value});
    EXPECT_EQ(fixture.session.current_option_id(id), id);
  }
}

TEST(Session, EveryMaterialCanBeChosen) {
  Fixture fixture;
  for (const SurfaceMaterial& material : surface_materials()) {
    fixture.must(SetOption{"surface.material", std::string(material.id)});
    EXPECT_EQ(fixture.session.surface(), material);
  }
}

std::string text_of_surface(const std::string& id, const std::string& figures) {
  return "kind = \"surface\"\nid = \"" + id + "\"\n[feel]\n" + figures + "\n";
}

TEST(Session, IsToldOfMaterials) {
  std::vector<Event> recorded;
  SessionOptions options;
  options.on_event = [&recorded](const Event& event) { recorded.push_back(event); };
  Fixture fixture(std::move(options));
  const SetOption choose{"surface.material", std::string("my-paper")};
  EXPECT_THAT(
      fixture.apply(choose).error().message,
      HasSubstr("option 'material' cannot be 'my-paper': it must be one of paper, rough-paper"));
  fixture.must(UseMaterial{text_of_surface("my-paper", "friction = 0.4")});
  fixture.must(choose);
  EXPECT_EQ(fixture.session.surface().friction, 0.4);
  EXPECT_EQ(fixture.session.option("surface.material"), OptionValue(std::string("my-paper")));
  // The material changes while it is in use.
  fixture.must(UseMaterial{text_of_surface("my-paper", "friction = 0.7")});
  EXPECT_EQ(fixture.session.surface().friction, 0.7);
  EXPECT_EQ(fixture.session.materials().find_surface("my-paper")->friction, 0.7);
  EXPECT_EQ(recorded.size(), 3u);

  EXPECT_EQ(fixture.apply(UseMaterial{text_of_surface("my-paper", "friction = 7")}).error().message,
            "material:4: feel.friction is 7, it must be 0 to 1.5");
  EXPECT_FALSE(
      fixture.apply(UseMaterial{"kind = \"surface\"\nid = \"a\"\ngrain.picture = \"a.png\""}));
  EXPECT_EQ(fixture.session.surface().friction, 0.7);
  EXPECT_EQ(recorded.size(), 3u);
}

TEST(Session, FeelsAnotherFigureOfTheSameSurfaceFromThenOn) {
  Session session(make_tools(), {.device = Capabilities{.max_force_n = 3.3}});
  ASSERT_TRUE(session.apply({0, UseMaterial{text_of_surface("paper", "stiffness_n_per_m = 500")}}));
  const auto push = [&session] {
    ForceModel model = session.force();
    ForceMemory memory;
    PenSample sample;
    sample.position = {0.0, 0.0, -1.0};
    return std::pair(model.fade_id(), model(sample, memory).z);
  };
  const auto before = push();
  ASSERT_TRUE(session.apply({0, UseMaterial{text_of_surface("paper", "stiffness_n_per_m = 250")}}));
  const auto after = push();
  EXPECT_GT(before.second, 0.0);
  EXPECT_NEAR(after.second, 0.5 * before.second, 1e-9);
  EXPECT_NE(before.first, after.first) << "another feel is faded to";
  EXPECT_EQ(after, push());
}

TEST(Session, ARecordingHasTheMaterialsThatItNames) {
  const auto draw = [](Session& session) {
    for (const Event& event : {Event{1, SetOption{"pencil.medium", std::string("my-pen")}},
                               Event{2, SetOption{"pencil.medium", std::string("chalk")}},
                               Event{3, SetOption{"pencil.medium", std::string("my-pen")}},
                               Event{4, SetOption{"surface.material", std::string("my-paper")}}}) {
      ASSERT_TRUE(session.apply(event));
    }
  };
  std::vector<Event> recorded;
  SessionOptions options;
  options.on_event = [&recorded](const Event& event) { recorded.push_back(event); };
  Medium pen = *find_medium("ink-pen");
  pen.id = "my-pen";
  options.materials.put(pen);
  SurfaceMaterial paper = *find_surface("wood");
  paper.id = "my-paper";
  options.materials.put(paper);
  paper.id = "not-used";
  options.materials.put(paper);
  Session session(make_tools(), options);
  draw(session);
  ASSERT_EQ(recorded.size(), 6u) << "each is told once, and what is not named is not";
  EXPECT_EQ(std::get<UseMaterial>(recorded[0].what).text, write_material(pen));
  EXPECT_TRUE(std::holds_alternative<UseMaterial>(recorded[4].what));

  Session elsewhere(make_tools(), {});
  EXPECT_FALSE(elsewhere.apply({0, SetOption{"pencil.medium", std::string("my-pen")}}));
  for (const Event& event : recorded) {
    const Result<void> reported = elsewhere.apply(event);
    ASSERT_TRUE(reported) << reported.error().message;
  }
  EXPECT_EQ(elsewhere.surface(), session.surface());
  EXPECT_EQ(*elsewhere.materials().find_medium("my-pen"), pen);
  EXPECT_EQ(elsewhere.force().fade_id(), session.force().fade_id());
}

TEST(Session, OnlyWhatDrawsIsTakenIntoThePencil) {
  Session session(make_tools(), {});
  for (const Medium& medium : media()) {
    const Event event{0, SetOption{"pencil.medium", medium.id}};
    EXPECT_EQ(session.apply(event).has_value(), medium.draws) << medium.id;
  }
}

TEST(Session, SaysWhatIsWrongAndChangesNothing) {
  std::vector<Event> recorded;
  SessionOptions options;
  options.on_event = [&recorded](const Event& event) { recorded.push_back(event); };
  Fixture fixture(std::move(options));
  EXPECT_EQ(fixture.apply(SelectTool{"brush"}).error().message,
            "no tool \"brush\"; the tools are eraser, pencil");
  EXPECT_THAT(fixture.apply(SetOption{"brush.size", 1.0}).error().message, HasSubstr("no tool"));
  EXPECT_THAT(fixture.apply(SetOption{"pencil", 1.0}).error().message, HasSubstr("pencil"));
  EXPECT_THAT(fixture.apply(SetOption{"pencil.width_mm", 9.0}).error().message,
              HasSubstr("width_mm"));
  EXPECT_THAT(fixture.apply(SetOption{"ink.color", 1.0}).error().message,
              HasSubstr("ink: color: a number or switch is not #rrggbb"));
  EXPECT_THAT(fixture.apply(SetOption{"ink.color", std::string("red")}).error().message,
              HasSubstr("ink: color: \"red\" is not #rrggbb"));
  EXPECT_THAT(fixture.apply(SetOption{"surface.material", std::string("mud")}).error().message,
              HasSubstr("surface: option 'material' cannot be 'mud'"));
  EXPECT_EQ(fixture.apply(HandEvent{}).error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(fixture.apply(ImportEvent{"a"}).error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(fixture.session.option("pencil.width_mm"), OptionValue(1.0));
  EXPECT_FALSE(fixture.session.option("pencil.nothing"));
  EXPECT_TRUE(recorded.empty());
}

TEST(Session, DropsSamplesThatNoDeviceCanMean) {
  Fixture fixture;
  fixture.put_down(0, 0);
  fixture.pen(std::numeric_limits<double>::quiet_NaN(), 0, -1);
  fixture.pen(0, std::numeric_limits<double>::infinity(), -1);
  fixture.pen(0, 0, -2e9);
  fixture.pen(5, 0, -1);
  fixture.lift(5, 0);
  EXPECT_EQ(fixture.session.dropped_samples(), 3U);
  EXPECT_EQ(visible_strokes(fixture.session.document())[0]->segment_count(), 1);
}

TEST(Session, TiltsAreHeldToWhatAPenCanDo) {
  std::vector<Event> recorded;
  SessionOptions options;
  options.on_event = [&](const Event& event) { recorded.push_back(event); };
  Fixture fixture(std::move(options));
  const auto tilt = [&](std::optional<double> reported) {
    fixture.must(PenEvent{{0, 0, 5}, {}, 0, reported});
    return std::get<PenEvent>(recorded.back().what).tilt_deg;
  };
  EXPECT_EQ(tilt({}), std::nullopt);
  EXPECT_EQ(tilt(32.5), 32.5);
  EXPECT_EQ(tilt(-1.0), 0.0);
  EXPECT_EQ(tilt(std::numeric_limits<double>::infinity()), 90.0);
  EXPECT_EQ(tilt(std::numeric_limits<double>::quiet_NaN()), std::nullopt);
  EXPECT_EQ(fixture.session.dropped_samples(), 0U) << "the place is as good as ever";
}

TEST(Session, TellsEveryEditSoThatACopyFollows) {
  Document copy;
  std::vector<Event> recorded;
  SessionOptions options;
  options.on_edit = [&copy](const Edit& edit) { ASSERT_TRUE(copy.apply(edit)); };
  options.on_event = [&recorded](const Event& event) { recorded.push_back(event); };
  Fixture fixture(std::move(options));
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    const unsigned what = random() % 8;
    if (what < 4) fixture.line(static_cast<double>(random() % 100), static_cast<double>(i));
    if (what == 4) fixture.must(UndoEvent{});
    if (what == 5) fixture.must(RedoEvent{});
    if (what == 6) fixture.must(SelectTool{random() % 4 ? "pencil" : "eraser"});
    if (what == 7) fixture.pen(static_cast<double>(random() % 100), 0, random() % 2 ? -1 : 1);
    ASSERT_TRUE(copy == fixture.session.document()) << "step " << i;
  }
  EXPECT_GT(fixture.session.edit_count(), 100U);

  // If another session gets the recorded events, it reaches the same state.
  Fixture again;
  for (const Event& event : recorded) ASSERT_TRUE(again.session.apply(event));
  EXPECT_TRUE(again.session.document() == fixture.session.document());
}

TEST(Session, R52_RandomGesturesUndoToTheStartAndRedoToTheEnd) {
  Fixture fixture;
  std::mt19937 random(52);
  std::vector<Document> steps = {fixture.session.document()};
  while (steps.size() <= 1000) {
    fixture.must(SelectTool{random() % 4 ? "pencil" : "eraser"});
    fixture.line(static_cast<double>(random() % 100), static_cast<double>(random() % 100));
    if (fixture.session.history().undo_count() == steps.size()) {
      steps.push_back(fixture.session.document());
    }
  }
  for (std::size_t i = steps.size() - 1; i-- > 0;) {
    fixture.must(UndoEvent{});
    ASSERT_EQ(fixture.session.document(), steps[i]) << "back to step " << i;
  }
  for (std::size_t i = 1; i < steps.size(); ++i) {
    fixture.must(RedoEvent{});
    ASSERT_EQ(fixture.session.document(), steps[i]) << "again to step " << i;
  }
}

TEST(Session, TheForceIsThatOfTheTool) {
  Fixture fixture;
  ForceMemory memory;
  const PenSample pressing{0, {0, 0, -1}, {}, {}, 0};
  EXPECT_DOUBLE_EQ(fixture.session.force()(pressing, memory).z, 0.3);
  fixture.must(SetOption{"pencil.hard", true});
  EXPECT_DOUBLE_EQ(fixture.session.force()(pressing, memory).z, 0.6);
}

/// Returns the guide's part of the session's force on a pen that has touched at `p` for 0.2 s.
Vec guide_force(const Session& session, Point p) {
  const ForceModel model = session.force();
  ForceMemory memory;
  PenSample sample;
  sample.position = {p.x, p.y, -1.0};
  for (int i = 0; i < 200; ++i) {
    memory.begin_tick(0.001);
    static_cast<void>(model(sample, memory));
  }
  for (const ForceTerms::Term& term : memory.terms) {
    if (std::string_view(term.name) == "guide") return {term.force.x, term.force.y};
  }
  return {};
}

TEST(Session, GuidesThePencil) {
  Fixture fixture;
  fixture.session = Session(make_tools(), {.device = Capabilities{.max_force_n = 3.3}});
  const Session& session = fixture.session;
  fixture.put_down(20.0, 11.0);
  const std::uint32_t free = session.force().fade_id();
  EXPECT_EQ(guide_force(session, {20.0, 11.0}), Vec{});
  GuideLine line{.kind = GuideKind::kGroove, .points = {{0.0, 10.0}, {50.0, 10.0}}};
  fixture.must(UseGuide{line});
  ASSERT_NE(session.guide(), nullptr);
  EXPECT_EQ(*session.guide(), line);
  fixture.pen(20.0, 11.0, -1.0);
  EXPECT_NEAR(guide_force(session, {20.0, 11.0}).y, -0.3, 1e-6);
  EXPECT_NEAR(guide_force(session, {20.0, 11.0}).x, 0.0, 1e-6);
  const std::uint32_t guided = session.force().fade_id();
  EXPECT_NE(guided, free);
  fixture.pen(20.5, 11.0, -1.0);
  EXPECT_EQ(session.force().fade_id(), guided) << "the piece moves without a cross-fade";

  line.kind = GuideKind::kErrorAmplifying;
  line.strength = 0.5;
  fixture.must(UseGuide{line});
  EXPECT_NE(session.force().fade_id(), guided);
  fixture.pen(20.5, 11.0, -1.0);
  EXPECT_NEAR(guide_force(session, {20.5, 11.0}).y, 0.1 / 3.0, 2e-3);
  const Result<void> refused = fixture.apply(UseGuide{{.kind = GuideKind::kGroove}});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("points: "));
  EXPECT_EQ(session.guide()->kind, GuideKind::kErrorAmplifying);
  fixture.must(SelectTool{"eraser"});
  EXPECT_EQ(guide_force(session, {20.5, 11.0}), Vec{}) << "only the pencil is guided";
  fixture.must(SelectTool{"pencil"});
  fixture.must(UseGuide{});
  EXPECT_EQ(session.guide(), nullptr);
  EXPECT_EQ(session.force().fade_id(), free);
}

}  // namespace
}  // namespace felt::session_test
