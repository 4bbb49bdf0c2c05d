#include "felt/tools/connect/connect_ends.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "felt/tools/testing/tool_fixture.h"

namespace felt::connect_ends_test {
namespace {

using testing::Fixture;
using testing::RandomStroke;
using testing::straight_stroke;

using enum StrokeTip;
constexpr MeetingPlace kPlaces[] = {MeetingPlace::kAtTarget, MeetingPlace::kHalfWay};

Stroke with_look(const Stroke& stroke, Rgba color, std::string material = "pencil") {
  StrokeData data = stroke.data();
  data.color = color;
  data.medium = std::move(material);
  return Stroke::create(data).value();
}

TEST(ConnectEnds, R45_JoinsAtAnyOfTheFourPairsOfEnds) {
  for (const StrokeTip tip : {kStart, kEnd}) {
    for (const StrokeTip mine : {kStart, kEnd}) {
      for (const MeetingPlace place : kPlaces) {
        Fixture fixture;
        const StrokeId moved = fixture.add(mine == kEnd ? straight_stroke({0, 60}, {52, 2}, 1, 2)
                                                        : straight_stroke({52, 2}, {0, 60}, 2, 1));
        const StrokeId below = fixture.add(straight_stroke({0, 90}, {9, 90}, 1, 1));
        const StrokeId to = fixture.add(tip == kEnd ? straight_stroke({0, 0}, {50, 0}, 1, 2)
                                                    : straight_stroke({50, 0}, {0, 0}, 2, 1));
        const Document before = fixture.document;
        const Edit edit = connect_ends(fixture.document, {moved, mine}, {to, tip}, {place});
        EXPECT_EQ(edit.label, "Connect");
        fixture.apply(edit);
        ASSERT_EQ(fixture.strokes().size(), 2u);
        EXPECT_EQ(fixture.document.layers()[0].strokes[0], below);
        EXPECT_EQ(fixture.document.layers()[0].strokes[1], to);  // its id and position in the layer
        const Stroke& one = *fixture.document.find(to);
        EXPECT_FALSE(one.closed());
        EXPECT_EQ(tip_point(one, opposite(tip)), (Point{0, 0}));  // its direction
        EXPECT_EQ(tip_point(one, tip), (Point{0, 60}));
        EXPECT_EQ(one.width_mm(0), 1.0);
        const Point meet = place == MeetingPlace::kAtTarget ? Point{50, 0} : Point{51, 1};
        bool met = false;
        for (int j = 1; j < one.segment_count(); ++j) {
          met = met || (one.position(j) == meet && one.joint(j) == JointKind::kCorner);
        }
        EXPECT_TRUE(met);
        fixture.undo();
        EXPECT_EQ(fixture.document, before);
      }
    }
  }
}

TEST(ConnectEnds, R45_SmoothBelowThirtyDegreesElseCorner) {
  for (const double deg : {10.0, 29.0, 31.0, 90.0}) {
    for (const MeetingPlace place : kPlaces) {
      Fixture fixture;
      const StrokeId to = fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
      const double a = deg * std::numbers::pi / 180;
      const Point near{51, 1};
      const Point far = near + 80 * Vec{std::cos(a), std::sin(a)};
      const StrokeId moved = fixture.add(straight_stroke(near, far, 1, 1));
      fixture.apply(connect_ends(fixture.document, {moved, kStart}, {to, kEnd}, {place}));
      ASSERT_EQ(fixture.strokes().size(), 1u);
      const Stroke& one = *fixture.document.find(to);
      const Point meet = place == MeetingPlace::kAtTarget ? Point{50, 0} : Point{50.5, 0.5};
      int joint = 0;
      for (int j = 1; j < one.segment_count(); ++j) joint = one.position(j) == meet ? j : joint;
      ASSERT_GT(joint, 0);
      EXPECT_EQ(one.joint(joint), deg < 30 ? JointKind::kSmooth : JointKind::kCorner) << deg;
    }
  }
}

TEST(ConnectEnds, R43_TheTwoEndsOfAStrokeCloseIt) {
  const Stroke open = Stroke::create({.points = {{0, 0}, {60, 0}, {60, 60}, {3, 4}},
                                      .joints = {},
                                      .closed = false,
                                      .widths = {{0, 1}, {1, 2}}})
                          .value();
  for (const StrokeTip mine : {kStart, kEnd}) {
    for (const MeetingPlace place : kPlaces) {
      Fixture fixture;
      const StrokeId id = fixture.add(open);
      // A stroke is closed even if other strokes are kept separate.
      const Edit edit = connect_ends(fixture.document, {id, mine}, {id, opposite(mine)},
                                     {place, /*keep_separate=*/true});
      EXPECT_EQ(edit.label, "Close");
      fixture.apply(edit);
      const Stroke& ring = *fixture.document.find(id);
      EXPECT_TRUE(ring.closed());
      const Point meet = place == MeetingPlace::kHalfWay ? Point{1.5, 2}
                         : mine == kEnd                  ? Point{0, 0}
                                                         : Point{3, 4};
      EXPECT_EQ(ring.position(0), meet);
    }
  }
}

TEST(ConnectEnds, OtherLooksLayersAndKeptSeparateShareThePoint) {
  const Stroke a = straight_stroke({51, 1}, {90, 40}, 1, 1),
               b = straight_stroke({0, 0}, {50, 0}, 1, 1);
  const std::vector<std::pair<Stroke, bool>> cases = {
      {with_look(a, {7, 0, 0, 255}), false}, {with_look(a, {}, "chalk"), false}, {a, true}};
  for (const auto& [moved_stroke, keep] : cases) {
    for (const MeetingPlace place : kPlaces) {
      Fixture fixture;
      const StrokeId to = fixture.add(b), moved = fixture.add(moved_stroke);
      fixture.apply(connect_ends(fixture.document, {moved, kStart}, {to, kEnd}, {place, keep}));
      ASSERT_EQ(fixture.strokes().size(), 2u);
      const Stroke &one = *fixture.document.find(moved), &two = *fixture.document.find(to);
      EXPECT_EQ(tip_point(one, kStart), tip_point(two, kEnd));
      EXPECT_EQ(one.color(), moved_stroke.color());
      EXPECT_EQ(one.medium(), moved_stroke.medium());
      if (place == MeetingPlace::kAtTarget) {
        EXPECT_EQ(two, b);
      }
      // The second time nothing changes.
      EXPECT_TRUE(
          connect_ends(fixture.document, {moved, kStart}, {to, kEnd}, {place, keep}).empty());
    }
  }
}

TEST(ConnectEnds, LockedAndHiddenLayersAreNotChanged) {
  for (const bool hidden : {false, true}) {
    Fixture fixture;
    const StrokeId to = fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
    fixture.apply({"Layer", {}, {{{2}, std::nullopt, LayerState{"Top"}, 0, 1}}});
    fixture.layer = {2};
    const StrokeId moved = fixture.add(straight_stroke({51, 1}, {90, 40}, 1, 1));
    fixture.apply(
        {"State", {}, {{{1}, LayerState{"Ink"}, LayerState{"Ink", !hidden, !hidden}, 0, 0}}});
    for (const MeetingPlace place : kPlaces) {
      EXPECT_TRUE(connect_ends(fixture.document, {to, kEnd}, {moved, kStart}, {place}).empty());
      const Edit edit = connect_ends(fixture.document, {moved, kStart}, {to, kEnd}, {place});
      fixture.apply(edit);
      EXPECT_EQ(tip_point(*fixture.document.find(moved), kStart), (Point{50, 0}));
      EXPECT_EQ(*fixture.document.find(to), straight_stroke({0, 0}, {50, 0}, 1, 1));
      fixture.undo();
    }
  }
}

/// Returns the length, in mm, over which the ink of the end `moved` is parallel to the target
/// stroke within 0.3 mm.
double doubled_mm(const Stroke& one, const Stroke& target) {
  double length = 0.0;
  for (double u = 0.0; u < one.segment_count(); u += 0.005) {
    const Point p = one.position(u);
    double nearest = 1e9;
    for (double v = 0.0; v <= target.segment_count(); v += 0.002) {
      nearest = std::min(nearest, distance(p, target.position(v)));
    }
    if (nearest <= 0.3) length += distance(p, one.position(u + 0.005));
  }
  return length;
}

TEST(ConnectEnds, R45_AWideGapIsBridgedByOneFairCurve) {
  const Stroke left = straight_stroke({0, 0}, {80, 0}, 1, 1);
  const std::pair<Point, Point> targets[] = {
      {{140, 0}, {220, 0}},    // 60 mm ahead
      {{140, 15}, {220, 15}},  // and sideways
      {{80, 60}, {0, 60}},     // a U
      {{80, 60}, {160, 60}},   // an S
      {{100, 30}, {100, 90}},  // around the corner
      {{100, 3}, {180, 3}},    // 20 mm ahead and slightly sideways
      {{80, 20}, {160, 30}},   // 20 mm sideways
  };
  for (const auto& [from, to] : targets) {
    for (const MeetingPlace place : kPlaces) {
      Fixture fixture;
      const StrokeId moved = fixture.add(left);
      const StrokeId other = fixture.add(straight_stroke(from, to, 1, 1));
      const Document before = fixture.document;
      fixture.apply(connect_ends(fixture.document, {moved, kEnd}, {other, kStart}, {place}));
      ASSERT_EQ(fixture.strokes().size(), 1u);
      const Stroke& one = *fixture.strokes()[0];
      EXPECT_EQ(tip_point(one, kStart), (Point{0, 0})) << from.x << " " << from.y;
      EXPECT_EQ(tip_point(one, kEnd), to);
      const Vec chord = from - Point{80, 0}, on = to - from;
      const double needed = angle_between({1, 0}, chord) + angle_between(chord, on);
      double turn = 0.0;
      Vec last{1, 0};
      for (int i = 0; i < one.segment_count(); ++i) {
        if (i > 0) {
          EXPECT_EQ(one.joint(i), JointKind::kSmooth) << from.x << " " << from.y;
        }
        for (int k = 0; k <= 200; ++k) {
          const Vec t = tangent(one.segment(i), k / 200.0);
          turn += angle_between(last, t);
          last = t;
        }
      }
      EXPECT_LE(turn, 1.6 * needed + 0.1) << from.x << " " << from.y;
      if (place == MeetingPlace::kAtTarget) {
        EXPECT_LE(doubled_mm(one, straight_stroke(from, to, 1, 1)), norm(on) + 5.0);
      }
      fixture.undo();
      EXPECT_EQ(fixture.document, before);
    }
  }
}

TEST(ConnectEnds, R43_AWideGapOfARingIsClosedRound) {
  // Three quarters of a circle with radius 30 mm.
  const double k = 30.0 * 0.5522847498;
  const Stroke arc = Stroke::create({.points = {{30, 0},
                                                {30, k},
                                                {k, 30},
                                                {0, 30},
                                                {-k, 30},
                                                {-30, k},
                                                {-30, 0},
                                                {-30, -k},
                                                {-k, -30},
                                                {0, -30}},
                                     .joints = {JointKind::kSmooth, JointKind::kSmooth},
                                     .closed = false,
                                     .widths = {{0, 1}, {3, 1}}})
                         .value();
  for (const StrokeTip mine : {kStart, kEnd}) {
    for (const MeetingPlace place : kPlaces) {
      Fixture fixture;
      const StrokeId id = fixture.add(arc);
      fixture.apply(connect_ends(fixture.document, {id, mine}, {id, opposite(mine)}, {place}));
      const Stroke& ring = *fixture.document.find(id);
      ASSERT_TRUE(ring.closed());
      for (double u = 0; u < ring.segment_count(); u += 0.01) {
        EXPECT_NEAR(norm(ring.position(u) - Point{0, 0}), 30.0, 4.0) << u;
      }
    }
  }
}

TEST(ConnectEnds, WhatIsNotThereIsLeftAlone) {
  Fixture fixture;
  const StrokeId a = fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
  EXPECT_TRUE(connect_ends(fixture.document, {a, kEnd}, {a, kEnd}).empty());
  EXPECT_TRUE(connect_ends(fixture.document, {a, kEnd}, {{77}, kEnd}).empty());
  EXPECT_TRUE(connect_ends(fixture.document, {{77}, kEnd}, {a, kEnd}).empty());
}

TEST(ConnectEnds, RandomEndsKeepAllInvariantsAndUndo) {
  int connected = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    RandomStroke random(seed);
    Fixture fixture;
    std::vector<TipId> tips;
    for (int k = 0; k < 3; ++k) {
      const Stroke s = Stroke::create(random.make()).value();
      const bool closed = s.closed();
      const StrokeId id = fixture.add(with_look(s, {}));
      if (!closed) tips.insert(tips.end(), {{id, kStart}, {id, kEnd}});
    }
    if (tips.size() < 2) continue;
    const int last = static_cast<int>(tips.size()) - 1;
    const TipId a = tips[static_cast<std::size_t>(random.pick(0, last))];
    const TipId b = tips[static_cast<std::size_t>(random.pick(0, last))];
    const Document before = fixture.document;
    const Edit edit =
        connect_ends(fixture.document, a, b,
                     {random.chance(0.5) ? MeetingPlace::kAtTarget : MeetingPlace::kHalfWay,
                      random.chance(0.2)});
    if (edit.empty()) continue;
    ++connected;
    fixture.apply(edit);
    for (const StrokePtr& s : fixture.strokes()) {
      ASSERT_TRUE(check_invariants(s->data())) << seed;
    }
    fixture.undo();
    ASSERT_EQ(fixture.document, before) << seed;
  }
  EXPECT_GT(connected, 200);
}

}  // namespace
}  // namespace felt::connect_ends_test
