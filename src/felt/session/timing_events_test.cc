// Tests of the events of timings and of edits of the body.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/document/stroke_index.h"
#include "felt/session/session.h"
#include "felt/session/testing/fake_tools.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::timing_events_test {
namespace {

using ::testing::HasSubstr;

/// Remembers whether it finds a stroke near the pen.
class FindingTool : public FakePencil {
 public:
  explicit FindingTool(bool& finds) : FakePencil("find", ToolKind::kErases), finds_(finds) {}
  ToolResult sample(const PenSample& sample, Contact::Change, const Scene& scene) override {
    finds_ = scene.index.nearest(on_page(sample.position), 1.0).has_value();
    return {};
  }

 private:
  bool& finds_;
};

/// A session with three layers.
struct TimingFixture {
  TimingFixture() {
    std::vector<std::unique_ptr<Tool>> tools;
    tools.push_back(std::make_unique<FakePencil>());
    tools.push_back(std::make_unique<FindingTool>(finds_));
    session = std::make_unique<Session>(std::move(tools), SessionOptions{});
    for (int i = 0; i < 2; ++i) EXPECT_EQ(apply(LayerEvent{}), "");
  }
  std::string apply(const decltype(Event::what)& what, std::int64_t after_ns = 2'000'000'000) {
    const Result<void> done = session->apply({now_ns += after_ns, what});
    return done ? "" : done.error().message;
  }
  /// Returns true if a tool finds a stroke at this point.
  bool finds(Point at) {
    EXPECT_EQ(apply(SelectTool{"find"}), "");
    EXPECT_EQ(apply(PenEvent{{at.x, at.y, 5.0}, {}, 0}), "");
    return finds_;
  }
  [[nodiscard]] const Document& document() const { return session->document(); }
  [[nodiscard]] KeyTiming timing(std::uint64_t layer) const {
    return timing_or_default(document().layer({layer})->timing);
  }

  std::unique_ptr<Session> session;
  std::int64_t now_ns = 0;

 private:
  bool finds_ = false;
};

TEST(TimingEvents, ChangeOnlyWhatTheyNameAsOneStepOfUndo) {
  TimingFixture f;
  const std::size_t steps = f.session->history().undo_count();
  EXPECT_EQ(f.apply(TimingEvent{{{1}, {3}}, 4}), "");
  EXPECT_EQ(f.session->history().undo_count(), steps + 1);
  EXPECT_EQ(f.timing(1), (KeyTiming{.between = 4}));
  EXPECT_EQ(f.timing(2), KeyTiming());
  EXPECT_EQ(f.timing(3), (KeyTiming{.between = 4}));
  const std::vector<KeyPair> pairs{{{7}, {8}}};
  EXPECT_EQ(f.apply(TimingEvent{.layers = {{1}}, .hold = 3, .pairs = pairs}), "");
  EXPECT_EQ(f.apply(TimingEvent{.layers = {{1}}, .ease = EaseCurve{0.5, 0, 1, 1}}), "");
  EXPECT_EQ(f.timing(1), (KeyTiming{4, 3, {0.5, 0, 1, 1}, pairs}));
  EXPECT_EQ(f.apply(TimingEvent{{{1}}, 4}), "");
  EXPECT_EQ(f.session->history().undo_count(), steps + 3) << "nothing changed";
  EXPECT_EQ(f.apply(TimingEvent{{{1}}, 12, 1, EaseCurve{}, std::vector<KeyPair>()}), "");
  EXPECT_FALSE(f.document().layer({1})->timing) << "the values of a new one";
  for (int i = 0; i < 4; ++i) f.apply(UndoEvent{});
  for (std::uint64_t layer = 1; layer <= 3; ++layer) EXPECT_EQ(f.timing(layer), KeyTiming());
}

TEST(TimingEvents, QuickChangesOfTheSameLayersAreOneStepOfUndo) {
  TimingFixture f;
  const std::size_t steps = f.session->history().undo_count();
  for (int between = 1; between <= 9; ++between) {
    EXPECT_EQ(f.apply(TimingEvent{{{1}, {2}}, between}, 100'000'000), "");
  }
  EXPECT_EQ(f.session->history().undo_count(), steps + 1);
  EXPECT_EQ(f.apply(TimingEvent{{{2}}, 10}, 100'000'000), "");
  EXPECT_EQ(f.session->history().undo_count(), steps + 2) << "other layers";
  EXPECT_EQ(f.apply(TimingEvent{{{2}}, 11}), "");
  EXPECT_EQ(f.session->history().undo_count(), steps + 3) << "later";
  for (std::uint64_t to = 1; to <= 2; ++to) {
    const std::vector<KeyPair> pairs{{{7}, {to}}};
    EXPECT_EQ(f.apply(TimingEvent{.layers = {{2}}, .pairs = pairs}, 1), "");
  }
  EXPECT_EQ(f.session->history().undo_count(), steps + 5) << "each correction is a step";
  for (int i = 0; i < 3; ++i) EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_EQ(f.timing(2).between, 10);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_EQ(f.timing(1), KeyTiming());
  EXPECT_EQ(f.apply(RedoEvent{}), "");
  EXPECT_EQ(f.timing(1).between, 9);
}

TEST(TimingEvents, WrongOnesChangeNothing) {
  TimingFixture f;
  const std::size_t steps = f.session->history().undo_count();
  EXPECT_THAT(f.apply(TimingEvent{}), HasSubstr("ids: "));
  EXPECT_THAT(f.apply(TimingEvent{{{1}, {9}}, 4}), HasSubstr("no layer 9"));
  EXPECT_THAT(f.apply(TimingEvent{{{1}}, 4, 0}), HasSubstr("hold: "));
  EXPECT_THAT(f.apply(BodyEvent{}), HasSubstr("path: "));
  EXPECT_THAT(f.apply(BodyEvent{BodyEvent::Do::kRemove, {5}}), HasSubstr("no body edit 5"));
  EXPECT_EQ(f.session->history().undo_count(), steps);
}

TEST(TimingEvents, ACopyOfALayerHasItsTiming) {
  TimingFixture f;
  EXPECT_EQ(f.apply(TimingEvent{{{2}}, 4}), "");
  EXPECT_EQ(f.apply(LayerEvent{LayerEvent::Do::kDuplicate, {2}}), "");
  EXPECT_EQ(f.timing(4), (KeyTiming{.between = 4}));
}

/// Adds `count` strokes to a layer, and returns their ids.
std::vector<StrokeId> add_strokes(TimingFixture& f, LayerId layer, std::size_t count) {
  EXPECT_EQ(f.apply(LayerEvent{LayerEvent::Do::kUse, layer}), "");
  for (std::size_t i = 0; i < count; ++i) {
    const double y = 10.0 * static_cast<double>(i + 1);
    const std::vector<StrokePtr> line = {
        std::make_shared<const Stroke>(testing::straight_stroke({20, y}, {80, y}, 1, 1))};
    EXPECT_TRUE(f.session->import(0, ImportEvent{.path = {}, .select = false}, line));
  }
  return f.document().layer(layer)->strokes;
}

// Whatever is copied, a stroke that had a partner has one in the copy.
TEST(TimingEvents, ThePairsOfACopyNameTheCopiedStrokes) {
  for (const bool is_group : {false, true}) {
    TimingFixture f;
    const std::vector<StrokeId> a = add_strokes(f, {1}, 2), b = add_strokes(f, {2}, 2);
    const std::vector<KeyPair> pairs{{a[0], b[1]}, {a[1], {}}, {{}, b[0]}};
    EXPECT_EQ(f.apply(TimingEvent{.layers = {{1}}, .pairs = pairs}), "");
    if (!is_group) {
      EXPECT_EQ(f.apply(LayerEvent{LayerEvent::Do::kDuplicate, {1}}), "");
      const std::vector<StrokeId> copy = f.document().layer({4})->strokes;
      EXPECT_EQ(f.timing(4).pairs,
                (std::vector<KeyPair>{{copy[0], b[1]}, {copy[1], {}}, {{}, b[0]}}));
    } else {
      LayerEvent group{LayerEvent::Do::kGroup, {}};
      group.layers = {{1}, {2}};
      EXPECT_EQ(f.apply(group), "");
      LayerEvent duplicate{LayerEvent::Do::kDuplicate, {}};
      duplicate.group = f.document().layer({1})->group->id;
      EXPECT_EQ(f.apply(duplicate), "");
      const std::vector<StrokeId> from = f.document().layer({4})->strokes;
      const std::vector<StrokeId> to = f.document().layer({5})->strokes;
      EXPECT_EQ(f.timing(4).pairs,
                (std::vector<KeyPair>{{from[0], to[1]}, {from[1], {}}, {{}, to[0]}}));
    }
    EXPECT_EQ(f.timing(1).pairs, pairs);
  }
}

TEST(TimingEvents, MergedLayersKeepThePairsOfBoth) {
  TimingFixture f;
  const std::vector<StrokeId> a = add_strokes(f, {1}, 2), b = add_strokes(f, {2}, 2);
  const std::vector<StrokeId> c = add_strokes(f, {3}, 2);
  EXPECT_EQ(f.apply(TimingEvent{
                .layers = {{1}}, .between = 4, .pairs = std::vector<KeyPair>{{a[0], c[0]}}}),
            "");
  EXPECT_EQ(f.apply(TimingEvent{.layers = {{2}},
                                .between = 7,
                                .pairs = std::vector<KeyPair>{{b[0], c[1]}, {b[1], c[0]}}}),
            "");
  const Document before = f.document();
  EXPECT_EQ(f.apply(LayerEvent{LayerEvent::Do::kMerge, {2}}), "");
  EXPECT_EQ(f.timing(1).between, 4);
  EXPECT_EQ(f.timing(1).pairs, (std::vector<KeyPair>{{a[0], c[0]}, {b[0], c[1]}}))
      << "a stroke is in one pair only";
  EXPECT_TRUE(check_key_timing(f.timing(1)));
  EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_TRUE(f.document() == before);
}

TEST(TimingEvents, ANewLayerCanHaveTheTimingOfAnotherInOneStepOfUndo) {
  TimingFixture f;
  EXPECT_EQ(
      f.apply(TimingEvent{{{2}}, 4, 3, EaseCurve{0.5, 0, 1, 1}, std::vector<KeyPair>{{{7}, {8}}}}),
      "");
  const std::size_t steps = f.session->history().undo_count();
  LayerEvent add;
  add.timing_of = {2};
  EXPECT_EQ(f.apply(add), "");
  EXPECT_EQ(f.timing(4), (KeyTiming{4, 3, {0.5, 0, 1, 1}}));
  EXPECT_EQ(f.session->history().undo_count(), steps + 1);
  add.timing_of = {9};
  EXPECT_THAT(f.apply(add), HasSubstr("no layer 9"));
}

/// Returns the ids of the layers that are visible in seen().
std::vector<std::uint64_t> seen_layers(const Session& session) {
  std::vector<std::uint64_t> ids;
  for (const Layer& layer : session.seen().layers()) {
    if (layer.visible) ids.push_back(layer.id.value);
  }
  return ids;
}

using Ids = std::vector<std::uint64_t>;

TEST(ViewEvents, HideLayersFromToolsButNotInTheDocument) {
  TimingFixture f;
  const std::vector<StrokePtr> line = {
      std::make_shared<const Stroke>(testing::straight_stroke({20, 20}, {80, 20}, 1, 1))};
  EXPECT_EQ(f.apply(LayerEvent{LayerEvent::Do::kUse, {1}}), "");
  EXPECT_TRUE(f.session->import(0, ImportEvent{.path = {}, .select = true}, line));
  EXPECT_EQ(f.apply(LayerEvent{LayerEvent::Do::kUse, {3}}), "");
  const Document before = f.document();
  const std::size_t steps = f.session->history().undo_count();
  EXPECT_TRUE(f.finds({50, 20}));
  EXPECT_EQ(f.apply(UseView{{{3}, {1}, {99}, {1}}}), "");
  EXPECT_EQ(f.session->out_of_view(), (std::vector<LayerId>{{1}})) << "the current layer stays";
  EXPECT_EQ(seen_layers(*f.session), (Ids{2, 3}));
  EXPECT_FALSE(f.finds({50, 20}));
  EXPECT_TRUE(f.session->selection().strokes().empty());
  EXPECT_EQ(f.apply(SelectStrokes{}), "");
  EXPECT_TRUE(f.session->selection().strokes().empty()) << "select all";
  EXPECT_TRUE(f.document() == before);
  EXPECT_EQ(f.session->history().undo_count(), steps);
  EXPECT_EQ(f.apply(UseView{}), "");
  EXPECT_EQ(seen_layers(*f.session), (Ids{1, 2, 3}));
  EXPECT_TRUE(f.finds({50, 20}));
}

TEST(ViewEvents, EditsOfLayersOutOfViewAndUndoKeepThemOutOfView) {
  TimingFixture f;
  EXPECT_EQ(f.apply(UseView{{{1}, {2}}}), "");
  EXPECT_EQ(f.apply(TimingEvent{{{1}}, 4}), "");
  EXPECT_EQ(f.apply(LayerEvent{LayerEvent::Do::kHide, {2}}), "");
  EXPECT_EQ(f.apply(LayerEvent{LayerEvent::Do::kRemove, {1}}), "");
  EXPECT_EQ(seen_layers(*f.session), (Ids{3}));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_EQ(seen_layers(*f.session), (Ids{3}));
  EXPECT_TRUE(f.document().layer({1})->visible && f.document().layer({2})->visible);
  EXPECT_EQ(f.apply(LayerEvent{}), "");
  EXPECT_EQ(seen_layers(*f.session), (Ids{3, 4})) << "a new layer is in view";
}

TEST(ViewEvents, ALayerThatIsUsedComesIntoViewAndSoDoAllIfNoOtherIsOpen) {
  TimingFixture f;
  EXPECT_EQ(f.apply(UseView{{{1}, {2}}}), "");
  EXPECT_EQ(f.apply(LayerEvent{LayerEvent::Do::kUse, {1}}), "");
  EXPECT_EQ(f.session->layer(), LayerId{1});
  EXPECT_EQ(seen_layers(*f.session), (Ids{1, 3}));
  EXPECT_EQ(f.apply(LayerEvent{LayerEvent::Do::kLock, {3}}), "");
  EXPECT_EQ(f.apply(LayerEvent{LayerEvent::Do::kLock, {1}}), "");
  EXPECT_EQ(seen_layers(*f.session), (Ids{1, 2, 3}));
  EXPECT_EQ(f.session->layer(), LayerId{2});
}

TEST(BodyEvents, AddAndRemoveEditsOfTheBodyInTheirOrder) {
  TimingFixture f;
  const BodyEdit cut{.kind = BodyEditKind::kCut, .path_mm = {{1, -2, 0}, {3, -4, 0}}};
  BodyEdit paint = cut;
  paint.kind = BodyEditKind::kPaint;
  EXPECT_EQ(f.apply(BodyEvent{BodyEvent::Do::kAdd, {}, cut}), "");
  EXPECT_EQ(f.apply(BodyEvent{BodyEvent::Do::kAdd, {}, paint}), "");
  ASSERT_EQ(f.document().body_edits().size(), 2U);
  EXPECT_EQ(*f.document().body_edits().begin()->second, cut);
  EXPECT_EQ(*f.document().body_edits().rbegin()->second, paint);
  const BodyEditId first = f.document().body_edits().begin()->first;
  EXPECT_EQ(f.apply(BodyEvent{BodyEvent::Do::kRemove, first}), "");
  EXPECT_EQ(*f.document().body_edits().begin()->second, paint);
  EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_EQ(f.document().body_edits().size(), 2U);
  EXPECT_EQ(f.apply(BodyEvent{BodyEvent::Do::kClear}), "");
  EXPECT_TRUE(f.document().body_edits().empty());
  EXPECT_EQ(f.apply(UndoEvent{}), "");
  EXPECT_EQ(*f.document().body_edits().begin()->second, cut);
}

}  // namespace
}  // namespace felt::timing_events_test
