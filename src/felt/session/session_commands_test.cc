// Tests of the commands of a session.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <deque>
#include <random>
#include <set>

#include "felt/document/edit_builder.h"
#include "felt/document/testing/random_fills.h"
#include "felt/document/visible_strokes.h"
#include "felt/session/layer_edit.h"
#include "felt/session/selection_edit.h"
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

struct CommandFixture {
  explicit CommandFixture(SessionOptions options = {})
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
  Result<void> apply(Command what) {
    return session.apply({now_ns += 1'000'000, std::move(what)});
  }
  template <class Command>
  void must(Command what) {
    const Result<void> done = apply(std::move(what));
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

Selection::Marks first_point_of(const CommandFixture& fixture, std::uint64_t id) {
  Selection::Marks marks(fixture.session.document().find({id})->data().points.size(), 0);
  marks.front() = 1;
  return marks;
}

TEST(SessionSelection, AllNoneAndInvertTakeWhatMayBeEdited) {
  CommandFixture fixture;
  fixture.line(0, 0);
  fixture.line(0, 10);
  fixture.layer(Do::kAdd);
  fixture.line(0, 20);
  fixture.must(SelectStrokes{What::kAll});
  EXPECT_EQ(fixture.selected(), (Ids{1, 2, 3}));
  EXPECT_EQ(fixture.steps(), 4U) << "a selection is no step";
  fixture.layer(Do::kLock, 1);
  EXPECT_EQ(fixture.selected(), (Ids{3})) << "what is locked is no longer selected";
  fixture.must(SelectStrokes{What::kInvert});
  EXPECT_EQ(fixture.selected(), Ids{});
  fixture.layer(Do::kUnlock, 1);
  fixture.must(SelectStrokes{What::kInvert});
  EXPECT_EQ(fixture.selected(), (Ids{1, 2, 3}));
  fixture.layer(Do::kHide, 2);
  EXPECT_EQ(fixture.selected(), (Ids{1, 2}));
  fixture.must(SelectStrokes{What::kNone});
  EXPECT_EQ(fixture.selected(), Ids{});
}

TEST(SessionSelection, IsWhatTheToolSaysAndTheToolSeesIt) {
  CommandFixture fixture;
  fixture.line(0, 0);
  fixture.line(0, 10);
  Selection chosen;
  chosen.set({1}, first_point_of(fixture, 1));
  chosen.set_whole({7}, 4);   // the stroke does not exist
  chosen.set_whole({2}, 10);  // wrong number of points
  fixture.tool->answers.push_back({.selection = chosen});
  fixture.pen(0, 0, 5);
  EXPECT_EQ(fixture.selected(), (Ids{1}));
  fixture.pen(0, 0, 5);
  EXPECT_EQ(fixture.tool->selected, 1U);
  fixture.must(SelectStrokes{What::kInvert});
  EXPECT_EQ(fixture.selected(), (Ids{1, 2})) << "selected in part: the inverse has all of it";
  EXPECT_TRUE(fixture.session.selection().is_whole({1}));
}

TEST(SessionSelection, DeleteRemovesWhatIsWhollySelected) {
  CommandFixture fixture;
  for (int i = 0; i < 4; ++i) fixture.line(0, 10 * i);
  fixture.must(DeleteEvent{});
  EXPECT_EQ(fixture.steps(), 4U) << "nothing is selected, nothing happens";
  Selection chosen;
  chosen.set({1}, first_point_of(fixture, 1));
  chosen.set_whole({2}, fixture.session.document().find({2})->data().points.size());
  chosen.set_whole({4}, fixture.session.document().find({4})->data().points.size());
  fixture.tool->answers.push_back({.selection = chosen});
  fixture.pen(0, 0, 5);
  const Document before = fixture.session.document();
  fixture.must(DeleteEvent{});
  EXPECT_EQ(fixture.session.document().stroke_count(), 2U);
  EXPECT_EQ(visible_strokes(fixture.session.document())[1], visible_strokes(before)[2]);
  EXPECT_EQ(fixture.selected(), (Ids{1})) << "one that is selected in part stays, and so selected";
  EXPECT_EQ(fixture.steps(), 5U);
  fixture.must(DeleteEvent{});
  EXPECT_EQ(fixture.steps(), 5U);
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.session.document(), before);
}

/// Returns strokes with 1,000 segments each.
Document long_strokes(int count) {
  StrokeData data;
  data.points.push_back({0, 0});
  for (int i = 0; i < 1000; ++i) {
    const Cubic c = straight(data.points.back(), {0.1 * (i + 1), 0.0});
    data.points.insert(data.points.end(), c.p.begin() + 1, c.p.end());
    if (i > 0) data.joints.push_back(JointKind::kCorner);
  }
  data.widths = {{0.0, 0.5}, {1000.0, 0.5}};
  const auto stroke = std::make_shared<const Stroke>(Stroke::create(data).value());
  Document document;
  EditBuilder builder(document);
  for (int i = 0; i < count; ++i) builder.add({1}, stroke);
  EXPECT_TRUE(document.apply(std::move(builder).build("Add")));
  return document;
}

/// Each copy of everything doubles a drawing. Without a session, which would index all segments.
TEST(SessionSelection, CopiesStopBeforeTheyFillTheMemory) {
  const LayerEvent duplicate{Do::kDuplicate, {1}, {}};
  Document document = long_strokes(1000);
  int doubled = 0;
  for (; doubled < 10; ++doubled) {
    const Result<Edit> copy = layer_edit(document, duplicate, {1});
    if (!copy) {
      EXPECT_THAT(copy.error().message, ::testing::HasSubstr("stop at 1000000 and 20000000"));
      break;
    }
    ASSERT_TRUE(document.apply(*copy));
    const LayerEvent merge{Do::kMerge, document.layers().back().id, {}};
    ASSERT_TRUE(document.apply(layer_edit(document, merge, {1}).value()));
  }
  EXPECT_EQ(doubled, 2) << "to 12,004,000 control points";
  const Result<Edit> refused = duplicate_edit(document, selected(document, {}, What::kAll));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, ::testing::HasSubstr("would have 8000 strokes"));
}

/// The fills that go along with the strokes count, too.
TEST(SessionSelection, CopiesOfFillsStopToo) {
  Fill large{{FillLoop{std::vector<Point>(300'001), {{StrokeId{1}, 0.0, 1.0}}}}};
  const auto fill = std::make_shared<const Fill>(std::move(large));
  for (const int count : {33, 34}) {
    CommandFixture fixture;
    fixture.line(0, 0);
    Document document = fixture.session.document();
    EditBuilder builder(document);
    for (int i = 0; i < count; ++i) builder.add_fill({1}, fill);
    ASSERT_TRUE(document.apply(std::move(builder).build("Fill")));
    const Result<Edit> copy = duplicate_edit(document, selected(document, {}, What::kAll));
    EXPECT_EQ(copy.has_value(), count == 33) << "up to 20,000,000 control points";
    if (!copy) {
      EXPECT_THAT(copy.error().message, ::testing::HasSubstr("would have 70 strokes and fills"));
    } else {
      EXPECT_EQ(copy->fills.size(), 33U);
    }
  }
}

TEST(SessionSelection, DuplicateAddsShiftedCopiesWhichAreSelectedThen) {
  CommandFixture fixture;
  fixture.line(0, 0);
  fixture.layer(Do::kAdd);
  fixture.line(0, 10);
  fixture.must(SelectStrokes{What::kAll});
  fixture.must(DuplicateEvent{});
  EXPECT_EQ(fixture.selected(), (Ids{3, 4}));
  EXPECT_EQ(fixture.steps(), 4U);
  const Document& document = fixture.session.document();
  EXPECT_EQ(document.layer_of({3}).value, 1U);
  EXPECT_EQ(document.layer_of({4}).value, 2U);
  StrokeData moved = document.find({1})->data();
  for (Point& p : moved.points) p = p + Vec{5, 5};
  EXPECT_EQ(document.find({3})->data(), moved);
  fixture.must(UndoEvent{});
  EXPECT_EQ(document.stroke_count(), 2U);
  EXPECT_EQ(fixture.selected(), Ids{}) << "what is gone is not selected";
  fixture.must(DuplicateEvent{});
  EXPECT_EQ(document.stroke_count(), 2U);
}

TEST(SessionSelection, MovesInQuickSuccessionAreOneStep) {
  CommandFixture fixture;
  fixture.line(0, 0);
  fixture.line(0, 20);
  fixture.must(SelectStrokes{What::kAll});
  const Document before = fixture.session.document();
  const std::uint64_t drawn = fixture.session.history().position();
  for (int i = 0; i < 3; ++i) fixture.must(MoveEvent{{1, 0}});
  EXPECT_EQ(fixture.steps(), 3U);
  EXPECT_EQ(fixture.session.document().find({1})->position(0).x, 3.0);
  EXPECT_EQ(fixture.selected(), (Ids{1, 2})) << "the selection stays";
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.session.document(), before);
  EXPECT_EQ(fixture.session.history().position(), drawn);
  fixture.must(RedoEvent{});
  EXPECT_EQ(fixture.session.document().find({1})->position(0).x, 3.0);
  fixture.now_ns += 2 * MoveEvent::kTogetherNs;
  fixture.must(MoveEvent{{0, 1}});
  EXPECT_EQ(fixture.steps(), 4U) << "too late";
  fixture.must(UndoEvent{});
  fixture.must(MoveEvent{{0, 2}});
  EXPECT_EQ(fixture.steps(), 4U);
  EXPECT_FALSE(fixture.session.history().can_redo());
  EXPECT_FALSE(fixture.apply(MoveEvent{{1e5, 0}}));
  EXPECT_FALSE(fixture.apply(MoveEvent{{0, std::nan("")}}));
}

/// A recording contains the gesture, so an event does not fail, but it counts.
TEST(SessionSelection, AGestureThatExceedsALimitIsCounted) {
  CommandFixture fixture;
  const Error why{ErrorCode::kLimitExceeded, "copies stop here"};
  fixture.tool->answers.push_back({.refusal = why});
  fixture.pen(0, 0, -1);
  EXPECT_EQ(fixture.session.refusals().gestures, 1U);
  fixture.pen(1, 0, -1);
  fixture.pen(1, 0, 5);
  fixture.tool->answers.push_back({.refusal = Error{ErrorCode::kLimitExceeded, "and here"}});
  const Result<void> done = fixture.session.sample({1'000'000'000, {0, 0, -1}, {}, {}, 0, {}});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().message, "and here");
  EXPECT_EQ(fixture.session.refusals().gestures, 2U);
  EXPECT_EQ(fixture.session.refusals().first, why.message);
}

TEST(SessionSelection, OrderMovesToTheTopOrTheBottomOfTheLayer) {
  CommandFixture fixture;
  for (int i = 0; i < 3; ++i) fixture.line(0, 20.0 * i);
  fixture.must(SelectStrokes{What::kNone});
  fixture.must(OrderEvent{});
  EXPECT_EQ(fixture.steps(), 3U) << "nothing is selected";
  const StrokePtr copied = fixture.session.document().find({1});
  ASSERT_TRUE(fixture.session.import(fixture.now_ns, {"clipboard", true}, std::array{copied}));
  const auto order = [&] { return fixture.session.document().layers().front().strokes; };
  fixture.must(OrderEvent{OrderEvent::To::kBack});
  EXPECT_EQ(order(), (std::vector<StrokeId>{{4}, {1}, {2}, {3}}));
  EXPECT_EQ(fixture.session.history().undo_label(), "Send to back");
  const std::size_t steps = fixture.steps();
  fixture.must(OrderEvent{OrderEvent::To::kBack});
  EXPECT_EQ(fixture.steps(), steps) << "it is there already";
  fixture.must(OrderEvent{OrderEvent::To::kFront});
  EXPECT_EQ(order(), (std::vector<StrokeId>{{1}, {2}, {3}, {4}}));
  fixture.must(UndoEvent{});
  EXPECT_EQ(order(), (std::vector<StrokeId>{{4}, {1}, {2}, {3}}));
}

TEST(SessionLayers, NewInkGoesToTheLayerInUse) {
  CommandFixture fixture;
  fixture.layer(Do::kAdd, 0, "Ideas");
  EXPECT_EQ(fixture.session.layer().value, 2U);
  fixture.layer(Do::kUse, 1);
  EXPECT_EQ(fixture.steps(), 1U) << "use is no step";
  fixture.line(0, 0);
  EXPECT_EQ(fixture.tool->layer.value, 1U);
  EXPECT_EQ(fixture.session.document().layer_of({1}).value, 1U);
  fixture.layer(Do::kAdd);
  EXPECT_EQ(fixture.layers(), (Ids{1, 3, 2})) << "above the one that was in use";
  EXPECT_EQ(fixture.session.document().layer({2})->name, "Ideas");
  EXPECT_EQ(fixture.session.document().layer({3})->name, "Layer 3");
  CommandFixture other;
  ASSERT_TRUE(
      fixture.session.import(fixture.now_ns, {"a"}, visible_strokes(fixture.session.document())));
  EXPECT_EQ(fixture.session.document().layer_of({2}).value, 3U);
}

TEST(SessionLayers, EachCommandIsOneStepAndUndone) {
  CommandFixture fixture;
  fixture.line(0, 0);
  fixture.layer(Do::kAdd);
  fixture.line(0, 10);
  const auto is_one_step = [&](const LayerEvent& event, Ids layers, std::size_t shown) {
    SCOPED_TRACE(static_cast<int>(event.what));
    const Document before = fixture.session.document();
    const std::size_t steps = fixture.steps();
    fixture.must(event);
    EXPECT_EQ(fixture.steps(), steps + 1);
    EXPECT_EQ(fixture.layers(), layers);
    EXPECT_EQ(visible_strokes(fixture.session.document()).size(), shown);
    fixture.must(event);
    EXPECT_EQ(fixture.steps(), steps + 1) << "again: nothing changes";
    fixture.must(UndoEvent{});
    EXPECT_TRUE(fixture.session.document() == before);
  };
  is_one_step({Do::kRename, {1}, "Base"}, {1, 2}, 2);
  is_one_step({Do::kHide, {1}, ""}, {1, 2}, 1);
  is_one_step({Do::kLock, {2}, ""}, {1, 2}, 2);
  is_one_step({Do::kRaise, {1}, ""}, {2, 1}, 2);
  is_one_step({Do::kLower, {2}, ""}, {2, 1}, 2);
  is_one_step({Do::kMove, {1}, "", 1}, {2, 1}, 2);
  is_one_step({Do::kMove, {2}, "", 0}, {2, 1}, 2);
  fixture.layer(Do::kAdd);
  is_one_step({Do::kMove, {1}, "", 2}, {3, 2, 1}, 2);
  is_one_step({Do::kMove, {1}, "", 99}, {3, 2, 1}, 2);
  is_one_step({Do::kMove, {3}, "", 0}, {3, 1, 2}, 2);
  fixture.must(UndoEvent{});
  fixture.layer(Do::kHide, 1);
  fixture.layer(Do::kLock, 1);
  is_one_step({Do::kShow, {1}, ""}, {1, 2}, 2);
  is_one_step({Do::kUnlock, {1}, ""}, {1, 2}, 1);
  const Document before = fixture.session.document();
  fixture.layer(Do::kRemove, 1);
  EXPECT_EQ(fixture.layers(), (Ids{2}));
  EXPECT_EQ(fixture.session.document().stroke_count(), 1U);
  fixture.must(UndoEvent{});
  EXPECT_TRUE(fixture.session.document() == before);
}

TEST(SessionLayers, ARemovedLayerTakesItsFillsAlong) {
  Document document;
  testing::RandomStroke random(1);
  EditBuilder builder(document);
  builder.add({1}, std::make_shared<const Stroke>(testing::random_stroke(1)));
  builder.add_fill({1}, std::make_shared<const Fill>(testing::random_fill(random)));
  ASSERT_TRUE(document.apply(std::move(builder).build("Fill")));
  const Document before = document;
  const Edit removal = layer_edit(document, {.what = Do::kRemove, .layer = {1}}, {1}).value();
  ASSERT_TRUE(document.apply(removal));
  EXPECT_EQ(document.fill_count(), 0U);
  ASSERT_TRUE(document.apply(removal.inverse()));
  EXPECT_EQ(document, before);
}

/// Returns the ids of the layers in which strokes are.
std::set<LayerId> layers_with_ink(const Document& document) {
  std::set<LayerId> layers;
  for (const Layer& layer : document.layers()) {
    if (!layer.strokes.empty()) layers.insert(layer.id);
  }
  return layers;
}

TEST(SessionLayers, InkGetsALayerIfNoneIsOpen) {
  for (const Do what : {Do::kHide, Do::kLock}) {
    SCOPED_TRACE(static_cast<int>(what));
    CommandFixture fixture;
    fixture.layer(Do::kAdd);
    fixture.layer(Do::kAdd);
    fixture.layer(Do::kUse, 1);
    fixture.layer(what, 1);
    EXPECT_EQ(fixture.session.layer().value, 3U) << "the highest other one";
    fixture.layer(what, 3);
    EXPECT_EQ(fixture.session.layer().value, 2U);
    fixture.layer(what, 2);
    EXPECT_EQ(fixture.layers(), (std::vector<std::uint64_t>{1, 2, 3})) << "none is added yet";
    EXPECT_EQ(fixture.session.layer().value, 2U) << "it stays the current one";
    const Document before = fixture.session.document();
    const std::size_t steps = fixture.steps();
    fixture.line(0, 0);
    EXPECT_EQ(fixture.tool->layer.value, 4U);
    EXPECT_EQ(fixture.session.layer().value, 4U);
    EXPECT_EQ(fixture.session.layers_added_for_ink(), 1U);
    EXPECT_EQ(fixture.layers().back(), 4U);
    EXPECT_EQ(visible_strokes(fixture.session.document()).size(), 1U) << "ink that one can see";
    EXPECT_EQ(fixture.steps(), steps + 1) << "the layer and its ink are one step";
    const Document after = fixture.session.document();
    fixture.must(UndoEvent{});
    EXPECT_EQ(fixture.session.document(), before);
    fixture.must(RedoEvent{});
    EXPECT_EQ(fixture.session.document(), after);
    fixture.line(0, 10);
    EXPECT_EQ(fixture.steps(), steps + 2) << "the next line is a step of its own";
    EXPECT_EQ(layers_with_ink(fixture.session.document()), std::set{LayerId{4}});
  }
}

TEST(SessionLayers, ALayerThatIsLockedAndUnlockedStaysTheOnlyOne) {
  for (const auto& [closes, opens] :
       {std::pair{Do::kLock, Do::kUnlock}, std::pair{Do::kHide, Do::kShow}}) {
    CommandFixture fixture;
    for (int i = 0; i < 3; ++i) {
      fixture.layer(closes, 1);
      fixture.layer(opens, 1);
    }
    EXPECT_EQ(fixture.layers(), std::vector<std::uint64_t>{1});
    fixture.line(0, 0);
    EXPECT_EQ(layers_with_ink(fixture.session.document()), std::set{LayerId{1}});
    EXPECT_EQ(fixture.session.layers_added_for_ink(), 0U);
  }
}

TEST(SessionLayers, AToolThatAddsNoInkAddsNoLayer) {
  CommandFixture fixture;
  fixture.layer(Do::kLock, 1);
  fixture.must(SelectTool{"eraser"});
  fixture.line(0, 0);
  EXPECT_EQ(fixture.layers(), std::vector<std::uint64_t>{1});
}

TEST(SessionLayers, AnImportGetsALayerIfNoneIsOpen) {
  CommandFixture fixture;
  fixture.layer(Do::kLock, 1);
  const Document before = fixture.session.document();
  const std::vector strokes{std::make_shared<const Stroke>(testing::random_stroke(1))};
  ASSERT_TRUE(fixture.session.import(1, ImportEvent{.path = "a.svg", .select = true}, strokes));
  EXPECT_EQ(layers_with_ink(fixture.session.document()), std::set{LayerId{2}});
  EXPECT_FALSE(fixture.session.selection().empty());
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.session.document(), before);
}

// The ink of a tool that has no result is lost, but its layer can be undone.
TEST(SessionLayers, ACancelledLineLeavesItsLayerAsAStep) {
  CommandFixture fixture;
  fixture.layer(Do::kHide, 1);
  const std::size_t steps = fixture.steps();
  fixture.pen(0, 0, 5);
  fixture.pen(0, 0, -1);
  fixture.must(CancelEvent{});
  fixture.pen(0, 0, 5);
  EXPECT_EQ(fixture.layers(), (std::vector<std::uint64_t>{1, 2}));
  EXPECT_EQ(fixture.steps(), steps + 1);
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.layers(), std::vector<std::uint64_t>{1});
  EXPECT_EQ(fixture.session.layer().value, 1U);
}

/// An edit that is not the line's ink is a step of its own.
TEST(SessionLayers, OnlyTheInkOfItsLineJoinsTheStepOfALayer) {
  for (const bool cancels : {true, false}) {
    SCOPED_TRACE(cancels);
    CommandFixture fixture;
    fixture.layer(Do::kLock, 1);
    const std::size_t steps = fixture.steps();
    fixture.pen(0, 0, 5);
    fixture.pen(0, 0, -1);
    if (cancels) fixture.must(CancelEvent{});
    for (int i = 0; i < 40; ++i) fixture.pen(0, 0, 5);  // a dot draws nothing with this tool
    EXPECT_EQ(fixture.steps(), steps + 1);
    fixture.must(GuidesEvent{GuidesEvent::Do::kAdd});
    EXPECT_EQ(fixture.steps(), steps + 2);
    fixture.must(UndoEvent{});
    EXPECT_TRUE(fixture.session.document().guides().empty());
    EXPECT_EQ(fixture.layers(), (std::vector<std::uint64_t>{1, 2})) << "the layer stays";
    fixture.line(0, 0);
    EXPECT_EQ(fixture.steps(), steps + 2) << "the next line is a step, too";
    fixture.must(UndoEvent{});
    EXPECT_EQ(fixture.layers(), (std::vector<std::uint64_t>{1, 2}));
  }
}

TEST(SessionLayers, AnImportOfNothingAddsNoLayer) {
  CommandFixture fixture;
  fixture.layer(Do::kLock, 1);
  const Document before = fixture.session.document();
  const std::size_t steps = fixture.steps();
  ASSERT_TRUE(fixture.session.import(1, ImportEvent{.path = "a.svg", .select = true}, {}));
  EXPECT_EQ(fixture.session.document(), before);
  EXPECT_EQ(fixture.steps(), steps);
}

/// A file does not say which of several closed layers is the current one, so a new layer's position
/// does not depend on it.
TEST(SessionLayers, ANewLayerComesOnTopIfTheCurrentOneIsClosed) {
  for (const Do what : {Do::kHide, Do::kLock}) {
    CommandFixture fixture;
    fixture.layer(Do::kAdd);
    fixture.layer(Do::kAdd);
    for (const std::uint64_t id : {3U, 2U, 1U}) fixture.layer(what, id);
    ASSERT_EQ(fixture.session.layer().value, 1U);
    SessionOptions options;
    options.document = fixture.session.document();
    CommandFixture reopened(std::move(options));
    ASSERT_EQ(reopened.session.layer().value, 3U);
    for (CommandFixture* f : {&fixture, &reopened}) {
      f->layer(Do::kAdd);
      EXPECT_EQ(f->layers(), (std::vector<std::uint64_t>{1, 2, 3, 4}));
    }
  }
}

TEST(SessionLayers, TheLastLayerIsReplacedWhenItIsRemoved) {
  CommandFixture fixture;
  const std::size_t steps = fixture.steps();
  fixture.layer(Do::kRemove, 1);
  EXPECT_EQ(fixture.steps(), steps + 1);
  EXPECT_EQ(fixture.layers(), std::vector<std::uint64_t>{2});
  fixture.layer(Do::kAdd);
  fixture.layer(Do::kLock, 2);
  fixture.layer(Do::kRemove, 3);
  EXPECT_EQ(fixture.layers(), std::vector<std::uint64_t>{2}) << "a locked layer remains";
  EXPECT_EQ(fixture.session.layer().value, 2U);
}

TEST(SessionLayers, ANewLayerIsNotPutIntoALockedGroup) {
  for (const Do what : {Do::kHide, Do::kLock}) {
    CommandFixture fixture;
    fixture.layer(Do::kAdd);
    LayerEvent group{Do::kGroup, {}};
    group.layers = {{1}};
    fixture.must(group);
    fixture.layer(what, 2);
    LayerEvent close{what, {}};
    close.group = GroupId{1};
    fixture.must(close);
    ASSERT_EQ(fixture.session.layer().value, 1U);
    fixture.layer(Do::kAdd);
    EXPECT_EQ(fixture.layers(), (std::vector<std::uint64_t>{1, 2, 3})) << "on top";
    EXPECT_TRUE(is_open(*fixture.session.document().layer({3})));
    EXPECT_EQ(fixture.session.layer().value, 3U);
  }
}

// Recordings of earlier versions may use the layer that was added.
TEST(SessionLayers, AnOlderRecordingGetsItsLayerAtOnce) {
  for (const Do what : {Do::kHide, Do::kLock, Do::kRemove}) {
    CommandFixture fixture;
    fixture.must(UseDevice{{}, kLateLayerDefaults - 1});
    const std::size_t steps = fixture.steps();
    fixture.layer(what, 1);
    EXPECT_EQ(fixture.steps(), steps + 1);
    EXPECT_EQ(fixture.session.layer().value, 2U) << "a new one, on top, by the same step";
    fixture.layer(Do::kRename, 2, "New");
  }
}

// The sessions of those versions added the layer when they began, which was not a step.
TEST(SessionLayers, AnOlderRecordingOfAClosedDrawingBeginsWithAnOpenLayer) {
  Document document;
  ASSERT_TRUE(document.apply(
      {"Lock", {}, {{{1}, LayerState{"Ink"}, LayerState{"Ink", true, true}, 0, 0}}}));
  Document copy = document;
  for (const int version : {1, kLateLayerDefaults - 1, kLateLayerDefaults}) {
    const bool is_older = version < kLateLayerDefaults;
    copy = document;
    SessionOptions options;
    options.document = document;
    options.on_edit = [&copy](const Edit& edit) { ASSERT_TRUE(copy.apply(edit)); };
    CommandFixture fixture(std::move(options));
    fixture.must(UseDevice{{}, version});
    fixture.must(UseDevice{{}, version});
    EXPECT_EQ(fixture.session.document().layers().size(), is_older ? 2U : 1U);
    EXPECT_EQ(fixture.session.layer().value, is_older ? 2U : 1U);
    EXPECT_EQ(fixture.steps(), 0U);
    EXPECT_TRUE(copy == fixture.session.document());
    if (is_older) fixture.layer(Do::kRename, 2, "New");
  }
  CommandFixture drawn;
  drawn.layer(Do::kLock, 1);
  drawn.must(UseDevice{{}, 1});
  EXPECT_EQ(drawn.layers(), (std::vector<std::uint64_t>{1})) << "only at the beginning";
}

TEST(SessionLayers, ADocumentWithoutAnOpenLayerGetsOneByTheFirstInk) {
  Document document;
  ASSERT_TRUE(document.apply(
      {"Lock", {}, {{{1}, LayerState{"Ink"}, LayerState{"Ink", true, true}, 0, 0}}}));
  Document copy = document;
  SessionOptions options;
  options.document = document;
  options.on_edit = [&copy](const Edit& edit) { ASSERT_TRUE(copy.apply(edit)); };
  CommandFixture fixture(std::move(options));
  EXPECT_EQ(fixture.session.layer().value, 1U);
  EXPECT_EQ(fixture.session.document(), document) << "opening a file changes nothing";
  fixture.line(0, 0);
  EXPECT_EQ(fixture.session.layer().value, 2U);
  EXPECT_EQ(fixture.steps(), 1U);
  EXPECT_TRUE(copy == fixture.session.document());
}

TEST(SessionLayers, SaysWhatIsWrongAndChangesNothing) {
  std::vector<Event> recorded;
  SessionOptions options;
  options.on_event = [&recorded](const Event& event) { recorded.push_back(event); };
  CommandFixture fixture(std::move(options));
  fixture.layer(Do::kAdd, 0, "b");
  fixture.layer(Do::kHide, 2);
  recorded.clear();
  const std::size_t steps = fixture.steps();
  const auto error = [&](Do what, std::uint64_t id) {
    return fixture.apply(LayerEvent{what, {id}, "x"}).error().message;
  };
  for (const Do what : {Do::kRemove, Do::kRename, Do::kShow, Do::kHide, Do::kLock, Do::kUnlock,
                        Do::kRaise, Do::kLower, Do::kUse, Do::kMove}) {
    EXPECT_EQ(error(what, 9), "no layer 9");
  }
  EXPECT_EQ(error(Do::kUse, 2), "layer 2 (b) is hidden: you cannot draw on it");
  fixture.layer(Do::kShow, 2);
  fixture.layer(Do::kLock, 2);
  EXPECT_EQ(error(Do::kUse, 2), "layer 2 (b) is locked: you cannot draw on it");
  EXPECT_EQ(fixture.session.layer().value, 1U);
  EXPECT_EQ(fixture.steps(), steps + 2);
  EXPECT_EQ(recorded.size(), 2U) << "what failed is not recorded";
}

TEST(SessionCommands, DoNothingWhileAGestureIsInWork) {
  CommandFixture fixture;
  fixture.line(0, 0);
  fixture.pen(0, 10, -1);
  fixture.must(SelectStrokes{What::kAll});
  fixture.must(DuplicateEvent{});
  fixture.layer(Do::kAdd);
  fixture.layer(Do::kUse, 9);
  EXPECT_EQ(fixture.steps(), 1U);
  EXPECT_TRUE(fixture.session.selection().empty());
  fixture.pen(10, 10, -1);
  fixture.pen(10, 10, 5);
  EXPECT_EQ(fixture.steps(), 2U) << "and the gesture went on";
}

TEST(SessionCommands, KeepALineThatWaitsForItsLift) {
  CommandFixture fixture;
  fixture.pen(0, 10, -1);
  fixture.pen(10, 10, -1);
  fixture.pen(10, 10, 0.1);  // the tool still expects a bounce
  fixture.must(SelectStrokes{What::kAll});
  EXPECT_EQ(fixture.selected(), (Ids{1}));
  fixture.pen(20, 10, -1);
  fixture.pen(30, 10, -1);
  fixture.pen(30, 10, 0.1);
  fixture.layer(Do::kHide, 1);
  EXPECT_EQ(fixture.session.document().layer_of({2}).value, 1U);
}

Edit shown(const CommandFixture& fixture) {
  EditBuilder builder(fixture.session.document());
  builder.add({1},
              std::make_shared<const Stroke>(felt::testing::straight_stroke({0, 0}, {9, 0}, 1, 1)));
  return std::move(builder).build("Show");
}

TEST(SessionPreview, StaysWhereTheToolSaysSoAndElseGoes) {
  CommandFixture fixture;
  auto& answers = fixture.tool->answers;
  const Edit edit = shown(fixture);
  answers = {{.preview = edit}, {.same_preview = true}, {.same_preview = true}, {}};
  fixture.pen(0, 0, -1);
  ASSERT_TRUE(fixture.session.preview());
  const Stroke* stroke = fixture.session.preview()->changes[0].after.get();
  fixture.pen(0, 0, -1);
  ASSERT_TRUE(fixture.session.preview());
  EXPECT_EQ(fixture.session.preview()->changes[0].after.get(), stroke) << "not even copied";
  fixture.pen(0, 0, 0.1);
  EXPECT_TRUE(fixture.session.preview());
  EXPECT_TRUE(fixture.session.gesture_in_progress()) << "the pen may only have bounced";
  fixture.pen(0, 0, -1);
  EXPECT_FALSE(fixture.session.preview());
  answers = {{.preview = edit}, {.commit = edit, .same_preview = true}};
  fixture.pen(0, 0, -1);
  fixture.pen(0, 0, 5);
  EXPECT_FALSE(fixture.session.preview()) << "it was one of the document before";
  EXPECT_EQ(fixture.steps(), 1U);
}

TEST(SessionPreview, OfAHoveringPenIsNoGesture) {
  CommandFixture fixture;
  fixture.line(0, 0);
  fixture.tool->answers = {{.preview = shown(fixture)}, {.same_preview = true}};
  fixture.pen(0, 0, 5);
  fixture.pen(0, 0, 5);
  EXPECT_TRUE(fixture.session.preview());
  EXPECT_FALSE(fixture.session.gesture_in_progress());
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.session.document().stroke_count(), 0U) << "undo undoes";
  EXPECT_FALSE(fixture.session.preview());
  fixture.must(RedoEvent{});
  EXPECT_EQ(fixture.session.document().stroke_count(), 1U);
}

/// Expects that all selected strokes exist, may be edited, and have a mark for each point.
void expect_consistent(const Session& session) {
  const Document& document = session.document();
  Selection held = session.selection();
  held.hold_to(document);
  ASSERT_EQ(held, session.selection());
  const Layer* in_use = document.layer(session.layer());
  ASSERT_TRUE(in_use && (is_open(*in_use) || !highest_open_layer(document)));
}

Event random_event(const Session& session, std::mt19937& random) {
  const std::span<const Layer> layers = session.document().layers();
  const LayerId any = random() % 20 ? layers[random() % layers.size()].id : LayerId{99};
  switch (random() % 11) {
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
      return {0, MoveEvent{{static_cast<double>(random() % 9), -1.5}}};
    case 6:
      return {0, OrderEvent{random() % 2 ? OrderEvent::To::kFront : OrderEvent::To::kBack}};
    case 7:
      return {0, SelectTool{random() % 3 ? "pencil" : "eraser"}};
    default:
      return {0, LayerEvent{static_cast<Do>(random() % 11), any, random() % 2 ? "n" : "",
                            random() % 4}};
  }
}

/// Applies a random event to the session.
void random_step(CommandFixture& fixture, std::mt19937& random) {
  if (random() % 2) {
    const double x = static_cast<double>(random() % 50), y = static_cast<double>(random() % 50);
    if (random() % 4) return fixture.line(x, y);
    return fixture.pen(x, y, random() % 2 ? -1 : (random() % 2 ? 0.1 : 5));
  }
  Event event = random_event(fixture.session, random);
  // More copies would only cost time.
  if (std::holds_alternative<DuplicateEvent>(event.what) &&
      fixture.session.document().stroke_count() > 60) {
    event.what = DeleteEvent{};
  }
  event.time_ns = fixture.now_ns += 1'000'000;
  (void)fixture.session.apply(event);  // after an error nothing has changed
}

TEST(SessionCommands, R52_RandomSessionsUndoToTheStartAndRedoToTheEnd) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<Event> recorded;
    SessionOptions options;
    options.on_event = [&recorded](const Event& event) { recorded.push_back(event); };
    CommandFixture fixture(std::move(options));
    for (int i = 0; i < 300; ++i) {
      const Document before = fixture.session.document();
      const std::size_t steps = fixture.steps();
      random_step(fixture, random);
      expect_consistent(fixture.session);
      if (fixture.steps() == steps + 1 && !fixture.session.gesture_in_progress()) {
        const Document after = fixture.session.document();
        fixture.must(UndoEvent{});
        ASSERT_TRUE(fixture.session.document() == before);
        fixture.must(RedoEvent{});
        ASSERT_TRUE(fixture.session.document() == after);
        expect_consistent(fixture.session);
      }
      if (HasFatalFailure()) return;
    }
    fixture.pen(0, 0, 5);  // ends a gesture by an event, which is recorded
    ASSERT_TRUE(fixture.session.finish());
    while (fixture.session.history().can_redo()) fixture.must(RedoEvent{});
    const std::size_t all = fixture.steps();
    const Document end = fixture.session.document();
    EXPECT_GT(all, 20U);
    std::vector<Document> states;
    while (fixture.session.history().can_undo()) {
      states.push_back(fixture.session.document());
      fixture.must(UndoEvent{});
      expect_consistent(fixture.session);
    }
    EXPECT_EQ(states.size(), all);
    EXPECT_TRUE(fixture.session.document() == Document());
    for (; !states.empty(); states.pop_back()) {
      fixture.must(RedoEvent{});
      ASSERT_TRUE(fixture.session.document() == states.back());
    }
    EXPECT_TRUE(fixture.session.document() == end);

    // If another session gets the recorded events, it reaches the same state.
    CommandFixture again;
    for (const Event& event : recorded) ASSERT_TRUE(again.session.apply(event));
    if (HasFatalFailure()) return;
    EXPECT_TRUE(again.session.document() == end);
    EXPECT_EQ(again.session.selection(), fixture.session.selection());
    EXPECT_EQ(again.session.layer(), fixture.session.layer());
  }
}

TEST(SessionCommands, WhatIsImportedIsSelectedInPlaceOfWhatWas) {
  CommandFixture fixture;
  fixture.line(0, 0);
  fixture.must(SelectStrokes{What::kAll});
  const std::vector strokes{
      std::make_shared<const Stroke>(testing::straight_stroke({0, 50}, {9, 50}, 1, 2)),
      std::make_shared<const Stroke>(testing::straight_stroke({0, 60}, {9, 60}, 1, 2))};
  ASSERT_TRUE(fixture.session.import(fixture.now_ns, {"clipboard", true}, strokes));
  EXPECT_EQ(fixture.selected(), (std::vector<std::uint64_t>{2, 3}));
  fixture.must(DeleteEvent{});
  EXPECT_EQ(fixture.session.document().stroke_count(), 1U) << "the original stays";
  EXPECT_TRUE(fixture.session.document().find({1}));
}

// Scripts of Feltline 0.1.0 do not say "select". If they delete after an import, they mean the
// earlier selection.
TEST(SessionCommands, AnImportThatDoesNotSelectLeavesTheSelection) {
  CommandFixture fixture;
  fixture.line(0, 0);
  fixture.must(SelectStrokes{What::kAll});
  const std::vector strokes{
      std::make_shared<const Stroke>(testing::straight_stroke({0, 50}, {9, 50}, 1, 2))};
  ASSERT_TRUE(fixture.session.import(fixture.now_ns, {"a.svg"}, strokes));
  EXPECT_EQ(fixture.selected(), (std::vector<std::uint64_t>{1}));
  fixture.must(DeleteEvent{});
  EXPECT_EQ(fixture.session.document().stroke_count(), 1U) << "the imported line stays";
  EXPECT_TRUE(fixture.session.document().find({2}));
}

TEST(SessionCommands, TheSelectionIsSeenWithToolsThatDoNotShowIt) {
  CommandFixture fixture;
  fixture.line(0, 0);
  fixture.line(0, 20);
  const auto marked = [&fixture] {
    Overlay overlay;
    fixture.session.draw(overlay);
    return overlay.spans.size();
  };
  EXPECT_EQ(marked(), 0U);
  fixture.must(SelectStrokes{What::kAll});
  const std::size_t all = marked();
  EXPECT_GE(all, 2U);
  fixture.must(UndoEvent{});
  EXPECT_LT(marked(), all) << "it follows every edit";
  EXPECT_GT(marked(), 0U);
  fixture.must(SelectStrokes{What::kNone});
  EXPECT_EQ(marked(), 0U);
}

TEST(SessionCommands, RestyleIsOneStepOfAllThatIsSelected) {
  CommandFixture fixture;
  fixture.line(0, 0);
  fixture.line(0, 20);
  const Document before = fixture.session.document();
  fixture.must(RestyleEvent{.color = "#b02020"});
  EXPECT_EQ(fixture.session.document(), before) << "nothing is selected";
  fixture.must(SelectStrokes{What::kAll});
  const std::size_t steps = fixture.session.history().undo_count();
  fixture.must(RestyleEvent{.color = "#b02020", .medium = "chalk"});
  EXPECT_EQ(fixture.session.history().undo_count(), steps + 1);
  EXPECT_EQ(fixture.selected(), (std::vector<std::uint64_t>{1, 2}));
  for (const std::uint64_t id : {1U, 2U}) {
    const Stroke& stroke = *fixture.session.document().find({id});
    EXPECT_EQ(stroke.color(), (Rgba{0xb0, 0x20, 0x20, 255}));
    EXPECT_EQ(stroke.medium(), "chalk");
    EXPECT_EQ(stroke.data().points, before.find({id})->data().points);
    EXPECT_EQ(stroke.data().widths, before.find({id})->data().widths);
  }
  fixture.must(RestyleEvent{.color = "#b02020"});
  EXPECT_EQ(fixture.session.history().undo_count(), steps + 1) << "it is so already";
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.session.document(), before);
  EXPECT_FALSE(fixture.apply(RestyleEvent{.color = "red"}));
  EXPECT_FALSE(fixture.apply(RestyleEvent{.medium = "eraser"}));
}

TEST(SessionCommands, RestyleChangesOpacityAndWidth) {
  CommandFixture fixture;
  fixture.line(0, 0);
  fixture.must(SelectStrokes{What::kAll});
  fixture.must(RestyleEvent{.color = "#b02020"});
  const StrokeData before = fixture.session.document().find({1})->data();
  const std::size_t steps = fixture.session.history().undo_count();
  fixture.must(RestyleEvent{.opacity = 0.5, .width_factor = 2.0});
  EXPECT_EQ(fixture.session.history().undo_count(), steps + 1);
  const StrokeData after = fixture.session.document().find({1})->data();
  EXPECT_EQ(after.color, (Rgba{0xb0, 0x20, 0x20, 128}));
  EXPECT_EQ(after.points, before.points);
  ASSERT_EQ(after.widths.size(), before.widths.size());
  for (std::size_t i = 0; i < after.widths.size(); ++i) {
    EXPECT_EQ(after.widths[i].width_mm, 2.0 * before.widths[i].width_mm);
    EXPECT_EQ(after.widths[i].tone, before.widths[i].tone);
  }
  fixture.must(RestyleEvent{.width_factor = 100.0});
  EXPECT_EQ(fixture.session.document().find({1})->widths()[0].width_mm, kMaxRestyledWidthMm);
  fixture.must(RestyleEvent{.width_factor = 0.01});
  fixture.must(RestyleEvent{.width_factor = 0.01});
  EXPECT_EQ(fixture.session.document().find({1})->widths()[0].width_mm, kMinWidthMm);
  for (const double opacity : {-0.1, 1.1, std::nan("")}) {
    EXPECT_FALSE(fixture.apply(RestyleEvent{.opacity = opacity}));
  }
  for (const double factor : {0.0, 101.0, std::nan("")}) {
    EXPECT_FALSE(fixture.apply(RestyleEvent{.width_factor = factor}));
  }
}

}  // namespace
}  // namespace felt::session_commands_test
