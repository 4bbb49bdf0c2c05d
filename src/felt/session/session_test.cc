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
struct Desk {
  explicit Desk(SessionOptions options = {}) : session(fake_tools(), std::move(options)) {}

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
  Result<void> tell(What what) {
    return session.apply({now_ns, std::move(what)});
  }
  template <class What>
  void must(What what) {
    const Result<void> done = tell(std::move(what));
    ASSERT_TRUE(done) << done.error().message;
  }
  [[nodiscard]] std::size_t strokes() const { return session.document().stroke_count(); }

  std::int64_t now_ns = 0;
  Session session;
};

TEST(Session, StartsWithThePencil) {
  EXPECT_EQ(Desk().session.tool().info().id, "pencil");
}

/// Uses the real tools. The pen must be lifted before the chosen tool may begin a gesture.
TEST(Session, AToolChosenWithThePenDownWaitsForTheLift) {
  Desk desk;
  desk.session = Session(make_tools(), {});
  desk.put_down(0, 0);
  desk.pen(5, 0, -1);
  desk.must(SelectTool{"eraser"});
  desk.must(SelectTool{"pencil"});
  EXPECT_EQ(desk.strokes(), 1U) << "the line that was being drawn stays";
  desk.pen(10, 0, -1);
  desk.pen(15, 0, 0.2);  // not lifted yet
  desk.pen(20, 0, -1);
  desk.lift(20, 0);
  EXPECT_EQ(desk.strokes(), 1U);
  // The pen is just above the surface, then down again. The pencil has discarded its earlier state.
  desk.pen(30, 0, 0.2);
  desk.pen(30, 0, -1);
  desk.pen(40, 0, -1);
  desk.lift(40, 0);
  EXPECT_EQ(desk.strokes(), 2U);
}

TEST(Session, AGestureIsOneStepOfUndo) {
  Desk desk;
  desk.line(0, 0);
  desk.line(0, 10);
  EXPECT_EQ(desk.strokes(), 2U);
  EXPECT_EQ(desk.session.history().undo_count(), 2U);
  const Document both = desk.session.document();
  desk.must(UndoEvent{});
  EXPECT_EQ(desk.strokes(), 1U);
  desk.must(RedoEvent{});
  EXPECT_EQ(desk.session.document(), both);
  desk.must(UndoEvent{});
  desk.must(UndoEvent{});
  EXPECT_EQ(desk.strokes(), 0U);
}

TEST(Session, NothingToUndoOrRedoIsNoError) {
  Desk desk;
  desk.must(UndoEvent{});
  desk.must(RedoEvent{});
  EXPECT_EQ(desk.strokes(), 0U);
}

TEST(Session, ShowsAPreviewUntilTheRelease) {
  Desk desk;
  desk.put_down(0, 0);
  desk.pen(5, 0, -1);
  EXPECT_TRUE(desk.session.gesture_in_work());
  ASSERT_TRUE(desk.session.preview());
  EXPECT_EQ(desk.session.preview()->changes.size(), 1U);
  EXPECT_EQ(desk.strokes(), 0U);
  Overlay overlay;
  desk.session.draw(overlay);
  EXPECT_EQ(overlay.rings.size(), 2U);
  desk.lift(5, 0);
  EXPECT_FALSE(desk.session.preview());
  EXPECT_FALSE(desk.session.gesture_in_work());
  desk.session.draw(overlay);
  EXPECT_TRUE(overlay.rings.empty());
  EXPECT_EQ(desk.strokes(), 1U);
}

TEST(Session, UndoInAGestureTakesBackOnlyThat) {
  Desk desk;
  desk.line(0, 0);
  desk.put_down(0, 10);
  desk.pen(5, 10, -1);
  desk.must(UndoEvent{});
  EXPECT_EQ(desk.strokes(), 1U);
  EXPECT_FALSE(desk.session.preview());
  desk.pen(10, 10, -1);  // still down: draws nothing until it is lifted
  desk.lift(10, 10);
  EXPECT_EQ(desk.strokes(), 1U);
  desk.line(0, 20);
  EXPECT_EQ(desk.strokes(), 2U);
}

TEST(Session, UndoAtTheFirstTouchTakesBackOnlyThat) {
  Desk desk;
  desk.line(0, 0);
  desk.put_down(0, 10);  // no preview yet
  desk.must(UndoEvent{});
  EXPECT_EQ(desk.strokes(), 1U);
}

TEST(Session, UndoRightAfterTheLiftTakesBackTheLineThatWaits) {
  Desk desk;
  desk.line(0, 0);
  desk.put_down(0, 10);
  desk.pen(5, 10, -1);
  desk.pen(5, 10, 0.1);  // the tool still expects a bounce
  desk.must(UndoEvent{});
  EXPECT_EQ(desk.strokes(), 1U);
  EXPECT_TRUE(desk.session.history().can_redo());
  desk.lift(5, 10);
  EXPECT_EQ(desk.strokes(), 1U);
  desk.must(RedoEvent{});
  EXPECT_EQ(desk.strokes(), 2U);
}

TEST(Session, RedoInAGestureDoesNothing) {
  Desk desk;
  desk.line(0, 0);
  desk.must(UndoEvent{});
  desk.put_down(0, 10);
  desk.must(RedoEvent{});
  EXPECT_EQ(desk.strokes(), 0U);
  desk.pen(5, 10, -1);
  desk.lift(5, 10);
  EXPECT_EQ(desk.strokes(), 1U);
  EXPECT_FALSE(desk.session.history().can_redo());
}

TEST(Session, UndoWhileThePenIsStillDownAfterTheOutcome) {
  Desk desk;
  desk.line(0, 0);
  desk.line(0, 10);
  desk.must(SelectTool{"eraser"});
  desk.put_down(0, 0);
  EXPECT_EQ(desk.strokes(), 1U);
  desk.must(UndoEvent{});
  EXPECT_EQ(desk.strokes(), 2U);
  desk.pen(1, 1, -1);  // does not erase again
  EXPECT_EQ(desk.strokes(), 2U);
}

TEST(Session, CancelMeansItNeverWas) {
  Desk desk;
  desk.put_down(0, 0);
  desk.pen(5, 0, -1);
  desk.must(CancelEvent{});
  EXPECT_FALSE(desk.session.preview());
  desk.pen(10, 0, -1);
  desk.lift(10, 0);
  EXPECT_EQ(desk.strokes(), 0U);
  EXPECT_FALSE(desk.session.history().can_undo());
}

TEST(Session, WhatComesAfterAToolWasChosenInAGestureDoesNotEndTheWaitForTheLift) {
  Desk desk;
  desk.line(0, 10);
  desk.must(SelectTool{"eraser"});
  desk.must(SelectTool{"pencil"});
  desk.put_down(0, 0);
  desk.pen(5, 0, -1);
  desk.must(SelectTool{"eraser"});
  EXPECT_EQ(desk.strokes(), 2U);
  desk.must(SelectStrokes{SelectStrokes::What::kAll});
  desk.must(UndoEvent{});
  EXPECT_EQ(desk.strokes(), 1U);
  desk.pen(6, 0, -1);
  EXPECT_EQ(desk.strokes(), 1U) << "the pen is still down";
  desk.lift(6, 0);
  desk.put_down(6, 0);
  EXPECT_EQ(desk.strokes(), 0U);
}

TEST(Session, AToolChosenInAGestureKeepsTheInkAndWaitsForALift) {
  Desk desk;
  desk.put_down(0, 0);
  desk.pen(5, 0, -1);
  desk.must(SelectTool{"eraser"});
  EXPECT_EQ(desk.strokes(), 1U);
  EXPECT_FALSE(desk.session.gesture_in_work());
  desk.pen(6, 0, -1);  // would erase it
  EXPECT_EQ(desk.strokes(), 1U);
  desk.lift(6, 0);
  desk.put_down(6, 0);
  EXPECT_EQ(desk.strokes(), 0U);
}

TEST(Session, AToolChosenInTheAirBeginsAtOnce) {
  Desk desk;
  desk.line(0, 0);
  desk.must(SelectTool{"eraser"});
  desk.pen(0, 0, -1);
  EXPECT_EQ(desk.strokes(), 0U);
  desk.must(SelectTool{"pencil"});  // waits for a lift
  desk.must(SelectTool{"pencil"});  // the same tool: no effect
  EXPECT_EQ(desk.session.tool().info().id, "pencil");
}

TEST(Session, FinishEndsAGestureAsALiftWould) {
  Desk lifted, finished;
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
  Desk source;
  source.line(0, 0);
  source.line(0, 10);
  Desk desk;
  desk.put_down(0, 20);
  desk.pen(5, 20, -1);
  ASSERT_TRUE(
      desk.session.import(desk.now_ns, {"a.ndjson"}, visible_strokes(source.session.document())));
  EXPECT_EQ(desk.strokes(), 3U);
  EXPECT_EQ(visible_strokes(desk.session.document())[1],
            visible_strokes(source.session.document())[0]);
  EXPECT_EQ(desk.session.history().undo_count(), 2U);
  desk.pen(8, 20, -1);
  desk.lift(8, 20);
  desk.must(UndoEvent{});
  EXPECT_EQ(desk.strokes(), 1U) << "a dot is no line to this tool, so the import was undone";
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
  for (const SetOption& changed : defaults_of_version_1()) {
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

TEST(Session, NamesStrokesSoThatTheyKeepTheirNames) {
  Desk desk;
  desk.line(0, 0);
  desk.line(0, 10);
  desk.line(0, 20);
  const Document before = desk.session.document();
  EXPECT_EQ(stroke_name(before.layers()[0].strokes[0]), "s1");
  EXPECT_EQ(stroke_name(before.layers()[0].strokes[2]), "s3");
  desk.must(UndoEvent{});
  desk.line(0, 30);
  const Document after = desk.session.document();
  ASSERT_EQ(after.stroke_count(), 3U);
  EXPECT_EQ(visible_strokes(after)[1], visible_strokes(before)[1]);
  EXPECT_EQ(stroke_name(after.layers()[0].strokes[2]), "s4")
      << "an id never comes to name another stroke";
}

TEST(Session, StartsWithADocument) {
  Desk source;
  source.line(0, 0);
  SessionOptions options;
  options.document = document_of(visible_strokes(source.session.document()));
  Desk desk(std::move(options));
  EXPECT_EQ(desk.session.document(), source.session.document());
  EXPECT_FALSE(desk.session.history().can_undo());
}

TEST(Session, SetsOptionsOfToolsAndOfTheSurface) {
  Desk desk;
  desk.must(SetOption{"pencil.width_mm", 2.0});
  desk.must(SetOption{"ink.color", std::string("#ff0000")});
  desk.must(SetOption{"surface.material", std::string("glass")});
  EXPECT_EQ(desk.session.option("pencil.width_mm"), OptionValue(2.0));
  EXPECT_EQ(desk.session.option("ink.color"), OptionValue(std::string("#ff0000")));
  EXPECT_EQ(desk.session.option("surface.material"), OptionValue(std::string("glass")));
  EXPECT_EQ(desk.session.surface().id, "glass");
  desk.line(0, 0);
  EXPECT_EQ(visible_strokes(desk.session.document())[0]->width_mm(0), 2.0);
  EXPECT_EQ(visible_strokes(desk.session.document())[0]->color(), (Rgba{255, 0, 0, 255}));
}

TEST(Session, EveryMaterialCanBeChosen) {
  Desk desk;
  for (const SurfaceMaterial& material : surface_materials()) {
    desk.must(SetOption{"surface.material", std::string(material.id)});
    EXPECT_EQ(desk.session.surface(), material);
  }
}

std::string text_of_surface(const std::string& id, const std::string& figures) {
  return "kind = \"sheet\"\nid = \"" + id + "\"\n[feel]\n" + figures + "\n";
}

TEST(Session, IsToldOfMaterials) {
  std::vector<Event> recorded;
  SessionOptions options;
  options.on_event = [&recorded](const Event& event) { recorded.push_back(event); };
  Desk desk(std::move(options));
  const SetOption choose{"surface.material", std::string("my-paper")};
  EXPECT_THAT(desk.tell(choose).error().message,
              HasSubstr("option 'material' cannot be 'my-paper': it is one of paper, rough-paper"));
  desk.must(UseMaterial{text_of_surface("my-paper", "friction = 0.4")});
  desk.must(choose);
  EXPECT_EQ(desk.session.surface().friction, 0.4);
  EXPECT_EQ(desk.session.option("surface.material"), OptionValue(std::string("my-paper")));
  // The material changes while it is in use.
  desk.must(UseMaterial{text_of_surface("my-paper", "friction = 0.7")});
  EXPECT_EQ(desk.session.surface().friction, 0.7);
  EXPECT_EQ(desk.session.materials().find_surface("my-paper")->friction, 0.7);
  EXPECT_EQ(recorded.size(), 3u);

  EXPECT_EQ(desk.tell(UseMaterial{text_of_surface("my-paper", "friction = 7")}).error().message,
            "material:4: feel.friction is 7, it must be 0 to 1.5");
  EXPECT_FALSE(desk.tell(UseMaterial{"kind = \"sheet\"\nid = \"a\"\ngrain.picture = \"a.png\""}));
  EXPECT_EQ(desk.session.surface().friction, 0.7);
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
    const Result<void> told = elsewhere.apply(event);
    ASSERT_TRUE(told) << told.error().message;
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
  Desk desk(std::move(options));
  EXPECT_EQ(desk.tell(SelectTool{"brush"}).error().message,
            "no tool \"brush\"; there are eraser, pencil");
  EXPECT_THAT(desk.tell(SetOption{"brush.size", 1.0}).error().message, HasSubstr("no tool"));
  EXPECT_THAT(desk.tell(SetOption{"pencil", 1.0}).error().message, HasSubstr("pencil"));
  EXPECT_THAT(desk.tell(SetOption{"pencil.width_mm", 9.0}).error().message, HasSubstr("width_mm"));
  EXPECT_THAT(desk.tell(SetOption{"ink.color", 1.0}).error().message,
              HasSubstr("sheet: color: a number or switch is not #rrggbb"));
  EXPECT_THAT(desk.tell(SetOption{"ink.color", std::string("red")}).error().message,
              HasSubstr("sheet: color: \"red\" is not #rrggbb"));
  EXPECT_THAT(desk.tell(SetOption{"surface.material", std::string("mud")}).error().message,
              HasSubstr("sheet: option 'material' cannot be 'mud'"));
  EXPECT_EQ(desk.tell(HandEvent{}).error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(desk.tell(ImportEvent{"a"}).error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(desk.session.option("pencil.width_mm"), OptionValue(1.0));
  EXPECT_FALSE(desk.session.option("pencil.nothing"));
  EXPECT_TRUE(recorded.empty());
}

TEST(Session, DropsSamplesThatNoDeviceCanMean) {
  Desk desk;
  desk.put_down(0, 0);
  desk.pen(std::numeric_limits<double>::quiet_NaN(), 0, -1);
  desk.pen(0, std::numeric_limits<double>::infinity(), -1);
  desk.pen(0, 0, -2e9);
  desk.pen(5, 0, -1);
  desk.lift(5, 0);
  EXPECT_EQ(desk.session.dropped_samples(), 3U);
  EXPECT_EQ(visible_strokes(desk.session.document())[0]->segment_count(), 1);
}

TEST(Session, TiltsAreHeldToWhatAPenCanDo) {
  std::vector<Event> recorded;
  SessionOptions options;
  options.on_event = [&](const Event& event) { recorded.push_back(event); };
  Desk desk(std::move(options));
  const auto tilt = [&](std::optional<double> told) {
    desk.must(PenEvent{{0, 0, 5}, {}, 0, told});
    return std::get<PenEvent>(recorded.back().what).tilt_deg;
  };
  EXPECT_EQ(tilt({}), std::nullopt);
  EXPECT_EQ(tilt(32.5), 32.5);
  EXPECT_EQ(tilt(-1.0), 0.0);
  EXPECT_EQ(tilt(std::numeric_limits<double>::infinity()), 90.0);
  EXPECT_EQ(tilt(std::numeric_limits<double>::quiet_NaN()), std::nullopt);
  EXPECT_EQ(desk.session.dropped_samples(), 0U) << "the place is as good as ever";
}

TEST(Session, TellsEveryEditSoThatACopyFollows) {
  Document copy;
  std::vector<Event> recorded;
  SessionOptions options;
  options.on_edit = [&copy](const Edit& edit) { ASSERT_TRUE(copy.apply(edit)); };
  options.on_event = [&recorded](const Event& event) { recorded.push_back(event); };
  Desk desk(std::move(options));
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    const unsigned what = random() % 8;
    if (what < 4) desk.line(static_cast<double>(random() % 100), static_cast<double>(i));
    if (what == 4) desk.must(UndoEvent{});
    if (what == 5) desk.must(RedoEvent{});
    if (what == 6) desk.must(SelectTool{random() % 4 ? "pencil" : "eraser"});
    if (what == 7) desk.pen(static_cast<double>(random() % 100), 0, random() % 2 ? -1 : 1);
    ASSERT_TRUE(copy == desk.session.document()) << "step " << i;
  }
  EXPECT_GT(desk.session.edit_count(), 100U);

  // If another session gets the recorded events, it reaches the same state.
  Desk again;
  for (const Event& event : recorded) ASSERT_TRUE(again.session.apply(event));
  EXPECT_TRUE(again.session.document() == desk.session.document());
}

TEST(Session, R52_RandomGesturesUndoToTheStartAndRedoToTheEnd) {
  Desk desk;
  std::mt19937 random(52);
  std::vector<Document> steps = {desk.session.document()};
  while (steps.size() <= 1000) {
    desk.must(SelectTool{random() % 4 ? "pencil" : "eraser"});
    desk.line(static_cast<double>(random() % 100), static_cast<double>(random() % 100));
    if (desk.session.history().undo_count() == steps.size()) {
      steps.push_back(desk.session.document());
    }
  }
  for (std::size_t i = steps.size() - 1; i-- > 0;) {
    desk.must(UndoEvent{});
    ASSERT_EQ(desk.session.document(), steps[i]) << "back to step " << i;
  }
  for (std::size_t i = 1; i < steps.size(); ++i) {
    desk.must(RedoEvent{});
    ASSERT_EQ(desk.session.document(), steps[i]) << "again to step " << i;
  }
}

TEST(Session, TheForceIsThatOfTheTool) {
  Desk desk;
  ForceMemory memory;
  const PenSample pressing{0, {0, 0, -1}, {}, {}, 0};
  EXPECT_DOUBLE_EQ(desk.session.force()(pressing, memory).z, 0.3);
  desk.must(SetOption{"pencil.hard", true});
  EXPECT_DOUBLE_EQ(desk.session.force()(pressing, memory).z, 0.6);
}

}  // namespace
}  // namespace felt::session_test
