#include "felt/tools/selection_view.h"

#include <gtest/gtest.h>

#include "felt/tools/testing/desk.h"

namespace felt::selection_view_test {
namespace {

using testing::Desk;
using testing::random_stroke;
using testing::straight_stroke;

TEST(SelectionView, IsUpToDateAfterOneLookAtAFewStrokes) {
  Desk desk;
  SelectionView view;
  for (std::uint64_t i = 0; i < 8; ++i) {
    const StrokeId id = desk.add(random_stroke(i));
    desk.selection.set_whole(id, desk.document.find(id)->data().points.size());
    view.look(desk.document, desk.selection);
    EXPECT_EQ(view.stroke_count(), i + 1);
    EXPECT_EQ(view.box(), desk.selection.bounds(desk.document));
  }
  desk.selection.clear();
  view.look(desk.document, desk.selection);
  EXPECT_TRUE(view.empty());
  EXPECT_TRUE(view.box().empty());
}

TEST(SelectionView, GetsRoundALargeSelectionBitByBit) {
  Desk desk;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    const double x = static_cast<double>(i);
    const StrokeId id = desk.add(straight_stroke({x, 0}, {x, 10}, 1, 1));
    desk.selection.set_whole(id, 4);
  }
  SelectionView view;
  std::size_t looks = 0;
  while (view.empty()) {
    view.look(desk.document, desk.selection);
    ++looks;
  }
  EXPECT_EQ(looks, 1500 * 4 / SelectionView::kPointsPerLook);
  EXPECT_EQ(view.box(), desk.selection.bounds(desk.document));
  EXPECT_EQ(view.stroke_count(), 1500u);
  Overlay overlay;
  view.draw(overlay);
  EXPECT_EQ(overlay.spans.size(), 1500u);
  SelectionView other;
  other.look_at_all(desk.document, desk.selection);
  EXPECT_EQ(other.fingerprint(), view.fingerprint());
}

TEST(SelectionView, TellsOneSelectionFromAnother) {
  Desk desk;
  const StrokeId id = desk.add(straight_stroke({0, 0}, {9, 0}, 1, 1));
  SelectionView view;
  desk.selection.set(id, {1, 0, 0, 1});
  view.look(desk.document, desk.selection);
  const std::uint64_t before = view.fingerprint();
  EXPECT_EQ(view.partial_count(), 1u);
  view.look(desk.document, desk.selection);
  EXPECT_EQ(view.fingerprint(), before);
  desk.selection.set(id, {1, 1, 0, 1});
  view.look(desk.document, desk.selection);
  EXPECT_NE(view.fingerprint(), before);
}

TEST(SelectionView, MarksWhatGoesAndWhatBends) {
  Desk desk;
  StrokeData d = straight_stroke({0, 0}, {9, 0}, 1, 1).data();
  d.points.insert(d.points.end(), {{12, 0}, {15, 0}, {18, 0}, {21, 3}, {24, 3}, {27, 0}});
  d.joints.assign(2, JointKind::kCorner);
  d.widths.back().u = 3.0;
  const StrokeId id = desk.add(Stroke::create(std::move(d)).value());
  desk.selection.set(id, {1, 1, 1, 1, 0, 0, 0, 0, 0, 0});
  SelectionView view;
  view.look(desk.document, desk.selection);
  Overlay overlay;
  view.draw(overlay);
  ASSERT_EQ(overlay.spans.size(), 2u);
  EXPECT_EQ(overlay.spans[0].role, Overlay::Role::kSelected);
  EXPECT_EQ(overlay.spans[1].role, Overlay::Role::kSpan);
}

TEST(SelectionView, LeavesLockedLayersOut) {
  Desk desk;
  const StrokeId id = desk.add(straight_stroke({0, 0}, {9, 0}, 1, 1));
  desk.selection.set_whole(id, 4);
  const Layer layer = desk.document.layers()[0];
  LayerState locked = layer.state();
  locked.locked = true;
  desk.apply({"Lock", {}, {{layer.id, layer.state(), locked, 0, 0}}});
  EXPECT_FALSE(is_editable(desk.document, id));
  SelectionView view;
  view.look(desk.document, desk.selection);
  EXPECT_TRUE(view.empty());
}

TEST(SelectionView, AFrameGoesRoundMoreThanItMarks) {
  Desk desk;
  for (std::size_t i = 0; i < SelectionView::kMaxSpans + 1; ++i) {
    const double x = static_cast<double>(i);
    const StrokeId id = desk.add(straight_stroke({x, 0}, {x, 10}, 1, 1));
    desk.selection.set_whole(id, 4);
  }
  SelectionView view;
  view.look_at_all(desk.document, desk.selection);
  Overlay overlay;
  view.draw(overlay);
  EXPECT_EQ(overlay.spans.size(), SelectionView::kMaxSpans);
  ASSERT_EQ(overlay.outlines.size(), 1U);
  EXPECT_EQ(overlay.outlines[0].points[2], (Point{double(SelectionView::kMaxSpans), 10}));
}

}  // namespace
}  // namespace felt::selection_view_test
