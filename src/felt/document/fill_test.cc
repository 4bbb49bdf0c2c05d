#include "felt/document/fill.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/document/edit_builder.h"
#include "felt/document/history.h"
#include "felt/document/testing/random_fills.h"
#include "felt/document/visible_strokes.h"

namespace felt::fill_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Returns a square from (0, 0) to (side, side).
Fill square(double side) {
  const std::vector<Point> corners{{0, 0}, {side, 0}, {side, side}, {0, side}, {0, 0}};
  FillLoop loop{{corners[0]}, {}};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    loop.points.insert(loop.points.end(), {corners[i - 1], corners[i], corners[i]});
  }
  return {{loop}, {200, 30, 30, 255}, 0.0};
}

FillPtr shared(double side) {
  return std::make_shared<const Fill>(square(side));
}

std::string error_of(const Fill& fill) {
  const auto result = check_fill(fill);
  return result ? "" : result.error().message;
}

TEST(Fill, GoesWithStrokesIfAllOfItsBoundaryIsChosen) {
  Fill fill = square(4);
  const auto all = [](StrokeId) { return true; };
  const auto not_2 = [](StrokeId id) { return id != StrokeId{2}; };
  EXPECT_FALSE(goes_with_strokes(fill, all)) << "it has no strokes";
  fill.loops[0].pieces = {{{1}, 0, 1}, {{}, 0, 0}, {{3}, 0, 1}};
  EXPECT_TRUE(goes_with_strokes(fill, not_2)) << "a bridge has no stroke";
  fill.loops.push_back(fill.loops[0]);
  EXPECT_TRUE(goes_with_strokes(fill, not_2));
  fill.loops[1].pieces[0].stroke = {2};
  EXPECT_FALSE(goes_with_strokes(fill, not_2)) << "a hole counts, too";
  EXPECT_TRUE(goes_with_strokes(fill, all));
  fill.loops[0].pieces = {{{}, 0, 0}};
  fill.loops[1].pieces.clear();
  EXPECT_FALSE(goes_with_strokes(fill, all)) << "a bridge alone is not a stroke";
}

RC_GTEST_PROP(Fill, RandomFillsAreValid, (std::uint64_t seed)) {
  testing::RandomStroke random(seed);
  RC_ASSERT(check_fill(testing::random_fill(random)).has_value());
}

TEST(Fill, EachBrokenInvariantIsNamed) {
  EXPECT_EQ(error_of(square(4)), "");
  EXPECT_THAT(error_of(Fill{}), HasSubstr("no boundary"));
  Fill fill = square(4);
  fill.loops[0].points.pop_back();
  EXPECT_THAT(error_of(fill), HasSubstr("loop 1 of the fill does not have 3n + 1 points"));
  fill = square(4);
  fill.loops[0].points.back().x = 1e-300;
  EXPECT_THAT(error_of(fill), HasSubstr("is not closed"));
  fill = square(4);
  fill.loops.push_back(fill.loops[0]);
  fill.loops[1].points[1].y = std::numeric_limits<double>::infinity();
  EXPECT_THAT(error_of(fill), HasSubstr("loop 2 of the fill has a point that is not finite"));
  fill = square(4);
  fill.loops[0].pieces.assign(5, FillPiece{});
  EXPECT_THAT(error_of(fill), HasSubstr("more pieces than segments"));
  fill = square(4);
  fill.loops[0].pieces = {FillPiece{{1}, 0.0, -1.0}};
  EXPECT_THAT(error_of(fill), HasSubstr("invalid parameter"));
  fill.loops[0].pieces = {FillPiece{{}, 0.0, 1.0}};
  EXPECT_THAT(error_of(fill), HasSubstr("bridge with parameters"));
  fill = square(4);
  fill.max_gap_mm = -1.0;
  EXPECT_THAT(error_of(fill), HasSubstr("invalid gap"));
}

TEST(Fill, BoundsAndPolygonsFollowTheLoops) {
  const Rect bounds = fill_bounds(square(4));
  EXPECT_EQ(bounds, (Rect{0, 0, 4, 4}));
  EXPECT_TRUE(fill_bounds(Fill{}).empty());
  Outline outline;
  flatten_fill(square(4), 0.01, outline);
  ASSERT_EQ(outline.contour_count(), 1u);
  for (const Point& p : outline.points) {
    const double to_edge = std::min({p.x, p.y, std::abs(4.0 - p.x), std::abs(4.0 - p.y)});
    EXPECT_LT(to_edge, 1e-12) << p.x << ", " << p.y;
  }
}

TEST(Fill, AnEditAddsReplacesAndRemovesFillsAndUndoRestoresThem) {
  Document d;
  EditBuilder builder(d);
  const StrokeId stroke =
      builder.add({1}, std::make_shared<const Stroke>(testing::random_stroke(7)));
  const FillId low = builder.add_fill({1}, shared(1)), high = builder.add_fill({1}, shared(2));
  const Edit draw = std::move(builder).build("Fill");
  EXPECT_EQ(stroke.value, 1u);
  EXPECT_EQ(low.value, 2u) << "strokes and fills share one counter";
  History history;
  ASSERT_TRUE(d.apply(draw));
  history.record(draw);
  EXPECT_GT(history.memory_bytes(), 2 * 13 * sizeof(Point));
  EXPECT_THAT(d.layers()[0].fills, ElementsAre(low, high));
  EXPECT_EQ(d.fill_place(high), (StrokePlace{{1}, 1}));
  EditBuilder change(d);
  change.remove_fill(low);
  change.replace_fill(high, shared(3));
  const Edit edit = std::move(change).build("Change");
  ASSERT_TRUE(d.apply(edit));
  history.record(edit);
  EXPECT_EQ(d.fill_count(), 1u);
  EXPECT_FALSE(d.find_fill(low));
  EXPECT_EQ(*d.find_fill(high), square(3));
  ASSERT_TRUE(history.undo(d));
  EXPECT_EQ(*d.find_fill(low), square(1));
  EXPECT_EQ(*d.find_fill(high), square(2));
  ASSERT_TRUE(history.undo(d));
  EXPECT_EQ(d.fill_count(), 0u);
  EXPECT_EQ(d.new_fill_id().value, 4u) << "ids are not reused";
}

TEST(Fill, AnEditThatDoesNotFitChangesNothing) {
  Document d;
  EditBuilder builder(d);
  const FillId id = builder.add_fill({1}, shared(1));
  ASSERT_TRUE(d.apply(std::move(builder).build("Fill")));
  const auto error = [&d](const Edit& edit) {
    Document copy = d;
    const auto result = copy.apply(edit);
    EXPECT_EQ(copy, d);
    return result ? "" : result.error().message;
  };
  Edit edit{"Paint", {}};
  edit.fills = {{id, nullptr, shared(2), {}, {{1}, 0}}};
  EXPECT_THAT(error(edit), HasSubstr("fill 1 already exists"));
  edit.fills = {{id, shared(2), nullptr, {{1}, 0}, {}}};
  EXPECT_THAT(error(edit), HasSubstr("fill 1 has changed in the meantime"));
  edit.fills = {{id, shared(1), nullptr, {{1}, 1}, {}}};
  EXPECT_THAT(error(edit), HasSubstr("fill 1 is not at index 1 of layer 1"));
  edit.fills = {{{2}, nullptr, shared(2), {}, {{1}, 2}}};
  EXPECT_THAT(error(edit), HasSubstr("layer 1: place 3 of 2 is beyond the end"));
  edit.fills = {};
  edit.layers = {{{1}, d.layers()[0].state(), {}, 0, 0}, {{2}, {}, LayerState{"New"}, 0, 0}};
  EXPECT_THAT(error(edit), HasSubstr("layer 1 cannot be removed: 1 fills are on it"));
  edit.fills = {{id, shared(1), shared(1), {{1}, 0}, {{2}, 0}}};
  ASSERT_TRUE(d.apply(edit)) << "the fill moves to the new layer";
  EXPECT_EQ(d.layer_of_fill(id).value, 2u);
}

}  // namespace
}  // namespace felt::fill_test
