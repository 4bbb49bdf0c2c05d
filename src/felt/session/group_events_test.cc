// Tests of blend modes and of groups of layers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "felt/document/testing/random_document.h"
#include "felt/session/group_edit.h"
#include "felt/session/layer_edit.h"
#include "felt/session/session.h"
#include "felt/session/testing/fake_tools.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::group_events_test {
namespace {

using Do = LayerEvent::Do;
using ::testing::HasSubstr;

/// A fixture: four layers with one stroke each.
struct GroupFixture {
  GroupFixture() {
    std::vector<std::unique_ptr<Tool>> tools;
    tools.push_back(std::make_unique<FakePencil>());
    session = std::make_unique<Session>(std::move(tools), SessionOptions{});
    for (std::uint64_t i = 1; i <= 4; ++i) {
      if (i > 1) {
        EXPECT_EQ(apply(LayerEvent{}), "");
      }
      const std::vector<StrokePtr> strokes = {
          std::make_shared<const Stroke>(testing::random_stroke(i))};
      EXPECT_TRUE(session->import(0, ImportEvent{}, strokes));
    }
  }

  std::string apply(const decltype(Event::what)& what) const {
    const Result<void> done = session->apply({0, what});
    return done ? "" : done.error().message;
  }
  std::string group(std::vector<LayerId> layers, std::string name = {}) {
    LayerEvent event{Do::kGroup, {}, std::move(name)};
    event.layers = std::move(layers);
    return apply(event);
  }
  std::string of_group(Do what, std::uint64_t id, std::size_t index = 0) {
    LayerEvent event{what, {}, "New name", index};
    event.group = GroupId{id};
    event.opacity = 0.5;
    event.mode = BlendMode::kMultiply;
    return apply(event);
  }
  std::string move(std::uint64_t id, std::size_t index, std::optional<GroupId> group = {}) {
    LayerEvent event{Do::kMove, {id}, {}, index};
    event.group = group;
    return apply(event);
  }
  [[nodiscard]] const Document& document() const { return session->document(); }
  /// Returns the layers from the lowest, with brackets around groups: "1 [2 3] 4".
  [[nodiscard]] std::string order() const {
    std::string text;
    LayerGroupPtr last;
    for (const Layer& layer : document().layers()) {
      if (!same_group(layer.group, last)) text += last ? "]" : "";
      if (!text.empty()) text += ' ';
      if (layer.group && !same_group(layer.group, last)) text += '[';
      text += std::to_string(layer.id.value);
      last = layer.group;
    }
    return text + (last ? "]" : "");
  }

  std::unique_ptr<Session> session;
};

TEST(BlendEvents, AModeIsAStepOfUndoAndLayersWithDifferentOnesCannotBeMerged) {
  GroupFixture f;
  LayerEvent event{Do::kBlend, {2}};
  event.mode = BlendMode::kMultiply;
  EXPECT_EQ(f.apply(event), "");
  EXPECT_EQ(f.document().layer({2})->blend, BlendMode::kMultiply);
  EXPECT_THAT(f.apply(LayerEvent{Do::kMerge, {2}}), HasSubstr("differ in blend mode"));
  EXPECT_EQ(f.apply(LayerEvent{Do::kDuplicate, {2}}), "");
  EXPECT_EQ(f.document().layer({5})->blend, BlendMode::kMultiply);
  EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_EQ(f.document().layer({2})->blend, BlendMode::kNormal);
}

TEST(GroupEvents, LayersAreGatheredAtTheHighestOfThem) {
  GroupFixture f;
  const std::size_t steps = f.session->history().undo_count();
  EXPECT_EQ(f.group({{4}, {2}}, "Cat"), "");
  EXPECT_EQ(f.order(), "1 3 [2 4]");
  EXPECT_EQ(f.session->history().undo_count(), steps + 1);
  EXPECT_EQ(f.document().group({1})->name, "Cat");
  EXPECT_EQ(f.group({{1}}), "");
  EXPECT_EQ(f.document().group({2})->name, "Group 2");
  EXPECT_EQ(f.group({{4}, {3}}), "") << "a layer leaves its group";
  EXPECT_EQ(f.order(), "[1] [2] [3 4]");
  EXPECT_THAT(f.group({}), HasSubstr("no layer"));
  EXPECT_EQ(f.group({{9}}), "no layer 9");
}

TEST(GroupEvents, AGroupIsShownLockedFadedAndRenamedAsOneStep) {
  GroupFixture f;
  ASSERT_EQ(f.group({{2}, {3}}), "");
  const std::size_t steps = f.session->history().undo_count();
  EXPECT_EQ(f.of_group(Do::kHide, 1), "");
  EXPECT_FALSE(f.document().layer({2})->visible);
  EXPECT_TRUE(f.document().layer({2})->own_visible);
  EXPECT_EQ(f.of_group(Do::kShow, 1), "");
  EXPECT_EQ(f.of_group(Do::kLock, 1), "");
  EXPECT_TRUE(f.document().layer({3})->locked);
  EXPECT_THAT(f.apply(LayerEvent{Do::kUse, {3}}), HasSubstr("is locked"));
  EXPECT_EQ(f.of_group(Do::kUnlock, 1), "");
  EXPECT_EQ(f.of_group(Do::kOpacity, 1), "");
  EXPECT_EQ(f.of_group(Do::kBlend, 1), "");
  EXPECT_EQ(f.of_group(Do::kRename, 1), "");
  EXPECT_EQ(*f.document().group({1}),
            (LayerGroup{{1}, "New name", true, false, 0.5, BlendMode::kMultiply}));
  EXPECT_EQ(f.document().layer({2})->opacity, 1.0);
  EXPECT_EQ(f.session->history().undo_count(), steps + 7);
  EXPECT_EQ(f.of_group(Do::kBlend, 1), "");
  EXPECT_EQ(f.session->history().undo_count(), steps + 7) << "nothing has changed";
  EXPECT_EQ(f.of_group(Do::kHide, 2), "no group 2");
  EXPECT_THAT(f.of_group(Do::kUse, 1), HasSubstr("cannot do this"));
  EXPECT_THAT(f.of_group(Do::kMerge, 1), HasSubstr("cannot do this"));
}

TEST(GroupEvents, AGroupMovesPastLayersAndOtherGroups) {
  GroupFixture f;
  ASSERT_EQ(f.group({{1}, {2}}), "");
  ASSERT_EQ(f.group({{3}, {4}}), "");
  EXPECT_EQ(f.of_group(Do::kRaise, 1), "");
  EXPECT_EQ(f.order(), "[3 4] [1 2]");
  EXPECT_EQ(f.of_group(Do::kRaise, 1), "");
  EXPECT_EQ(f.order(), "[3 4] [1 2]") << "it is the highest";
  EXPECT_EQ(f.of_group(Do::kMove, 1, 0), "");
  EXPECT_EQ(f.order(), "[1 2] [3 4]");
  EXPECT_EQ(f.of_group(Do::kMove, 1, 1), "") << "would split the other group";
  EXPECT_EQ(f.order(), "[3 4] [1 2]");
  EXPECT_EQ(f.of_group(Do::kLower, 1), "");
  EXPECT_EQ(f.order(), "[1 2] [3 4]");
}

TEST(GroupEvents, LayersMoveInIntoAndOutOfGroups) {
  GroupFixture f;
  ASSERT_EQ(f.group({{2}, {3}}), "");
  EXPECT_EQ(f.apply(LayerEvent{Do::kRaise, {3}}), "");
  EXPECT_EQ(f.order(), "1 [2 3] 4") << "the highest of its group stays";
  EXPECT_EQ(f.apply(LayerEvent{Do::kRaise, {2}}), "");
  EXPECT_EQ(f.order(), "1 [3 2] 4");
  EXPECT_EQ(f.apply(LayerEvent{Do::kRaise, {1}}), "");
  EXPECT_EQ(f.order(), "[3 2] 1 4") << "past the whole group";
  EXPECT_EQ(f.apply(LayerEvent{Do::kLower, {1}}), "");
  EXPECT_EQ(f.order(), "1 [3 2] 4");
  EXPECT_EQ(f.move(4, 2), "") << "between its layers";
  EXPECT_EQ(f.order(), "1 [3 4 2]");
  EXPECT_EQ(f.move(2, 3), "");
  EXPECT_EQ(f.order(), "1 [3 4 2]") << "stays next to the others";
  EXPECT_EQ(f.move(2, 3, GroupId{}), "");
  EXPECT_EQ(f.order(), "1 [3 4] 2");
  EXPECT_EQ(f.move(1, 9, GroupId{1}), "");
  EXPECT_EQ(f.order(), "[3 4 1] 2");
  EXPECT_EQ(f.move(4, 1, GroupId{}), "") << "the nearest position outside";
  EXPECT_EQ(f.order(), "[3 1] 4 2");
  EXPECT_EQ(f.move(4, 1, GroupId{5}), "no group 5");
  EXPECT_EQ(f.apply(LayerEvent{Do::kUse, {3}}), "");
  EXPECT_EQ(f.apply(LayerEvent{}), "") << "a new layer is in the group of the current one";
  EXPECT_EQ(f.order(), "[3 5 1] 4 2");
  EXPECT_THAT(f.apply(LayerEvent{Do::kMerge, {4}}), HasSubstr("not in the same group"));
}

TEST(GroupEvents, AGroupIsCopiedDissolvedAndRemoved) {
  GroupFixture f;
  ASSERT_EQ(f.group({{2}, {3}}, "Cat"), "");
  ASSERT_EQ(f.of_group(Do::kOpacity, 1), "");
  ASSERT_EQ(f.of_group(Do::kBlend, 1), "");
  const Document before = f.document();
  EXPECT_EQ(f.of_group(Do::kDuplicate, 1), "");
  EXPECT_EQ(f.order(), "1 [2 3] [5 6] 4");
  EXPECT_EQ(f.session->layer(), LayerId{6});
  EXPECT_EQ(f.document().group({2})->name, "Cat copy");
  EXPECT_EQ(f.document().group({2})->opacity, 0.5);
  const Layer& copy = *f.document().layer({6});
  ASSERT_EQ(copy.strokes.size(), 1U);
  EXPECT_EQ(*f.document().find(copy.strokes[0]),
            *f.document().find(f.document().layer({3})->strokes[0]));
  EXPECT_EQ(f.of_group(Do::kRemove, 2), "");
  EXPECT_TRUE(f.document() == before);
  EXPECT_EQ(f.of_group(Do::kHide, 1), "");
  EXPECT_EQ(f.of_group(Do::kUngroup, 1), "");
  EXPECT_EQ(f.order(), "1 2 3 4");
  EXPECT_EQ(f.document().layer({2})->state(),
            (LayerState{"Layer 2", false, false, 0.5, {}, BlendMode::kMultiply}));
}

/// A fill of one layer of a group may follow lines of another layer.
TEST(GroupEvents, CopiedFillsFollowTheCopiedLinesInAllLayersOfTheGroup) {
  GroupFixture f;
  const std::vector<Point> corners{{10, 10}, {40, 10}, {40, 40}, {10, 10}};
  std::vector<StrokePtr> strokes;
  FillLoop loop{{corners[0]}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    strokes.push_back(std::make_shared<const Stroke>(
        testing::straight_stroke(corners[i], corners[i + 1], 1.0, 1.0)));
    loop.points.insert(loop.points.end(), {corners[i], corners[i + 1], corners[i + 1]});
    loop.pieces.push_back({StrokeId{i + 1}, 0.0, 1.0});
  }
  const auto fill = std::make_shared<const Fill>(Fill{{loop}, {200, 40, 0, 255}, 0.0});
  ASSERT_EQ(f.apply(LayerEvent{Do::kUse, {3}}), "");
  ASSERT_TRUE(f.session->import(0, ImportEvent{}, strokes, std::vector{fill}));
  // The fill is now in layer 2 or 4, below or above the layer of its lines.
  for (const std::uint64_t other : {2U, 4U}) {
    Document document = f.document();
    const FillId id = document.layer({3})->fills[0];
    const FillPtr drawn = document.find_fill(id);
    const Edit moved{"Move", {}, {}, {{id, drawn, drawn, {{3}, 0}, {{other}, 0}}}};
    ASSERT_TRUE(document.apply(moved));
    LayerEvent group{Do::kGroup, {}};
    group.layers = {{2}, {3}, {4}};
    ASSERT_TRUE(document.apply(group_edit(document, group).value()));
    LayerEvent copy{Do::kDuplicate, {}};
    copy.group = document.layer({3})->group->id;
    ASSERT_TRUE(document.apply(group_edit(document, copy).value()));
    const std::span<const Layer> layers = document.layers();
    ASSERT_EQ(layers.size(), 7U);
    ASSERT_TRUE(testing::is_consistent(document));
    const Layer &lines = layers[5], &filled = layers[other == 2 ? 4 : 6];
    ASSERT_EQ(filled.fills.size(), 1U);
    const FillLoop copied = document.find_fill(filled.fills[0])->loops[0];
    ASSERT_EQ(copied.pieces.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(copied.pieces[i].stroke, lines.strokes[lines.strokes.size() - 3 + i]);
    }
  }
}

TEST(GroupEvents, OneLayerStays) {
  GroupFixture f;
  ASSERT_EQ(f.group({{1}, {2}, {3}, {4}}), "");
  EXPECT_EQ(f.of_group(Do::kLock, 1), "");
  EXPECT_EQ(f.order(), "[1 2 3 4]") << "the first ink adds a layer";
  EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_EQ(f.of_group(Do::kRemove, 1), "");
  EXPECT_EQ(f.document().layers().size(), 1U);
  EXPECT_EQ(f.document().stroke_count(), 0U);
}

/// Any events keep the invariants (Document::apply refuses other edits, which is a failed event of
/// the session), keep a current layer, which is open if any layer is, and are undone by value, one
/// step for each.
RC_GTEST_PROP(GroupEvents, AnyEventsKeepTheInvariantsAndAreUndone, ()) {
  GroupFixture f;
  std::vector<Document> before;
  for (int i = 0; i < 30; ++i) {
    const auto any = [](int last) {
      return static_cast<std::uint64_t>(*rc::gen::inRange(1, last));
    };
    LayerEvent event{static_cast<Do>(*rc::gen::inRange(0, 20)), {}};
    event.name = "Name";
    event.index = any(8);
    event.opacity = static_cast<double>(any(3)) / 2.0;
    event.mode = static_cast<BlendMode>(any(3) - 1);
    event.layers = {{any(7)}, {any(7)}};
    const bool is_of_group = *rc::gen::arbitrary<bool>();
    if (is_of_group) {
      event.group = GroupId{any(4)};
    } else {
      event.layer = {any(7)};
      if (*rc::gen::arbitrary<bool>()) event.group = GroupId{any(4) - 1};
    }
    const Document now = f.document();
    const std::size_t steps = f.session->history().undo_count();
    const std::string error = f.apply(event);
    RC_ASSERT(error.find("does not match") == std::string::npos);
    RC_ASSERT(testing::is_consistent(f.document()));
    const Layer* used = f.document().layer(f.session->layer());
    RC_ASSERT(used != nullptr);
    RC_ASSERT(is_open(*used) || !highest_open_layer(f.document()));
    const std::size_t made = f.session->history().undo_count() - steps;
    RC_ASSERT(made <= 1U);
    if (made == 0) RC_ASSERT(f.document() == now);
    if (made == 1) before.push_back(now);
  }
  for (; !before.empty(); before.pop_back()) {
    RC_ASSERT(f.apply(UndoEvent{}).empty());
    RC_ASSERT(f.document() == before.back());
  }
}

TEST(GroupEvents, NamesStayShortEnoughForFiles) {
  GroupFixture f;
  const std::string longest(kMaxLayerNameBytes - 3, 'n');
  ASSERT_EQ(f.group({{2}, {3}}, longest + "\u270e"), "");
  LayerEvent copy{Do::kDuplicate, {}};
  copy.group = GroupId{1};
  ASSERT_EQ(f.apply(copy), "");
  const std::string name = f.document().group({2})->name;
  EXPECT_EQ(name, longest.substr(0, kMaxLayerNameBytes - 5) + " copy");
  EXPECT_THAT(f.group({{1}}, longest + "1234"), HasSubstr("longer than 4096 bytes"));
  LayerEvent rename{Do::kRename, {}, longest + "1234"};
  rename.group = GroupId{1};
  EXPECT_THAT(f.apply(rename), HasSubstr("longer than 4096 bytes"));
}

}  // namespace
}  // namespace felt::group_events_test
