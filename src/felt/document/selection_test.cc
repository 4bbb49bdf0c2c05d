#include "felt/document/selection.h"

#include <gtest/gtest.h>

#include "felt/document/testing/random_document.h"

namespace felt::selection_test {
namespace {

std::size_t points_of(const Document& document, StrokeId id) {
  return document.find(id)->data().points.size();
}

/// Selects some strokes whole and some in part.
void select_some(Selection& selection, const Document& document, testing::RandomStroke& random) {
  for (const Layer& layer : document.layers()) {
    if (!layer.visible || layer.locked) continue;
    for (const StrokeId id : layer.strokes) {
      if (random.chance(0.5)) continue;
      Selection::Marks marks(points_of(document, id), 1);
      if (random.chance(0.5)) marks[static_cast<std::size_t>(random.pick(0, 3))] = 0;
      if (document.find(id)->closed()) marks.back() = marks.front();
      selection.set(id, marks);
    }
  }
}

/// Expects that every selected stroke exists, is editable, and has a mark for each point, at least
/// one of them set.
void expect_consistent(const Selection& selection, const Document& document) {
  for (const auto& [id, marks] : selection.strokes()) {
    const StrokePtr stroke = document.find(id);
    ASSERT_TRUE(stroke);
    ASSERT_EQ(marks.size(), stroke->data().points.size());
    ASSERT_NE(std::count(marks.begin(), marks.end(), 1), 0);
    ASSERT_TRUE(!stroke->closed() || marks.front() == marks.back());
    const Layer& layer = *document.layer(document.layer_of(id));
    ASSERT_TRUE(layer.visible && !layer.locked);
  }
  (void)selection.bounds(document);
}

TEST(Selection, FollowsAnyEditAndItsInverse) {
  std::size_t kept = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    testing::RandomEdits edits(seed);
    testing::RandomStroke random(seed + 1);
    Document document;
    Selection selection;
    std::vector<Edit> done;
    for (int k = 0; k < 40; ++k) {
      select_some(selection, document, random);
      const Selection before = selection;
      const bool back = !done.empty() && random.chance(0.4);
      const Edit edit = back ? done.back().inverse() : edits.next(document);
      ASSERT_TRUE(document.apply(edit));
      selection.follow(edit, document);
      expect_consistent(selection, document);
      if (HasFatalFailure()) return;
      for (const auto& [id, marks] : selection.strokes()) {
        ASSERT_TRUE(before.find(id)) << "nothing is selected by an edit";
        Selection::Marks was = *before.find(id);
        if (document.find(id)->closed()) was.front() = was.back() = was.front() | was.back();
        ASSERT_TRUE(was == marks || before.is_whole(id));
        ++kept;
      }
      if (back) {
        done.pop_back();
      } else {
        done.push_back(edit);
      }
    }
  }
  EXPECT_GT(kept, 1000u);
}

TEST(Selection, AStrokeWithoutASelectedPointIsNotInIt) {
  Selection selection;
  selection.set({1}, {0, 1, 0, 0});
  EXPECT_EQ(selection.point_count(), 1u);
  EXPECT_FALSE(selection.is_whole({1}));
  selection.set({1}, {0, 0, 0, 0});
  EXPECT_TRUE(selection.empty());
  selection.set_whole({2}, 7);
  EXPECT_TRUE(selection.is_whole({2}));
  EXPECT_EQ(selection.find({1}), nullptr);
  selection.remove({2});
  EXPECT_TRUE(selection.empty());
}

TEST(Selection, ReplacedStrokesKeepTheirMarksWhereTheyStillMeanSomething) {
  const auto line = std::make_shared<const Stroke>(testing::straight_stroke({0, 0}, {9, 0}, 1, 1));
  StrokeData twice = line->data();
  twice.points.insert(twice.points.end(), {{10, 0}, {11, 0}, {12, 0}});
  twice.joints.push_back(JointKind::kCorner);
  twice.widths.back().u = 2.0;
  const auto longer = std::make_shared<const Stroke>(Stroke::create(twice).value());
  Selection selection;
  for (std::uint64_t id = 1; id <= 3; ++id) selection.set_whole({id}, 4);
  selection.set({2}, {1, 0, 0, 0});
  selection.follow(Edit{"Edit",
                        {{{1}, line, longer, {{1}, 0}, {{1}, 0}},
                         {{2}, line, longer, {{1}, 1}, {{1}, 1}},
                         {{3}, line, nullptr, {{1}, 2}, {}}}});
  EXPECT_TRUE(selection.is_whole({1}));
  EXPECT_EQ(selection.find({1})->size(), 7u);
  EXPECT_EQ(selection.find({2}), nullptr) << "which of the new points were meant nobody knows";
  EXPECT_EQ(selection.find({3}), nullptr);
}

TEST(Selection, TheSharedPointOfAStrokeThatIsClosedNowHasOneMark) {
  StrokeData data = testing::straight_stroke({0, 0}, {9, 0}, 1, 1).data();
  const auto open = std::make_shared<const Stroke>(Stroke::create(data).value());
  data.points = {{0, 0}, {9, 0}, {9, 9}, {0, 0}};
  data.closed = true;
  data.joints = {JointKind::kCorner};
  const auto closed = std::make_shared<const Stroke>(Stroke::create(data).value());
  for (const Selection::Marks& marks : {Selection::Marks{1, 0, 0, 0}, {0, 0, 0, 1}}) {
    Selection selection;
    selection.set({1}, marks);
    selection.follow(Edit{"Connect", {{{1}, open, closed, {{1}, 0}, {{1}, 0}}}});
    EXPECT_EQ(*selection.find({1}), (Selection::Marks{1, 0, 0, 1}));
  }
}

TEST(Selection, AllMeansWhatMayBeEdited) {
  testing::RandomEdits edits(4);
  Document document;
  for (int k = 0; k < 60; ++k) {
    ASSERT_TRUE(document.apply(edits.next(document)));
    const Selection all = select_all(document);
    expect_consistent(all, document);
    std::size_t editable = 0;
    for (const Layer& layer : document.layers()) {
      if (layer.visible && !layer.locked) editable += layer.strokes.size();
    }
    ASSERT_EQ(all.strokes().size(), editable);
    for (const auto& [id, marks] : all.strokes()) ASSERT_TRUE(all.is_whole(id));
  }
}

}  // namespace
}  // namespace felt::selection_test
