// Tests of the commands of a session.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <random>

#include "felt/document/visible_strokes.h"
#include "felt/session/session.h"
#include "felt/session/testing/fake_tools.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::session_commands_test {
namespace {

using Do = LayerEvent::Do;
using What = SelectStrokes::What;

/// A tool that answers each sample with a prepared result.
class ScriptedTool : public FakePencil {
 public:
  std::deque<ToolResult> answers;

  ToolResult sample(const PenSample& sample, Contact::Change contact, const Scene& scene) override {
    layer = scene.layer;
    selected = scene.selection.strokes().size();
    if (answers.empty()) return FakePencil::sample(sample, contact, scene);
    ToolResult answer = std::move(answers.front());
    answers.pop_front();
    return answer;
  }

  LayerId layer;  ///< layer of the last scene
  std::size_t selected = 0;
};

struct CommandDesk {
  explicit CommandDesk(SessionOptions options = {})
      : tool(new ScriptedTool), session(tools(tool), std::move(options)) {}

  static std::vector<std::unique_ptr<Tool>> tools(ScriptedTool* tool) {
    std::vector<std::unique_ptr<Tool>> list;
    list.emplace_back(tool);
    list.push_back(std::make_unique<FakeEraser>());
    return list;
  }

  void pen(double x, double y, double z) { must(PenEvent{{x, y, z}, {}, 0}); }
  void line(double x, double y) {
    pen(x, y, 5);
    pen(x, y, -1);
    pen(x + 10, y, -1);
    pen(x + 10, y, 5);
  }
  template <class Command>
  Result<void> tell(Command what) {
    return session.apply({now_ns += 1'000'000, std::move(what)});
  }
  template <class Command>
  void must(Command what) {
    const Result<void> done = tell(std::move(what));
    ASSERT_TRUE(done) << done.error().message;
  }
  void layer(Do what, std::uint64_t id = 0, std::string name = {}) {
    must(LayerEvent{what, {id}, std::move(name)});
  }
  [[nodiscard]] std::vector<std::uint64_t> selected() const {
    std::vector<std::uint64_t> ids;
    for (const auto& [id, marks] : session.selection().strokes()) ids.push_back(id.value);
    return ids;
  }
  [[nodiscard]] std::vector<std::uint64_t> layers() const {
    std::vector<std::uint64_t> ids;
    for (const Layer& l : session.document().layers()) ids.push_back(l.id.value);
    return ids;
  }
  [[nodiscard]] std::size_t steps() const { return session.history().undo_count(); }

  std::int64_t now_ns = 0;
  ScriptedTool* tool;
  Session session;
};

using Ids = std::vector<std::uint64_t>;

Selection::Marks first_point_of(const CommandDesk& desk, std::uint64_t id) {
  Selection::Marks marks(desk.session.document().find({id})->data().points.size(), 0);
  marks.front() = 1;
  return marks;
}

TEST(SessionSelection, AllNoneAndInvertTakeWhatMayBeEdited) {
  CommandDesk desk;
  desk.line(0, 0);
  desk.line(0, 10);
  desk.layer(Do::kAdd);
  desk.line(0, 20);
  desk.must(SelectStrokes{What::kAll});
  EXPECT_EQ(desk.selected(), (Ids{1, 2, 3}));
  EXPECT_EQ(desk.steps(), 4U) << "a selection is no step";
  desk.layer(Do::kLock, 1);
  EXPECT_EQ(desk.selected(), (Ids{3})) << "what is locked is no longer selected";
  desk.must(SelectStrokes{What::kInvert});
  EXPECT_EQ(desk.selected(), Ids{});
  desk.layer(Do::kUnlock, 1);
  desk.must(SelectStrokes{What::kInvert});
  EXPECT_EQ(desk.selected(), (Ids{1, 2, 3}));
  desk.layer(Do::kHide, 2);
  EXPECT_EQ(desk.selected(), (Ids{1, 2}));
  desk.must(SelectStrokes{What::kNone});
  EXPECT_EQ(desk.selected(), Ids{});
}

TEST(SessionSelection, IsWhatTheToolSaysAndTheToolSeesIt) {
  CommandDesk desk;
  desk.line(0, 0);
  desk.line(0, 10);
  Selection chosen;
  chosen.set({1}, first_point_of(desk, 1));
  chosen.set_whole({7}, 4);   // the stroke does not exist
  chosen.set_whole({2}, 10);  // wrong number of points
  desk.tool->answers.push_back({.selection = chosen});
  desk.pen(0, 0, 5);
  EXPECT_EQ(desk.selected(), (Ids{1}));
  desk.pen(0, 0, 5);
  EXPECT_EQ(desk.tool->selected, 1U);
  desk.must(SelectStrokes{What::kInvert});
  EXPECT_EQ(desk.selected(), (Ids{1, 2})) << "selected in part: the inverse has all of it";
  EXPECT_TRUE(desk.session.selection().is_whole({1}));
}

TEST(SessionSelection, DeleteRemovesWhatIsWhollySelected) {
  CommandDesk desk;
  for (int i = 0; i < 4; ++i) desk.line(0, 10 * i);
  desk.must(DeleteEvent{});
  EXPECT_EQ(desk.steps(), 4U) << "nothing is selected, nothing happens";
  Selection chosen;
  chosen.set({1}, first_point_of(desk, 1));
  chosen.set_whole({2}, desk.session.document().find({2})->data().points.size());
  chosen.set_whole({4}, desk.session.document().find({4})->data().points.size());
  desk.tool->answers.push_back({.selection = chosen});
  desk.pen(0, 0, 5);
  const Document before = desk.session.document();
  desk.must(DeleteEvent{});
  EXPECT_EQ(desk.session.document().stroke_count(), 2U);
  EXPECT_EQ(visible_strokes(desk.session.document())[1], visible_strokes(before)[2]);
  EXPECT_EQ(desk.selected(), (Ids{1})) << "one that is selected in part stays, and so selected";
  EXPECT_EQ(desk.steps(), 5U);
  desk.must(DeleteEvent{});
  EXPECT_EQ(desk.steps(), 5U);
  desk.must(UndoEvent{});
  EXPECT_EQ(desk.session.document(), before);
}

TEST(SessionSelection, DuplicateAddsShiftedCopiesWhichAreSelectedThen) {
  CommandDesk desk;
  desk.line(0, 0);
  desk.layer(Do::kAdd);
  desk.line(0, 10);
  desk.must(SelectStrokes{What::kAll});
  desk.must(DuplicateEvent{});
  EXPECT_EQ(desk.selected(), (Ids{3, 4}));
  EXPECT_EQ(desk.steps(), 4U);
  const Document& document = desk.session.document();
  EXPECT_EQ(document.layer_of({3}).value, 1U);
  EXPECT_EQ(document.layer_of({4}).value, 2U);
  StrokeData moved = document.find({1})->data();
  for (Point& p : moved.points) p = p + Vec{5, 5};
  EXPECT_EQ(document.find({3})->data(), moved);
  desk.must(UndoEvent{});
  EXPECT_EQ(document.stroke_count(), 2U);
  EXPECT_EQ(desk.selected(), Ids{}) << "what is gone is not selected";
  desk.must(DuplicateEvent{});
  EXPECT_EQ(document.stroke_count(), 2U);
}

TEST(SessionLayers, NewInkGoesToTheLayerInUse) {
  CommandDesk desk;
  desk.layer(Do::kAdd, 0, "Ideas");
  EXPECT_EQ(desk.session.layer().value, 2U);
  desk.layer(Do::kUse, 1);
  EXPECT_EQ(desk.steps(), 1U) << "use is no step";
  desk.line(0, 0);
  EXPECT_EQ(desk.tool->layer.value, 1U);
  EXPECT_EQ(desk.session.document().layer_of({1}).value, 1U);
  desk.layer(Do::kAdd);
  EXPECT_EQ(desk.layers(), (Ids{1, 3, 2})) << "above the one that was in use";
  EXPECT_EQ(desk.session.document().layer({2})->name, "Ideas");
  EXPECT_EQ(desk.session.document().layer({3})->name, "Layer 3");
  CommandDesk other;
  ASSERT_TRUE(desk.session.import(desk.now_ns, {"a"}, visible_strokes(desk.session.document())));
  EXPECT_EQ(desk.session.document().layer_of({2}).value, 3U);
}

TEST(SessionLayers, EachCommandIsOneStepAndUndone) {
  CommandDesk desk;
  desk.line(0, 0);
  desk.layer(Do::kAdd);
  desk.line(0, 10);
  const auto is_one_step = [&](const LayerEvent& event, Ids layers, std::size_t shown) {
    SCOPED_TRACE(static_cast<int>(event.what));
    const Document before = desk.session.document();
    const std::size_t steps = desk.steps();
    desk.must(event);
    EXPECT_EQ(desk.steps(), steps + 1);
    EXPECT_EQ(desk.layers(), layers);
    EXPECT_EQ(visible_strokes(desk.session.document()).size(), shown);
    desk.must(event);
    EXPECT_EQ(desk.steps(), steps + 1) << "again: nothing changes";
    desk.must(UndoEvent{});
    EXPECT_TRUE(desk.session.document() == before);
  };
  is_one_step({Do::kRename, {1}, "Base"}, {1, 2}, 2);
  is_one_step({Do::kHide, {1}, ""}, {1, 2}, 1);
  is_one_step({Do::kLock, {2}, ""}, {1, 2}, 2);
  is_one_step({Do::kRaise, {1}, ""}, {2, 1}, 2);
  is_one_step({Do::kLower, {2}, ""}, {2, 1}, 2);
  is_one_step({Do::kMove, {1}, "", 1}, {2, 1}, 2);
  is_one_step({Do::kMove, {2}, "", 0}, {2, 1}, 2);
  desk.layer(Do::kAdd);
  is_one_step({Do::kMove, {1}, "", 2}, {3, 2, 1}, 2);
  is_one_step({Do::kMove, {1}, "", 99}, {3, 2, 1}, 2);
  is_one_step({Do::kMove, {3}, "", 0}, {3, 1, 2}, 2);
  desk.must(UndoEvent{});
  desk.layer(Do::kHide, 1);
  desk.layer(Do::kLock, 1);
  is_one_step({Do::kShow, {1}, ""}, {1, 2}, 2);
  is_one_step({Do::kUnlock, {1}, ""}, {1, 2}, 1);
  const Document before = desk.session.document();
  desk.layer(Do::kRemove, 1);
  EXPECT_EQ(desk.layers(), (Ids{2}));
  EXPECT_EQ(desk.session.document().stroke_count(), 1U);
  desk.must(UndoEvent{});
  EXPECT_TRUE(desk.session.document() == before);
}

TEST(SessionLayers, ThereIsAlwaysOneOpenToDrawOn) {
  for (const Do what : {Do::kHide, Do::kLock, Do::kRemove}) {
    SCOPED_TRACE(static_cast<int>(what));
    CommandDesk desk;
    desk.layer(Do::kAdd);
    desk.layer(Do::kAdd);
    desk.layer(Do::kUse, 1);
    desk.layer(what, 1);
    EXPECT_EQ(desk.session.layer().value, 3U) << "the highest other one";
    desk.layer(what, 3);
    EXPECT_EQ(desk.session.layer().value, 2U);
    const std::size_t steps = desk.steps();
    desk.layer(what, 2);
    EXPECT_EQ(desk.steps(), steps + 1);
    EXPECT_EQ(desk.session.layer().value, 4U) << "a new one, on top, by the same step";
    EXPECT_EQ(desk.layers().back(), 4U);
    desk.line(0, 0);
    EXPECT_EQ(visible_strokes(desk.session.document()).size(), 1U) << "ink that one can see";
    desk.must(UndoEvent{});
    desk.must(UndoEvent{});
    EXPECT_EQ(desk.session.layer().value, 2U);
    EXPECT_EQ(desk.session.document().layer({4}), nullptr);
  }
}

TEST(SessionLayers, ADocumentWithoutAnOpenLayerGetsOneAtTheStart) {
  Document document;
  ASSERT_TRUE(document.apply(
      {"Lock", {}, {{{1}, LayerState{"Ink"}, LayerState{"Ink", true, true}, 0, 0}}}));
  Document copy = document;
  SessionOptions options;
  options.document = document;
  options.on_edit = [&copy](const Edit& edit) { ASSERT_TRUE(copy.apply(edit)); };
  CommandDesk desk(std::move(options));
  EXPECT_EQ(desk.session.layer().value, 2U);
  EXPECT_EQ(desk.steps(), 0U);
  EXPECT_TRUE(copy == desk.session.document());
}

TEST(SessionLayers, SaysWhatIsWrongAndChangesNothing) {
  std::vector<Event> recorded;
  SessionOptions options;
  options.on_event = [&recorded](const Event& event) { recorded.push_back(event); };
  CommandDesk desk(std::move(options));
  desk.layer(Do::kAdd, 0, "b");
  desk.layer(Do::kHide, 2);
  recorded.clear();
  const std::size_t steps = desk.steps();
  const auto error = [&](Do what, std::uint64_t id) {
    return desk.tell(LayerEvent{what, {id}, "x"}).error().message;
  };
  for (const Do what : {Do::kRemove, Do::kRename, Do::kShow, Do::kHide, Do::kLock, Do::kUnlock,
                        Do::kRaise, Do::kLower, Do::kUse, Do::kMove}) {
    EXPECT_EQ(error(what, 9), "no layer 9");
  }
  EXPECT_EQ(error(Do::kUse, 2), "layer 2 (b) is hidden: nothing can be drawn there");
  desk.layer(Do::kShow, 2);
  desk.layer(Do::kLock, 2);
  EXPECT_EQ(error(Do::kUse, 2), "layer 2 (b) is locked: nothing can be drawn there");
  EXPECT_EQ(desk.session.layer().value, 1U);
  EXPECT_EQ(desk.steps(), steps + 2);
  EXPECT_EQ(recorded.size(), 2U) << "what failed is not recorded";
}

TEST(SessionCommands, DoNothingWhileAGestureIsInWork) {
  CommandDesk desk;
  desk.line(0, 0);
  desk.pen(0, 10, -1);
  desk.must(SelectStrokes{What::kAll});
  desk.must(DuplicateEvent{});
  desk.layer(Do::kAdd);
  desk.layer(Do::kUse, 9);
  EXPECT_EQ(desk.steps(), 1U);
  EXPECT_TRUE(desk.session.selection().empty());
  desk.pen(10, 10, -1);
  desk.pen(10, 10, 5);
  EXPECT_EQ(desk.steps(), 2U) << "and the gesture went on";
}

TEST(SessionCommands, KeepALineThatWaitsForItsLift) {
  CommandDesk desk;
  desk.pen(0, 10, -1);
  desk.pen(10, 10, -1);
  desk.pen(10, 10, 0.1);  // the tool still expects a bounce
  desk.must(SelectStrokes{What::kAll});
  EXPECT_EQ(desk.selected(), (Ids{1}));
  desk.pen(20, 10, -1);
  desk.pen(30, 10, -1);
  desk.pen(30, 10, 0.1);
  desk.layer(Do::kHide, 1);
  EXPECT_EQ(desk.session.document().layer_of({2}).value, 1U);
}

Edit shown(const CommandDesk& desk) {
  EditBuilder builder(desk.session.document());
  builder.add({1},
              std::make_shared<const Stroke>(felt::testing::straight_stroke({0, 0}, {9, 0}, 1, 1)));
  return std::move(builder).build("Show");
}

TEST(SessionPreview, StaysWhereTheToolSaysSoAndElseGoes) {
  CommandDesk desk;
  auto& answers = desk.tool->answers;
  const Edit edit = shown(desk);
  answers = {{.preview = edit}, {.same_preview = true}, {.same_preview = true}, {}};
  desk.pen(0, 0, -1);
  ASSERT_TRUE(desk.session.preview());
  const Stroke* stroke = desk.session.preview()->changes[0].after.get();
  desk.pen(0, 0, -1);
  ASSERT_TRUE(desk.session.preview());
  EXPECT_EQ(desk.session.preview()->changes[0].after.get(), stroke) << "not even copied";
  desk.pen(0, 0, 0.1);
  EXPECT_TRUE(desk.session.preview());
  EXPECT_TRUE(desk.session.gesture_in_work()) << "the pen may only have bounced";
  desk.pen(0, 0, -1);
  EXPECT_FALSE(desk.session.preview());
  answers = {{.preview = edit}, {.commit = edit, .same_preview = true}};
  desk.pen(0, 0, -1);
  desk.pen(0, 0, 5);
  EXPECT_FALSE(desk.session.preview()) << "it was one of the document before";
  EXPECT_EQ(desk.steps(), 1U);
}

TEST(SessionPreview, OfAHoveringPenIsNoGesture) {
  CommandDesk desk;
  desk.line(0, 0);
  desk.tool->answers = {{.preview = shown(desk)}, {.same_preview = true}};
  desk.pen(0, 0, 5);
  desk.pen(0, 0, 5);
  EXPECT_TRUE(desk.session.preview());
  EXPECT_FALSE(desk.session.gesture_in_work());
  desk.must(UndoEvent{});
  EXPECT_EQ(desk.session.document().stroke_count(), 0U) << "undo undoes";
  EXPECT_FALSE(desk.session.preview());
  desk.must(RedoEvent{});
  EXPECT_EQ(desk.session.document().stroke_count(), 1U);
}

/// Expects that all selected strokes exist, may be edited, and have a mark for each point.
void expect_consistent(const Session& session) {
  const Document& document = session.document();
  Selection held = session.selection();
  held.hold_to(document);
  ASSERT_EQ(held, session.selection());
  const Layer* in_use = document.layer(session.layer());
  ASSERT_TRUE(in_use && in_use->visible && !in_use->locked);
}

Event random_event(const Session& session, std::mt19937& random) {
  const std::span<const Layer> layers = session.document().layers();
  const LayerId any = random() % 20 ? layers[random() % layers.size()].id : LayerId{99};
  switch (random() % 9) {
    case 0:
      return {0, SelectStrokes{static_cast<What>(random() % 3)}};
    case 1:
      return {0, DeleteEvent{}};
    case 2:
      return {0, DuplicateEvent{}};
    case 3:
      return {0, UndoEvent{}};
    case 4:
      return {0, RedoEvent{}};
    case 5:
      return {0, SelectTool{random() % 3 ? "pencil" : "eraser"}};
    default:
      return {0, LayerEvent{static_cast<Do>(random() % 11), any, random() % 2 ? "n" : "",
                            random() % 4}};
  }
}

/// Applies a random event to the session.
void random_step(CommandDesk& desk, std::mt19937& random) {
  if (random() % 2) {
    const double x = static_cast<double>(random() % 50), y = static_cast<double>(random() % 50);
    if (random() % 4) return desk.line(x, y);
    return desk.pen(x, y, random() % 2 ? -1 : (random() % 2 ? 0.1 : 5));
  }
  Event event = random_event(desk.session, random);
  // More copies would only cost time.
  if (std::holds_alternative<DuplicateEvent>(event.what) &&
      desk.session.document().stroke_count() > 60) {
    event.what = DeleteEvent{};
  }
  event.time_ns = desk.now_ns += 1'000'000;
  (void)desk.session.apply(event);  // after an error nothing has changed
}

TEST(SessionCommands, R52_RandomSessionsUndoToTheStartAndRedoToTheEnd) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<Event> recorded;
    SessionOptions options;
    options.on_event = [&recorded](const Event& event) { recorded.push_back(event); };
    CommandDesk desk(std::move(options));
    for (int i = 0; i < 300; ++i) {
      const Document before = desk.session.document();
      const std::size_t steps = desk.steps();
      random_step(desk, random);
      expect_consistent(desk.session);
      if (desk.steps() == steps + 1 && !desk.session.gesture_in_work()) {
        const Document after = desk.session.document();
        desk.must(UndoEvent{});
        ASSERT_TRUE(desk.session.document() == before);
        desk.must(RedoEvent{});
        ASSERT_TRUE(desk.session.document() == after);
        expect_consistent(desk.session);
      }
      if (HasFatalFailure()) return;
    }
    ASSERT_TRUE(desk.session.finish());
    while (desk.session.history().can_redo()) desk.must(RedoEvent{});
    const std::size_t all = desk.steps();
    const Document end = desk.session.document();
    EXPECT_GT(all, 20U);
    std::vector<Document> states;
    while (desk.session.history().can_undo()) {
      states.push_back(desk.session.document());
      desk.must(UndoEvent{});
      expect_consistent(desk.session);
    }
    EXPECT_EQ(states.size(), all);
    EXPECT_TRUE(desk.session.document() == Document());
    for (; !states.empty(); states.pop_back()) {
      desk.must(RedoEvent{});
      ASSERT_TRUE(desk.session.document() == states.back());
    }
    EXPECT_TRUE(desk.session.document() == end);

    // If another session gets the recorded events, it reaches the same state.
    CommandDesk again;
    for (const Event& event : recorded) ASSERT_TRUE(again.session.apply(event));
    if (HasFatalFailure()) return;
    EXPECT_TRUE(again.session.document() == end);
    EXPECT_EQ(again.session.selection(), desk.session.selection());
    EXPECT_EQ(again.session.layer(), desk.session.layer());
  }
}

TEST(SessionCommands, WhatIsImportedIsSelectedInPlaceOfWhatWas) {
  CommandDesk desk;
  desk.line(0, 0);
  desk.must(SelectStrokes{What::kAll});
  const std::vector strokes{
      std::make_shared<const Stroke>(testing::straight_stroke({0, 50}, {9, 50}, 1, 2)),
      std::make_shared<const Stroke>(testing::straight_stroke({0, 60}, {9, 60}, 1, 2))};
  ASSERT_TRUE(desk.session.import(desk.now_ns, {"clipboard", true}, strokes));
  EXPECT_EQ(desk.selected(), (std::vector<std::uint64_t>{2, 3}));
  desk.must(DeleteEvent{});
  EXPECT_EQ(desk.session.document().stroke_count(), 1U) << "the original stays";
  EXPECT_TRUE(desk.session.document().find({1}));
}

// Scripts of Feltline 0.1.0 do not say "select". If they delete after an import, they mean the
// earlier selection.
TEST(SessionCommands, AnImportThatDoesNotSelectLeavesTheSelection) {
  CommandDesk desk;
  desk.line(0, 0);
  desk.must(SelectStrokes{What::kAll});
  const std::vector strokes{
      std::make_shared<const Stroke>(testing::straight_stroke({0, 50}, {9, 50}, 1, 2))};
  ASSERT_TRUE(desk.session.import(desk.now_ns, {"a.svg"}, strokes));
  EXPECT_EQ(desk.selected(), (std::vector<std::uint64_t>{1}));
  desk.must(DeleteEvent{});
  EXPECT_EQ(desk.session.document().stroke_count(), 1U) << "the imported line stays";
  EXPECT_TRUE(desk.session.document().find({2}));
}

TEST(SessionCommands, TheSelectionIsSeenWithToolsThatDoNotShowIt) {
  CommandDesk desk;
  desk.line(0, 0);
  desk.line(0, 20);
  const auto marked = [&desk] {
    Overlay overlay;
    desk.session.draw(overlay);
    return overlay.spans.size();
  };
  EXPECT_EQ(marked(), 0U);
  desk.must(SelectStrokes{What::kAll});
  const std::size_t all = marked();
  EXPECT_GE(all, 2U);
  desk.must(UndoEvent{});
  EXPECT_LT(marked(), all) << "it follows every edit";
  EXPECT_GT(marked(), 0U);
  desk.must(SelectStrokes{What::kNone});
  EXPECT_EQ(marked(), 0U);
}

TEST(SessionCommands, RestyleIsOneStepOfAllThatIsSelected) {
  CommandDesk desk;
  desk.line(0, 0);
  desk.line(0, 20);
  const Document before = desk.session.document();
  desk.must(RestyleEvent{.color = "#b02020"});
  EXPECT_EQ(desk.session.document(), before) << "nothing is selected";
  desk.must(SelectStrokes{What::kAll});
  const std::size_t steps = desk.session.history().undo_count();
  desk.must(RestyleEvent{.color = "#b02020", .medium = "chalk"});
  EXPECT_EQ(desk.session.history().undo_count(), steps + 1);
  EXPECT_EQ(desk.selected(), (std::vector<std::uint64_t>{1, 2}));
  for (const std::uint64_t id : {1U, 2U}) {
    const Stroke& stroke = *desk.session.document().find({id});
    EXPECT_EQ(stroke.color(), (Rgba{0xb0, 0x20, 0x20, 255}));
    EXPECT_EQ(stroke.medium(), "chalk");
    EXPECT_EQ(stroke.data().points, before.find({id})->data().points);
    EXPECT_EQ(stroke.data().widths, before.find({id})->data().widths);
  }
  desk.must(RestyleEvent{.color = "#b02020"});
  EXPECT_EQ(desk.session.history().undo_count(), steps + 1) << "it is so already";
  desk.must(UndoEvent{});
  EXPECT_EQ(desk.session.document(), before);
  EXPECT_FALSE(desk.tell(RestyleEvent{.color = "red"}));
  EXPECT_FALSE(desk.tell(RestyleEvent{.medium = "eraser"}));
}

}  // namespace
}  // namespace felt::session_commands_test
