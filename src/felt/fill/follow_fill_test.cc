#include "felt/fill/follow_fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "felt/fill/fill_shape.h"
#include "felt/fill/testing/map_drawing.h"
#include "felt/geometry/affine.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::follow_fill_test {
namespace {

using testing::lines_through;
using testing::MapDrawing;
using testing::stroke_of;

constexpr Rgba kBlue{0, 0, 200, 255};

double net_area(const Fill& fill) {
  double area = 0.0;
  for (const FillLoop& loop : fill.loops) area += area_of(loop);
  return std::fabs(area);
}

/// Four lines that cross near the corners of the square (0, 0) to (20, 20).
struct FollowFill : ::testing::Test {
  FollowFill() {
    top = drawing.line({-3.0, 0.0}, {23.0, 0.0});
    right = drawing.line({20.0, -3.0}, {20.0, 23.0});
    bottom = drawing.line({23.0, 20.0}, {-3.0, 20.0});
    left = drawing.line({0.0, 23.0}, {0.0, -3.0});
    fill = drawing.map.face_at({10.0, 10.0}, 0.0, kBlue).value().fill;
  }
  std::optional<Fill> follow(std::span<const LineEdit> edits = {},
                             WhenOpened when_opened = WhenOpened::kRemove) {
    return follow_fill(fill, drawing.map, edits, when_opened);
  }
  StrokePtr stroke(StrokeId id) { return drawing.map.meetings().find(id)->stroke; }

  MapDrawing drawing;
  StrokeId top, right, bottom, left;
  Fill fill;
};

TEST_F(FollowFill, returns_an_unchanged_fill_bit_for_bit) {
  drawing.line({5.0, -5.0}, {5.0, 30.0});  // crosses the fill, but is not its boundary
  drawing.circle({10.0, 10.0}, 2.0);
  EXPECT_EQ(follow(), fill);
}

TEST_F(FollowFill, corners_follow_a_pulled_line) {
  // The right side is pulled 6 mm to the right, as a curve: 8 / 9 of the handles' displacement.
  drawing.set(right, stroke_of({{20.0, -3.0}, {28.0, 5.0}, {28.0, 15.0}, {20.0, 23.0}}));
  const auto now = follow();
  ASSERT_TRUE(now.has_value());
  EXPECT_EQ(now->loops[0].pieces.size(), 4U);
  const auto again = drawing.map.face_at({10.0, 10.0}, 0.0, kBlue);
  ASSERT_TRUE(again.has_value());
  EXPECT_GT(net_area(*now), 450.0);
  EXPECT_NEAR(net_area(*now), net_area(again->fill), 1e-9);
}

TEST_F(FollowFill, corners_move_to_the_nearest_crossings) {
  drawing.set(right, stroke_of(lines_through({{14.0, -3.0}, {18.0, 23.0}})));
  const auto now = follow();
  ASSERT_TRUE(now.has_value());
  const auto face = drawing.map.face_at({7.0, 10.0}, 0.0, kBlue);
  ASSERT_TRUE(face.has_value());
  EXPECT_NEAR(net_area(*now), net_area(face->fill), 1e-9);
}

TEST_F(FollowFill, moves_exactly_with_a_transform) {
  const Affine m = then(rotation(0.7, {5.0, 5.0}), Affine{1.5, 0.2, -0.3, 0.8, 100.0, -40.0});
  for (std::uint64_t i = 1; i <= 4; ++i) {
    StrokeData data = stroke(StrokeId{i})->data();
    for (Point& p : data.points) p = apply(m, p);
    drawing.set(StrokeId{i}, std::make_shared<const Stroke>(Stroke::create(data).value()));
  }
  const auto now = follow();
  ASSERT_TRUE(now.has_value());
  EXPECT_EQ(now->loops[0].pieces, fill.loops[0].pieces);
  for (std::size_t i = 0; i < fill.loops[0].points.size(); ++i) {
    EXPECT_LE(distance(now->loops[0].points[i], apply(m, fill.loops[0].points[i])), 1e-11);
  }
}

TEST_F(FollowFill, leaves_lines_at_the_same_place_behind) {
  for (std::uint64_t i = 1; i <= 4; ++i) drawing.add(stroke(StrokeId{i}));  // 5 to 8, in place
  Fill copy = fill;
  for (FillPiece& piece : copy.loops[0].pieces) piece.stroke.value += 4;
  for (std::uint64_t i = 5; i <= 8; ++i) {
    StrokeData data = stroke(StrokeId{i})->data();
    for (Point& p : data.points) p += Vec{0.0, 30.0};
    drawing.set(StrokeId{i}, std::make_shared<const Stroke>(Stroke::create(data).value()));
  }
  EXPECT_EQ(follow(), fill);
  const auto moved = follow_fill(copy, drawing.map, {}, WhenOpened::kRemove);
  ASSERT_TRUE(moved.has_value());
  EXPECT_EQ(moved->loops[0].pieces, copy.loops[0].pieces);
  EXPECT_NEAR(fill_bounds(*moved).y0, 30.0, 1e-9);
}

TEST_F(FollowFill, a_stroke_with_other_segments_bounds_the_same_area) {
  const StrokePtr before = stroke(top);
  drawing.set(
      top,
      stroke_of(lines_through({{-3.0, 0.0}, {1.0, 0.0}, {4.0, 0.0}, {15.0, 0.0}, {23.0, 0.0}})));
  const LineEdit edit{top, before, {top}};
  for (const auto& edits : {std::vector<LineEdit>{edit}, std::vector<LineEdit>{}}) {
    const auto now = follow(edits);
    ASSERT_TRUE(now.has_value());
    EXPECT_NEAR(net_area(*now), 400.0, 1e-9);
  }
}

TEST_F(FollowFill, an_erased_part_removes_the_fill_or_is_closed) {
  const StrokePtr before = stroke(top);
  const StrokeId rest{77};
  drawing.set(top, stroke_of(lines_through({{-3.0, 0.0}, {8.0, 0.0}})));
  drawing.set(rest, stroke_of(lines_through({{12.0, 0.0}, {23.0, 0.0}})));
  const std::vector<LineEdit> edits{{top, before, {top, rest}}};
  EXPECT_FALSE(follow(edits, WhenOpened::kRemove).has_value());
  const auto closed = follow(edits, WhenOpened::kClose);
  ASSERT_TRUE(closed.has_value());
  EXPECT_NEAR(net_area(*closed), 400.0, 1e-9);
  EXPECT_EQ(closed->loops[0].pieces.size(), 6U);  // two parts and a bridge in the place of one
  fill.max_gap_mm = 5.0;                          // the gap is small enough to be bridged
  const auto bridged = follow(edits, WhenOpened::kRemove);
  ASSERT_TRUE(bridged.has_value());
  EXPECT_NEAR(net_area(*bridged), 400.0, 1e-9);
}

TEST_F(FollowFill, a_removed_stroke_removes_the_fill_or_is_closed) {
  const StrokePtr before = stroke(top);
  drawing.set(top, nullptr);
  for (const auto& edits : {std::vector<LineEdit>{{top, before, {}}}, std::vector<LineEdit>{}}) {
    EXPECT_FALSE(follow(edits, WhenOpened::kRemove).has_value());
    const auto closed = follow(edits, WhenOpened::kClose);
    ASSERT_TRUE(closed.has_value());
    EXPECT_NEAR(net_area(*closed), 400.0, 1e-9);
  }
}

TEST_F(FollowFill, an_id_that_has_changed_is_found_by_its_shape) {
  const StrokePtr same = stroke(top);
  drawing.set(top, nullptr);
  drawing.set(StrokeId{50}, same);
  const auto now = follow();
  ASSERT_TRUE(now.has_value());
  EXPECT_NEAR(net_area(*now), 400.0, 1e-9);
  EXPECT_TRUE(std::any_of(now->loops[0].pieces.begin(), now->loops[0].pieces.end(),
                          [](const FillPiece& p) { return p.stroke == StrokeId{50}; }));
}

TEST_F(FollowFill, a_hole_moves_leaves_and_disappears) {
  const StrokeId hole = drawing.circle({10.0, 10.0}, 3.0);
  fill = drawing.map.face_at({2.0, 2.0}, 0.0, kBlue).value().fill;
  ASSERT_EQ(fill.loops.size(), 2U);
  const double with_hole = net_area(fill);
  drawing.set(hole, MapDrawing::circle_stroke({14.0, 8.0}, 3.0));
  auto now = follow();
  ASSERT_TRUE(now && now->loops.size() == 2);
  EXPECT_NEAR(net_area(*now), with_hole, 1e-9);
  EXPECT_FALSE(is_in_fill(*now, {14.0, 8.0}));
  drawing.set(hole, MapDrawing::circle_stroke({50.0, 8.0}, 3.0));
  now = follow();
  ASSERT_TRUE(now && now->loops.size() == 1);
  drawing.set(hole, nullptr);
  now = follow(std::vector<LineEdit>{{hole, nullptr, {}}});
  ASSERT_TRUE(now && now->loops.size() == 1);
  EXPECT_EQ(now->loops[0], fill.loops[0]);
}

TEST(FollowFillOnRings, crossings_pass_the_seam_of_a_closed_stroke) {
  MapDrawing drawing;  // the seam of the circle is its rightmost point
  drawing.circle({0.0, 0.0}, 10.0);
  const StrokeId line = drawing.line({-20.0, 2.0}, {20.0, 2.0});
  const Fill fill = drawing.map.face_at({0.0, 5.0}, 0.0, kBlue).value().fill;
  for (const double y : {2.0, 0.5, -0.5, -4.0}) {
    drawing.set(line, stroke_of(lines_through({{-20.0, y}, {20.0, y}})));
    const auto now = follow_fill(fill, drawing.map, {}, WhenOpened::kRemove);
    ASSERT_TRUE(now.has_value()) << y;
    const auto face = drawing.map.face_at({0.0, 5.0}, 0.0, kBlue);
    EXPECT_NEAR(net_area(*now), net_area(face->fill), 1e-9) << y;
  }
}

TEST(FollowFillOnBridges, bridged_fills_move_with_a_transform_and_open_when_the_gap_grows) {
  MapDrawing drawing;
  const StrokeId bow = drawing.add(stroke_of({{0.0, 0.0}, {0.0, 15.0}, {20.0, 15.0}, {20.0, 0.0}}));
  const StrokeId lid = drawing.line({1.0, 0.0}, {18.0, 0.0});
  const Fill fill = drawing.map.face_at({10.0, 5.0}, 3.0, kBlue).value().fill;
  const Affine m = rotation(1.0, {3.0, 3.0});
  const auto moved = [&](StrokeId id) {
    StrokeData data = drawing.map.meetings().find(id)->stroke->data();
    for (Point& p : data.points) p = apply(m, p);
    return std::make_shared<const Stroke>(Stroke::create(data).value());
  };
  drawing.set(bow, moved(bow));
  drawing.set(lid, moved(lid));
  const auto now = follow_fill(fill, drawing.map, {}, WhenOpened::kRemove);
  ASSERT_TRUE(now.has_value());
  EXPECT_NEAR(net_area(*now), net_area(fill), 1e-9);
  drawing.set(lid, stroke_of(lines_through({{3.0, -30.0}, {15.0, -30.0}})));
  EXPECT_FALSE(follow_fill(*now, drawing.map, {}, WhenOpened::kRemove).has_value());
}

TEST(FollowFillRandomly, small_displacements_give_the_face_at_the_same_place) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    testing::RandomStroke random(seed);
    MapDrawing drawing;
    std::vector<StrokeData> strokes;
    for (int i = 0; i < 4; ++i) strokes.push_back(random.make());
    for (const StrokeData& data : strokes) drawing.add(data);
    const Point p{random.uniform(0.0, 20.0), random.uniform(0.0, 20.0)};
    const auto face = drawing.map.face_at(p, 0.0, kBlue);
    if (!face || net_area(face->fill) < 1.0) continue;
    for (Point& q : strokes[0].points) q += Vec{1e-4, -1e-4};
    drawing.set(StrokeId{1}, std::make_shared<const Stroke>(Stroke::create(strokes[0]).value()));
    const auto now = follow_fill(face->fill, drawing.map, {}, WhenOpened::kRemove);
    const auto again = drawing.map.face_at(p, 0.0, kBlue);
    if (!again || again->fill.loops.size() != face->fill.loops.size()) continue;
    ++compared;
    ASSERT_TRUE(now.has_value());
    EXPECT_NEAR(net_area(*now), net_area(again->fill), 0.05);
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace felt::follow_fill_test
