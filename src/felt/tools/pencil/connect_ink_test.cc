#include "felt/tools/pencil/connect_ink.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "felt/tools/testing/tool_fixture.h"

namespace felt::connect_ink_test {
namespace {

using testing::Fixture;
using testing::straight_stroke;

using enum StrokeTip;

void run(Fixture& fixture, const Stroke& ink, const InkConnections& connections) {
  const Edit edit = connect_ink(ink, connections, fixture.scene());
  EXPECT_EQ(edit.label, "Draw");
  fixture.apply(edit);
}

TEST(ConnectInk, FreeInkIsAddedAsItIs) {
  Fixture fixture;
  const Stroke ink = straight_stroke({0, 0}, {50, 0}, 1, 2);
  run(fixture, ink, {});
  ASSERT_EQ(fixture.strokes().size(), 1u);
  EXPECT_EQ(*fixture.strokes()[0], ink);
}

TEST(ConnectInk, R45_JoinsAtAnyOfTheFourPairsOfEnds) {
  for (const StrokeTip tip : {kStart, kEnd}) {
    for (const StrokeTip mine : {kStart, kEnd}) {
      Fixture fixture;
      const StrokeId below = fixture.add(straight_stroke({0, 90}, {9, 90}, 1, 1));
      const StrokeId old = fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 2));
      fixture.add(straight_stroke({0, 80}, {9, 80}, 1, 1));
      const Point meet = tip_point(*fixture.document.find(old), tip);
      const Point near = meet + Vec{1, 1}, far = meet + Vec{5, 60};
      const Stroke ink =
          mine == kStart ? straight_stroke(near, far, 3, 4) : straight_stroke(far, near, 4, 3);
      run(fixture, ink,
          mine == kStart ? InkConnections{.start = TipId{old, tip}}
                         : InkConnections{.end = TipId{old, tip}});
      ASSERT_EQ(fixture.strokes().size(), 3u);
      EXPECT_EQ(fixture.document.layers()[0].strokes[0], below);
      EXPECT_EQ(fixture.document.layers()[0].strokes[1], old);  // its id and position
      const Stroke& one = *fixture.document.find(old);
      EXPECT_FALSE(one.closed());
      // The existing part keeps its direction.
      EXPECT_EQ(tip_point(one, opposite(tip)), (tip == kEnd ? Point{0, 0} : Point{50, 0}));
      EXPECT_EQ(tip_point(one, tip), far);
      const int joint = tip == kEnd ? 1 : one.segment_count() - 1;
      EXPECT_EQ(one.position(joint), meet);
      EXPECT_EQ(one.joint(joint), JointKind::kCorner);
      const auto widths = one.widths();
      EXPECT_EQ((tip == kEnd ? widths.back() : widths.front()).width_mm, 4.0);
      fixture.undo();
      EXPECT_EQ(*fixture.document.find(old), straight_stroke({0, 0}, {50, 0}, 1, 2));
    }
  }
}

TEST(ConnectInk, R45_SmoothBelowThirtyDegreesElseCorner) {
  for (const double deg : {10.0, 29.0, 31.0, 90.0}) {
    Fixture fixture;
    const StrokeId old = fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
    const double a = deg * std::numbers::pi / 180;
    const Point far = Point{50, 0} + 80 * Vec{std::cos(a), std::sin(a)};
    run(fixture, straight_stroke({50, 0}, far, 1, 1), {.start = TipId{old, kEnd}});
    const Stroke& one = *fixture.document.find(old);
    EXPECT_EQ(one.joint(1), deg < 30 ? JointKind::kSmooth : JointKind::kCorner) << deg;
  }
}

TEST(ConnectInk, BetweenTwoStrokesMakesOneOfThree) {
  for (const StrokeTip a : {kStart, kEnd}) {
    for (const StrokeTip b : {kStart, kEnd}) {
      Fixture fixture;
      const StrokeId first = fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
      const StrokeId second = fixture.add(straight_stroke({0, 70}, {50, 70}, 2, 2));
      const Point from = tip_point(*fixture.document.find(first), a);
      const Point to = tip_point(*fixture.document.find(second), b);
      run(fixture, straight_stroke(from + Vec{1, 1}, to + Vec{1, -1}, 1, 2),
          {.start = TipId{first, a}, .end = TipId{second, b}});
      ASSERT_EQ(fixture.strokes().size(), 1u);
      const Stroke& one = *fixture.document.find(first);
      EXPECT_EQ(tip_point(one, opposite(a)), (a == kEnd ? Point{0, 0} : Point{50, 0}));
      EXPECT_EQ(tip_point(one, a), (b == kEnd ? Point{0, 70} : Point{50, 70}));
      EXPECT_FALSE(fixture.document.find(second));
      fixture.undo();
      EXPECT_EQ(fixture.strokes().size(), 2u);
    }
  }
}

TEST(ConnectInk, R43_BothEndsOfOneStrokeCloseIt) {
  for (const StrokeTip a : {kStart, kEnd}) {
    Fixture fixture;
    const StrokeId old = fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
    const Point from = tip_point(*fixture.document.find(old), a);
    const Point to = tip_point(*fixture.document.find(old), opposite(a));
    const Stroke ink = Stroke::create({.points = {from, from + Vec{0, 40}, to + Vec{0, 40}, to},
                                       .joints = {},
                                       .closed = false,
                                       .widths = {{0, 1}, {1, 1}}})
                           .value();
    run(fixture, ink, {.start = TipId{old, a}, .end = TipId{old, opposite(a)}});
    ASSERT_EQ(fixture.strokes().size(), 1u);
    EXPECT_TRUE(fixture.document.find(old)->closed());
  }
}

TEST(ConnectInk, R43_ItsOwnStartMakesAClosedStroke) {
  Fixture fixture;
  const Stroke ink = Stroke::create({.points = {{0, 0}, {60, 0}, {60, 60}, {1, 1}},
                                     .joints = {},
                                     .closed = false,
                                     .widths = {{0, 1}, {1, 2}}})
                         .value();
  run(fixture, ink, {.closes = true});
  ASSERT_EQ(fixture.strokes().size(), 1u);
  EXPECT_TRUE(fixture.strokes()[0]->closed());
  EXPECT_EQ(fixture.strokes()[0]->position(0), (Point{0, 0}));
}

TEST(ConnectInk, KeptSeparateTheyShareThePoint) {
  Fixture fixture;
  const StrokeId old = fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
  run(fixture, straight_stroke({51, 1}, {90, 40}, 1, 1),
      {.start = TipId{old, kEnd}, .keep_separate = true});
  ASSERT_EQ(fixture.strokes().size(), 2u);
  EXPECT_EQ(*fixture.strokes()[0], straight_stroke({0, 0}, {50, 0}, 1, 1));
  EXPECT_EQ(tip_point(*fixture.strokes()[1], kStart), (Point{50, 0}));
}

TEST(ConnectInk, InkOfAnotherLookStaysItself) {
  for (const bool color : {true, false}) {
    Fixture fixture;
    StrokeData data = straight_stroke({0, 0}, {50, 0}, 1, 1).data();
    (color ? data.color.r : data.color.a) = 7;
    if (!color) {
      data.color = {};
      data.medium = "chalk";
    }
    const StrokeId old = fixture.add(Stroke::create(data).value());
    run(fixture, straight_stroke({51, 1}, {90, 40}, 1, 1), {.start = TipId{old, kEnd}});
    ASSERT_EQ(fixture.strokes().size(), 2u);
    EXPECT_EQ(tip_point(*fixture.strokes()[1], kStart), (Point{50, 0}));
  }
}

TEST(ConnectInk, LockedAndOtherLayersAreNotChanged) {
  Fixture fixture;
  const StrokeId old = fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
  fixture.apply({"Layer", {}, {{{2}, std::nullopt, LayerState{"Top"}, 0, 1}}});
  fixture.layer = {2};
  run(fixture, straight_stroke({51, 1}, {90, 40}, 1, 1), {.start = TipId{old, kEnd}});
  EXPECT_EQ(fixture.strokes().size(), 2u);
  EXPECT_EQ(tip_point(*fixture.strokes()[1], kStart), (Point{50, 0}));
  fixture.layer = {1};
  fixture.apply({"Lock", {}, {{{1}, LayerState{"Ink"}, LayerState{"Ink", true, true}, 0, 0}}});
  run(fixture, straight_stroke({-1, 1}, {-40, 40}, 1, 1), {.start = TipId{old, kStart}});
  EXPECT_EQ(*fixture.document.find(old), straight_stroke({0, 0}, {50, 0}, 1, 1));
}

TEST(ConnectInk, WhatCannotBeConnectedIsStillInk) {
  Fixture fixture;
  const StrokeId old = fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
  const Stroke dot = straight_stroke({51, 0}, {51.05, 0}, 1, 1);
  run(fixture, dot, {.start = TipId{old, kEnd}});  // too short to reach
  run(fixture, dot, {.closes = true});
  run(fixture, dot, {.start = TipId{{77}, kEnd}, .end = TipId{{78}, kStart}});  // do not exist
  run(fixture, dot, {.start = TipId{old, kEnd}, .end = TipId{old, kEnd}});
  ASSERT_EQ(fixture.strokes().size(), 5u);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_EQ(*fixture.strokes()[i], dot);
}

}  // namespace
}  // namespace felt::connect_ink_test
