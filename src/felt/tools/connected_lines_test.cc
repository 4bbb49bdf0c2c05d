#include "felt/tools/connected_lines.h"

#include <gtest/gtest.h>

#include <numbers>

#include "felt/tools/moved_strokes.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::connected_lines_test {
namespace {

using testing::Fixture;
using testing::straight_stroke;

Stroke of_color(Stroke stroke, Rgba color) {
  StrokeData data = stroke.data();
  data.color = color;
  return Stroke::create(std::move(data)).value();
}

constexpr Rgba kRed{200, 0, 0, 255};

struct Moved : Fixture {
  StrokeId line = add(straight_stroke({0, 0}, {40, 0}, 1, 1));

  std::vector<Point> move(const Affine& map, Selection::Marks marks = {1, 1, 1, 1}) {
    selection.set(line, std::move(marks));
    const MovedStrokes moved(document, index, selection, false);
    apply(moved.finished(map, 1.0, "Move"));
    return moved.anchors();
  }
  [[nodiscard]] const Stroke& at(StrokeId id) const { return *document.find(id); }
};

TEST(ConnectedLines, R33_AnEndOfAnotherColourGoesAlongAndItsLineHolds) {
  Moved m;
  const StrokeId red = m.add(of_color(straight_stroke({40, 0}, {40, 50}, 1, 1), kRed));
  const Stroke before = m.at(red);
  const auto anchors = m.move(translation({12, 7}));
  EXPECT_EQ(m.at(m.line).position(1), (Point{52, 7}));
  EXPECT_EQ(m.at(red).position(0), (Point{52, 7})) << "still one point";
  EXPECT_EQ(m.at(red).position(1), (Point{40, 50}));
  EXPECT_EQ(anchors, (std::vector<Point>{{40, 50}})) << "one line holds it";
  m.undo();
  EXPECT_EQ(m.at(red), before) << "one step";
}

TEST(ConnectedLines, R34_EveryConnectedLineHolds) {
  Moved m;
  for (int i = 0; i < 5; ++i) m.add(of_color(straight_stroke({40, 0}, {90, 10.0 * i}, 1, 1), kRed));
  EXPECT_EQ(m.move(rotation(0.3, {0, 0})).size(), 5u);
}

TEST(ConnectedLines, R33_AnEndInTheMiddleGoesAlongAlsoWhereTheLineBends) {
  for (const bool bends : {false, true}) {
    Moved m;
    const StrokeId post = m.add(of_color(straight_stroke({10, -30}, {10, 0}, 1, 1), kRed));
    m.move(translation({0, 20}),
           bends ? Selection::Marks{1, 1, 0, 0} : Selection::Marks{1, 1, 1, 1});
    EXPECT_LE(distance(m.at(post).position(1), m.at(m.line).position(0.25)), 1e-9);
    EXPECT_EQ(m.at(post).position(0), (Point{10, -30}));
  }
}

TEST(ConnectedLines, R33_ALineOnWhichAMovedEndStandsBendsThere) {
  Moved m;
  const StrokeId base = m.add(of_color(straight_stroke({40, -30}, {40, 30}, 1, 1), kRed));
  const auto anchors = m.move(translation({15, 0}));
  EXPECT_EQ(m.at(base).segment_count(), 2);
  EXPECT_LE(distance(m.at(base).position(1), {55, 0}), 1e-9);
  EXPECT_EQ(m.at(base).position(0), (Point{40, -30}));
  EXPECT_EQ(m.at(base).position(2), (Point{40, 30}));
  EXPECT_EQ(anchors.size(), 2u);
}

/// Adds a line to a locked layer. One of its ends lies on the end of `line`.
StrokeId add_locked(Moved& m) {
  m.apply({"Layer", {}, {{{2}, std::nullopt, LayerState{"Other"}, 0, 1}}});
  m.layer = LayerId{2};
  const StrokeId red = m.add(of_color(straight_stroke({40, 0}, {40, 50}, 1, 1), kRed));
  m.apply({"State", {}, {{{2}, LayerState{"Other"}, LayerState{"Other", true, true}, 1, 1}}});
  m.layer = LayerId{1};
  return red;
}

TEST(ConnectedLines, R33_ALockedLineHoldsItsEndAndStaysAsItIs) {
  Moved m;
  const StrokeId red = add_locked(m);
  const Stroke before = m.at(red);
  // The post is connected, so its end moves. Its other end lies on the locked line.
  const StrokeId post = m.add(straight_stroke({0, 0}, {40, 50}, 1, 1));
  const auto anchors = m.move(translation({12, 7}), {1, 1, 0, 0});
  EXPECT_EQ(m.at(red), before);
  EXPECT_EQ(m.at(m.line).position(0), (Point{12, 7}));
  EXPECT_EQ(m.at(m.line).position(1), (Point{40, 0}));
  EXPECT_EQ(m.at(post).position(0), (Point{12, 7}));
  EXPECT_EQ(m.at(post).position(1), (Point{40, 50})) << "held";
  EXPECT_EQ(anchors.size(), 2u);
}

TEST(ConnectedLines, R33_AnEndOnALockedLineIsHeldIfTheLineMovesInPart) {
  Moved m;
  add_locked(m);
  const StrokeId two = m.add(
      Stroke::create({.points = {{40, 0}, {44, 0}, {48, 0}, {52, 0}, {56, 0}, {60, 0}, {64, 0}},
                      .joints = {JointKind::kSmooth},
                      .closed = false,
                      .widths = {{0, 1}, {2, 1}}})
          .value());
  m.selection.set(two, {1, 1, 1, 1, 1, 0, 0});
  const MovedStrokes moved(m.document, m.index, m.selection, false);
  m.apply(moved.finished(translation({0, 9}), 1.0, "Move"));
  EXPECT_EQ(m.at(two).position(0), (Point{40, 0})) << "held";
  EXPECT_EQ(m.at(two).position(1), (Point{52, 9}));
  EXPECT_EQ(m.at(two).position(2), (Point{64, 0}));
}

TEST(ConnectedLines, R33_AWholeLineMovesInItsShapeAlsoIfItTouchesALockedLine) {
  Moved m;
  const StrokeId red = add_locked(m);
  const Stroke before = m.at(red);
  EXPECT_TRUE(m.move(translation({12, 7})).empty());
  EXPECT_EQ(m.at(m.line), straight_stroke({12, 7}, {52, 7}, 1, 1));
  EXPECT_EQ(m.at(red), before);
}

TEST(ConnectedLines, WhatIsSelectedKeepsItsOwnMarks) {
  Moved m;
  const StrokeId red = m.add(of_color(straight_stroke({40, 0}, {40, 50}, 1, 1), kRed));
  m.selection.set(red, {1, 1, 1, 1});
  EXPECT_TRUE(m.move(translation({3, 0})).empty()) << "all of it moves: nothing holds";
  EXPECT_EQ(m.at(red).position(1), (Point{43, 50}));
}

}  // namespace
}  // namespace felt::connected_lines_test
