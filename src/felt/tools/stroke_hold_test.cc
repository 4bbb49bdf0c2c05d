#include "felt/tools/stroke_hold.h"

#include <gtest/gtest.h>

#include <cmath>

#include "felt/tools/testing/tool_fixture.h"

namespace felt::stroke_hold_test {
namespace {

using testing::Fixture;
using testing::RandomStroke;
using testing::straight_stroke;

/// A circle of four arcs around a point.
Stroke ring(Point c, double r) {
  const double k = 0.5522847498 * r;
  StrokeData d;
  d.points = {c + Vec{r, 0},  c + Vec{r, k},  c + Vec{k, r},   c + Vec{0, r},   c + Vec{-k, r},
              c + Vec{-r, k}, c + Vec{-r, 0}, c + Vec{-r, -k}, c + Vec{-k, -r}, c + Vec{0, -r},
              c + Vec{k, -r}, c + Vec{r, -k}, c + Vec{r, 0}};
  d.joints.assign(4, JointKind::kSmooth);
  d.closed = true;
  d.widths = {{0.0, 1.0}, {4.0, 1.0}};
  return Stroke::create(d).value();
}

TEST(StrokeHold, R20_NothingIsTakenFromAfarOrFromALockedLayer) {
  Fixture fixture;
  fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
  StrokeHold hold;
  EXPECT_FALSE(hold.take(fixture.scene(), {20, 8.1}));
  EXPECT_FALSE(hold.holds());
  EXPECT_TRUE(hold.take(fixture.scene(), {20, 7.9}));
  EXPECT_NEAR(hold.place().length_mm, 20.0, 1e-4);
  const Layer* layer = fixture.document.layer(fixture.layer);
  LayerState locked = layer->state();
  locked.locked = true;
  fixture.apply({"Lock", {}, {{fixture.layer, layer->state(), locked, 0, 0}}});
  EXPECT_FALSE(hold.take(fixture.scene(), {20, 1}));
  EXPECT_FALSE(hold.holds());
}

TEST(StrokeHold, FollowsTheBranchItHoldsWhereAStrokePassesItself) {
  // The stroke goes out and back, 2 mm apart. The pen comes nearer to the second branch but stays
  // on the first.
  StrokeData d;
  d.points = {{0, 0},  {20, 0}, {40, 0}, {60, 0}, {70, 0},
              {70, 2}, {60, 2}, {40, 2}, {20, 2}, {0, 2}};
  d.joints = {JointKind::kSmooth, JointKind::kSmooth};
  d.widths = {{0.0, 1.0}, {3.0, 1.0}};
  Fixture fixture;
  fixture.add(Stroke::create(d).value());
  StrokeHold hold;
  ASSERT_TRUE(hold.take(fixture.scene(), {10, 0}));
  double sum = 0.0;
  for (int i = 1; i <= 100; ++i) {
    ASSERT_TRUE(hold.follow(fixture.scene(), {10 + 0.2 * i, 0.015 * i}));
    sum += hold.way_mm().value();
  }
  EXPECT_NEAR(hold.place().point.x, 30.0, 1e-6);
  EXPECT_EQ(hold.place().point.y, 0.0);
  EXPECT_NEAR(sum, 20.0, 1e-3);
}

TEST(StrokeHold, AWayAcrossTheSeamIsAsShortAsItLooks) {
  Fixture fixture;
  fixture.add(ring({50, 50}, 10));
  StrokeHold hold;
  ASSERT_TRUE(hold.take(fixture.scene(), {60, 48}));
  double sum = 0.0;
  for (int i = 0; i <= 720; ++i) {
    const double a = (-0.2 + i * 3.14159265358979 / 180.0);
    ASSERT_TRUE(hold.follow(fixture.scene(), Point{50, 50} + 11.0 * Vec{std::cos(a), std::sin(a)}));
    if (i > 0) sum += hold.way_mm().value();
  }
  EXPECT_NEAR(sum, 2 * hold.map().length_mm(), 0.01);
}

TEST(StrokeHold, AwayItWaitsAndBackElsewhereItIsThere) {
  Fixture fixture;
  fixture.add(straight_stroke({0, 0}, {100, 0}, 1, 1));
  StrokeHold hold;
  ASSERT_TRUE(hold.take(fixture.scene(), {10, 0}));
  EXPECT_FALSE(hold.follow(fixture.scene(), {10, 30}));
  EXPECT_FALSE(hold.way_mm());
  EXPECT_NEAR(hold.place().length_mm, 10.0, 1e-3);
  EXPECT_TRUE(hold.follow(fixture.scene(), {90, 1}));
  EXPECT_FALSE(hold.way_mm());
  EXPECT_NEAR(hold.place().length_mm, 90.0, 1e-3);
  EXPECT_TRUE(hold.follow(fixture.scene(), {91, 1}));
  EXPECT_NEAR(hold.way_mm().value(), 1.0, 1e-3);
}

TEST(StrokeHold, IsAsNearAsAnyPlaceWithinTheWindow) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Fixture fixture;
    fixture.add(testing::random_stroke(seed));
    const Stroke& s = *fixture.strokes()[0];
    RandomStroke random(seed);
    StrokeHold hold;
    const double u = random.uniform(0.0, s.segment_count());
    if (!hold.take(fixture.scene(), s.position(u))) continue;
    const double from = hold.place().length_mm;
    const Point pen = s.position(u) + Vec{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    ASSERT_TRUE(hold.follow(fixture.scene(), pen));
    for (int i = -40; i <= 40; ++i) {
      double length = from + StrokeHold::kWindowMm / 40 * i;
      if (!s.closed()) length = std::clamp(length, 0.0, hold.map().length_mm());
      EXPECT_LE(distance(pen, hold.place().point),
                distance(pen, s.position(hold.map().u_at(length))) + 1e-3);
    }
  }
}

}  // namespace
}  // namespace felt::stroke_hold_test
