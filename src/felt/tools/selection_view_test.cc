#include "felt/tools/selection_view.h"

#include <gtest/gtest.h>

#include "felt/tools/testing/tool_fixture.h"

namespace felt::selection_view_test {
namespace {

using testing::Fixture;
using testing::random_stroke;
using testing::straight_stroke;

TEST(SelectionView, IsUpToDateAfterOneLookAtAFewStrokes) {
  Fixture fixture;
  SelectionView view;
  for (std::uint64_t i = 0; i < 8; ++i) {
    const StrokeId id = fixture.add(random_stroke(i));
    fixture.selection.set_whole(id, fixture.document.find(id)->data().points.size());
    view.look(fixture.document, fixture.selection);
    EXPECT_EQ(view.stroke_count(), i + 1);
    EXPECT_EQ(view.box(), fixture.selection.bounds(fixture.document));
  }
  fixture.selection.clear();
  view.look(fixture.document, fixture.selection);
  EXPECT_TRUE(view.empty());
  EXPECT_TRUE(view.box().empty());
}

TEST(SelectionView, GetsRoundALargeSelectionBitByBit) {
  Fixture fixture;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    const double x = static_cast<double>(i);
    const StrokeId id = fixture.add(straight_stroke({x, 0}, {x, 10}, 1, 1));
    fixture.selection.set_whole(id, 4);
  }
  SelectionView view;
  std::size_t looks = 0;
  while (view.empty()) {
    view.look(fixture.document, fixture.selection);
    ++looks;
  }
  EXPECT_EQ(looks, 1500 * 4 / SelectionView::kPointsPerLook);
  EXPECT_EQ(view.box(), fixture.selection.bounds(fixture.document));
  EXPECT_EQ(view.stroke_count(), 1500u);
  Overlay overlay;
  view.draw(overlay);
  EXPECT_EQ(overlay.spans.size(), 1500u);
  SelectionView other;
  other.look_at_all(fixture.document, fixture.selection);
  EXPECT_EQ(other.fingerprint(), view.fingerprint());
}

TEST(SelectionView, TellsOneSelectionFromAnother) {
  Fixture fixture;
  const StrokeId id = fixture.add(straight_stroke({0, 0}, {9, 0}, 1, 1));
  SelectionView view;
  fixture.selection.set(id, {1, 0, 0, 1});
  view.look(fixture.document, fixture.selection);
  const std::uint64_t before = view.fingerprint();
  EXPECT_EQ(view.partial_count(), 1u);
  view.look(fixture.document, fixture.selection);
  EXPECT_EQ(view.fingerprint(), before);
  fixture.selection.set(id, {1, 1, 0, 1});
  view.look(fixture.document, fixture.selection);
  EXPECT_NE(view.fingerprint(), before);
}

TEST(SelectionView, MarksWhatGoesAndWhatBends) {
  Fixture fixture;
  StrokeData d = straight_stroke({0, 0}, {9, 0}, 1, 1).data();
  d.points.insert(d.points.end(), {{12, 0}, {15, 0}, {18, 0}, {21, 3}, {24, 3}, {27, 0}});
  d.joints.assign(2, JointKind::kCorner);
  d.widths.back().u = 3.0;
  const StrokeId id = fixture.add(Stroke::create(std::move(d)).value());
  fixture.selection.set(id, {1, 1, 1, 1, 0, 0, 0, 0, 0, 0});
  SelectionView view;
  view.look(fixture.document, fixture.selection);
  Overlay overlay;
  view.draw(overlay);
  ASSERT_EQ(overlay.spans.size(), 2u);
  EXPECT_EQ(overlay.spans[0].role, Overlay::Role::kSelected);
  EXPECT_EQ(overlay.spans[1].role, Overlay::Role::kSpan);
}

TEST(SelectionView, LeavesLockedLayersOut) {
  Fixture fixture;
  const StrokeId id = fixture.add(straight_stroke({0, 0}, {9, 0}, 1, 1));
  fixture.selection.set_whole(id, 4);
  const Layer layer = fixture.document.layers()[0];
  LayerState locked = layer.state();
  locked.locked = true;
  fixture.apply({"Lock", {}, {{layer.id, layer.state(), locked, 0, 0}}});
  EXPECT_FALSE(is_editable(fixture.document, id));
  SelectionView view;
  view.look(fixture.document, fixture.selection);
  EXPECT_TRUE(view.empty());
}

TEST(SelectionView, MarksOfALargeSelectionAreEverywhereAndAFrameGoesRoundIt) {
  for (const std::size_t count :
       {SelectionView::kMaxSpans + 1, 2 * SelectionView::kMaxSpans, 7 * SelectionView::kMaxSpans}) {
    Fixture fixture;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = static_cast<double>(i);
      const StrokeId id = fixture.add(straight_stroke({x, 0}, {x, 10}, 1, 1));
      fixture.selection.set_whole(id, 4);
    }
    SelectionView view;
    for (int round = 0; round < 2; ++round) {  // the second one reuses the memory
      view.look_at_all(fixture.document, fixture.selection);
      Overlay overlay;
      view.draw(overlay);
      EXPECT_LE(overlay.spans.size(), SelectionView::kMaxSpans);
      EXPECT_GT(overlay.spans.size(), SelectionView::kMaxSpans / 3);
      // The same number of lines is between two marked ones, also before the first and the last.
      const double step = overlay.spans[1].curve.p[0].x - overlay.spans[0].curve.p[0].x;
      EXPECT_EQ(overlay.spans[0].curve.p[0].x, 0.0);
      for (std::size_t i = 0; i < overlay.spans.size(); ++i) {
        EXPECT_EQ(overlay.spans[i].curve.p[0].x, static_cast<double>(i) * step);
      }
      EXPECT_LE(static_cast<double>(count) - overlay.spans.back().curve.p[0].x, step);
      ASSERT_EQ(overlay.outlines.size(), 1U);
      EXPECT_NEAR(overlay.outlines[0].points[2].x, double(count - 1), 1e-9);
    }
  }
}

TEST(SelectionView, AVeryLongStrokeIsMarkedAsFarAsPossible) {
  Fixture fixture;
  const StrokeId shorter = fixture.add(straight_stroke({0, 0}, {0, 10}, 1, 1));
  fixture.selection.set_whole(shorter, 4);
  StrokeData data;
  const std::size_t segments = 2 * SelectionView::kMaxSpans;
  for (std::size_t i = 0; i <= 3 * segments; ++i) data.points.push_back({0.1 * double(i), 5.0});
  data.joints.assign(segments - 1, JointKind::kSmooth);
  data.widths = {{0.0, 1.0}, {double(segments), 1.0}};
  const std::size_t points = data.points.size();
  const StrokeId longer = fixture.add(*Stroke::create(std::move(data)));
  fixture.selection.set_whole(longer, points);
  SelectionView view;
  view.look_at_all(fixture.document, fixture.selection);
  Overlay overlay;
  view.draw(overlay);
  EXPECT_EQ(overlay.spans.size(), SelectionView::kMaxSpans);
  EXPECT_EQ(overlay.outlines.size(), 1U);
}

}  // namespace
}  // namespace felt::selection_view_test
