#include "felt/tools/pencil/connect_ink.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "felt/tools/testing/desk.h"

namespace felt::connect_ink_test {
namespace {

using testing::Desk;
using testing::straight_stroke;

using enum StrokeTip;

void run(Desk& desk, const Stroke& ink, const InkConnections& connections) {
  const Edit edit = connect_ink(ink, connections, desk.scene());
  EXPECT_EQ(edit.label, "Draw");
  desk.apply(edit);
}

TEST(ConnectInk, FreeInkIsAddedAsItIs) {
  Desk desk;
  const Stroke ink = straight_stroke({0, 0}, {50, 0}, 1, 2);
  run(desk, ink, {});
  ASSERT_EQ(desk.strokes().size(), 1u);
  EXPECT_EQ(*desk.strokes()[0], ink);
}

TEST(ConnectInk, R45_JoinsAtAnyOfTheFourPairsOfEnds) {
  for (const StrokeTip tip : {kStart, kEnd}) {
    for (const StrokeTip mine : {kStart, kEnd}) {
      Desk desk;
      const StrokeId below = desk.add(straight_stroke({0, 90}, {9, 90}, 1, 1));
      const StrokeId old = desk.add(straight_stroke({0, 0}, {50, 0}, 1, 2));
      desk.add(straight_stroke({0, 80}, {9, 80}, 1, 1));
      const Point meet = tip_point(*desk.document.find(old), tip);
      const Point near = meet + Vec{1, 1}, far = meet + Vec{5, 60};
      const Stroke ink =
          mine == kStart ? straight_stroke(near, far, 3, 4) : straight_stroke(far, near, 4, 3);
      run(desk, ink,
          mine == kStart ? InkConnections{.start = TipId{old, tip}}
                         : InkConnections{.end = TipId{old, tip}});
      ASSERT_EQ(desk.strokes().size(), 3u);
      EXPECT_EQ(desk.document.layers()[0].strokes[0], below);
      EXPECT_EQ(desk.document.layers()[0].strokes[1], old);  // its id and position
      const Stroke& one = *desk.document.find(old);
      EXPECT_FALSE(one.closed());
      // The existing part keeps its direction.
      EXPECT_EQ(tip_point(one, opposite(tip)), (tip == kEnd ? Point{0, 0} : Point{50, 0}));
      EXPECT_EQ(tip_point(one, tip), far);
      const int joint = tip == kEnd ? 1 : one.segment_count() - 1;
      EXPECT_EQ(one.position(joint), meet);
      EXPECT_EQ(one.joint(joint), JointKind::kCorner);
      const auto widths = one.widths();
      EXPECT_EQ((tip == kEnd ? widths.back() : widths.front()).width_mm, 4.0);
      desk.undo();
      EXPECT_EQ(*desk.document.find(old), straight_stroke({0, 0}, {50, 0}, 1, 2));
    }
  }
}

TEST(ConnectInk, R45_SmoothBelowThirtyDegreesElseCorner) {
  for (const double deg : {10.0, 29.0, 31.0, 90.0}) {
    Desk desk;
    const StrokeId old = desk.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
    const double a = deg * std::numbers::pi / 180;
    const Point far = Point{50, 0} + 80 * Vec{std::cos(a), std::sin(a)};
    run(desk, straight_stroke({50, 0}, far, 1, 1), {.start = TipId{old, kEnd}});
    const Stroke& one = *desk.document.find(old);
    EXPECT_EQ(one.joint(1), deg < 30 ? JointKind::kSmooth : JointKind::kCorner) << deg;
  }
}

TEST(ConnectInk, BetweenTwoStrokesMakesOneOfThree) {
  for (const StrokeTip a : {kStart, kEnd}) {
    for (const StrokeTip b : {kStart, kEnd}) {
      Desk desk;
      const StrokeId first = desk.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
      const StrokeId second = desk.add(straight_stroke({0, 70}, {50, 70}, 2, 2));
      const Point from = tip_point(*desk.document.find(first), a);
      const Point to = tip_point(*desk.document.find(second), b);
      run(desk, straight_stroke(from + Vec{1, 1}, to + Vec{1, -1}, 1, 2),
          {.start = TipId{first, a}, .end = TipId{second, b}});
      ASSERT_EQ(desk.strokes().size(), 1u);
      const Stroke& one = *desk.document.find(first);
      EXPECT_EQ(tip_point(one, opposite(a)), (a == kEnd ? Point{0, 0} : Point{50, 0}));
      EXPECT_EQ(tip_point(one, a), (b == kEnd ? Point{0, 70} : Point{50, 70}));
      EXPECT_FALSE(desk.document.find(second));
      desk.undo();
      EXPECT_EQ(desk.strokes().size(), 2u);
    }
  }
}

TEST(ConnectInk, R43_BothEndsOfOneStrokeCloseIt) {
  for (const StrokeTip a : {kStart, kEnd}) {
    Desk desk;
    const StrokeId old = desk.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
    const Point from = tip_point(*desk.document.find(old), a);
    const Point to = tip_point(*desk.document.find(old), opposite(a));
    const Stroke ink = Stroke::create({.points = {from, from + Vec{0, 40}, to + Vec{0, 40}, to},
                                       .joints = {},
                                       .closed = false,
                                       .widths = {{0, 1}, {1, 1}}})
                           .value();
    run(desk, ink, {.start = TipId{old, a}, .end = TipId{old, opposite(a)}});
    ASSERT_EQ(desk.strokes().size(), 1u);
    EXPECT_TRUE(desk.document.find(old)->closed());
  }
}

TEST(ConnectInk, R43_ItsOwnStartMakesAClosedStroke) {
  Desk desk;
  const Stroke ink = Stroke::create({.points = {{0, 0}, {60, 0}, {60, 60}, {1, 1}},
                                     .joints = {},
                                     .closed = false,
                                     .widths = {{0, 1}, {1, 2}}})
                         .value();
  run(desk, ink, {.closes = true});
  ASSERT_EQ(desk.strokes().size(), 1u);
  EXPECT_TRUE(desk.strokes()[0]->closed());
  EXPECT_EQ(desk.strokes()[0]->position(0), (Point{0, 0}));
}

TEST(ConnectInk, KeptSeparateTheyShareThePoint) {
  Desk desk;
  const StrokeId old = desk.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
  run(desk, straight_stroke({51, 1}, {90, 40}, 1, 1),
      {.start = TipId{old, kEnd}, .keep_separate = true});
  ASSERT_EQ(desk.strokes().size(), 2u);
  EXPECT_EQ(*desk.strokes()[0], straight_stroke({0, 0}, {50, 0}, 1, 1));
  EXPECT_EQ(tip_point(*desk.strokes()[1], kStart), (Point{50, 0}));
}

TEST(ConnectInk, InkOfAnotherLookStaysItself) {
  for (const bool color : {true, false}) {
    Desk desk;
    StrokeData data = straight_stroke({0, 0}, {50, 0}, 1, 1).data();
    (color ? data.color.r : data.color.a) = 7;
    if (!color) {
      data.color = {};
      data.medium = "chalk";
    }
    const StrokeId old = desk.add(Stroke::create(data).value());
    run(desk, straight_stroke({51, 1}, {90, 40}, 1, 1), {.start = TipId{old, kEnd}});
    ASSERT_EQ(desk.strokes().size(), 2u);
    EXPECT_EQ(tip_point(*desk.strokes()[1], kStart), (Point{50, 0}));
  }
}

TEST(ConnectInk, LockedAndOtherLayersAreNotChanged) {
  Desk desk;
  const StrokeId old = desk.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
  desk.apply({"Layer", {}, {{{2}, std::nullopt, LayerState{"Top"}, 0, 1}}});
  desk.layer = {2};
  run(desk, straight_stroke({51, 1}, {90, 40}, 1, 1), {.start = TipId{old, kEnd}});
  EXPECT_EQ(desk.strokes().size(), 2u);
  EXPECT_EQ(tip_point(*desk.strokes()[1], kStart), (Point{50, 0}));
  desk.layer = {1};
  desk.apply({"Lock", {}, {{{1}, LayerState{"Ink"}, LayerState{"Ink", true, true}, 0, 0}}});
  run(desk, straight_stroke({-1, 1}, {-40, 40}, 1, 1), {.start = TipId{old, kStart}});
  EXPECT_EQ(*desk.document.find(old), straight_stroke({0, 0}, {50, 0}, 1, 1));
}

TEST(ConnectInk, WhatCannotBeConnectedIsStillInk) {
  Desk desk;
  const StrokeId old = desk.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
  const Stroke dot = straight_stroke({51, 0}, {51.05, 0}, 1, 1);
  run(desk, dot, {.start = TipId{old, kEnd}});  // too short to reach
  run(desk, dot, {.closes = true});
  run(desk, dot, {.start = TipId{{77}, kEnd}, .end = TipId{{78}, kStart}});  // do not exist
  run(desk, dot, {.start = TipId{old, kEnd}, .end = TipId{old, kEnd}});
  ASSERT_EQ(desk.strokes().size(), 5u);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_EQ(*desk.strokes()[i], dot);
}

}  // namespace
}  // namespace felt::connect_ink_test
