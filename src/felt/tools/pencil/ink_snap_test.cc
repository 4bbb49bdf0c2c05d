#include "felt/tools/pencil/ink_snap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "felt/tools/testing/tool_fixture.h"

namespace felt::ink_snap_test {
namespace {

using testing::arc;
using testing::Fixture;
using testing::straight_stroke;
using testing::way;
using testing::operator+;

const SnapOptions kOptions{.reach_mm = 3.0, .radius_mm = 1.5, .force_n = 0.3};

/// A pen that draws on a fixture at 1 kHz.
struct Line {
  Fixture& fixture;
  InkSnap snap = {};
  SnapOptions options = kOptions;
  std::int64_t now_ns = 0;
  int attracted = 0;  ///< samples with an attraction

  /// Draws along the points at this speed and slows down to rest over the last 4 mm.
  void draw(const std::vector<Point>& points, double mm_per_s = 60.0) {
    now_ns += 1'000'000;
    snap.begin(points.front(), now_ns, options, fixture.scene());
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double left = distance(points[i], points.back());
      const double speed = std::max(std::min(mm_per_s, 5.0 + 15.0 * left), 5.0);
      now_ns += static_cast<std::int64_t>(1e9 * distance(points[i - 1], points[i]) / speed);
      snap.update(points[i], now_ns, options, fixture.scene());
      attracted += snap.attraction() ? 1 : 0;
    }
  }
};

/// A circle with a gap before its end.
std::vector<Point> ring(double diameter, double gap_mm) {
  const double open_deg = 2.0 * std::asin(gap_mm / diameter) * 180.0 / std::numbers::pi;
  return arc({50, 50}, 0.5 * diameter, 0, 360 - open_deg);
}

TEST(InkSnap, R44_OutlinesOfThreeMillimetresAndMoreClose) {
  for (const double diameter : {3.0, 4.0, 6.0, 8.0, 16.0, 60.0}) {
    for (const double gap : {0.0, 0.5, 1.0, 1.5}) {
      Fixture fixture;
      Line line{fixture};
      line.draw(ring(diameter, gap));
      ASSERT_TRUE(line.snap.target()) << diameter << " " << gap;
      EXPECT_TRUE(line.snap.target()->is_own_start());
    }
  }
}

TEST(InkSnap, R44_ALineThatDoesNotGoAroundAnAreaNeverCloses) {
  const std::vector<std::vector<Point>> open = {
      way({0, 0}, {20, 0}) + way({20, 0}, {0.5, 0.2}),                   // there and back
      arc({50, 50}, 5, 0, 360 * 4 - 5),                                  // a coil
      way({0, 0}, {9, 1}) + way({9, 1}, {0, 2}) + way({0, 2}, {9, 3}) +  // a zigzag
          way({9, 3}, {0, 2}) + way({0, 2}, {9, 1}) + way({9, 1}, {0.4, 0.4}),
      arc({50, 50}, 0.8, 0, 350),  // a dot of 1.6 mm
  };
  for (std::size_t i = 0; i < open.size(); ++i) {
    Fixture fixture;
    Line line{fixture};
    line.draw(open[i]);
    EXPECT_FALSE(line.snap.target()) << i;
  }
}

TEST(InkSnap, R43_LinesOfAHatchingNeitherAttractNorSnap) {
  for (const double spacing : {0.3, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0}) {
    for (const bool back : {false, true}) {
      Fixture fixture;
      Line line{fixture};
      for (int i = 0; i < 12; ++i) {
        Point a{10 + 0.3 * (i % 3), 10 + spacing * i}, b{30 - 0.4 * (i % 2), 10 + spacing * i};
        if (back && i % 2 == 1) std::swap(a, b);
        line.draw(way(a, b));
        EXPECT_FALSE(line.snap.target()) << spacing;
        EXPECT_FALSE(line.snap.start_target()) << spacing;
        line.snap.end(fixture.add(straight_stroke(a, b, 1, 1)));
      }
      EXPECT_EQ(line.attracted, 0) << spacing;
    }
  }
}

TEST(InkSnap, R70_ATargetThatIsReachedLetsThePenGo) {
  Fixture fixture;
  fixture.add(straight_stroke({50, 50}, {50, 90}, 1, 1));
  Line slow{fixture};
  slow.draw(way({20, 50}, {49, 50}));
  ASSERT_TRUE(slow.snap.attraction());
  const auto rest = [&](Point pen) {
    for (int i = 0; i < 300; ++i) {
      slow.snap.update(pen, slow.now_ns += 1'000'000, kOptions, fixture.scene());
    }
  };
  rest({49, 50});
  EXPECT_TRUE(slow.snap.rests());
  rest({49.9, 50});
  EXPECT_FALSE(slow.snap.rests());
  rest({49, 50});
  ASSERT_TRUE(slow.snap.attraction());
  EXPECT_FALSE(slow.snap.rests()) << "it goes away again";
}

TEST(InkSnap, R70_APenRestsAfterItHasBeenSlowForAWhile) {
  Fixture fixture;
  fixture.add(straight_stroke({80, 50}, {80, 90}, 1, 1));
  InkSnap snap;
  std::int64_t now_ns = 0;
  Point pen{20, 50};
  const auto move = [&](double mm_per_s, int ms) {
    for (int i = 0; i < ms; ++i) {
      pen.x += 1e-3 * mm_per_s;
      snap.update(pen, now_ns += 1'000'000, kOptions, fixture.scene());
    }
  };
  snap.begin(pen, now_ns, kOptions, fixture.scene());
  move(100.0, 200);
  EXPECT_FALSE(snap.rests());
  move(10.0, 120);
  EXPECT_FALSE(snap.rests()) << "the end of a letter";
  move(10.0, 130);
  EXPECT_TRUE(snap.rests());
  move(40.0, 100);
  EXPECT_TRUE(snap.rests()) << "it is drawn to the target";
  move(100.0, 60);
  EXPECT_FALSE(snap.rests());
  move(0.0, 300);
  EXPECT_TRUE(snap.rests());
  snap.end(std::nullopt);
  EXPECT_FALSE(snap.rests());
}

TEST(InkSnap, R43_AnEndAttractsThePenThatComesToItSlowly) {
  Fixture fixture;
  const StrokeId id = fixture.add(straight_stroke({50, 50}, {50, 90}, 1, 1));
  Line slow{fixture};
  slow.draw(way({20, 50}, {49, 50}));
  ASSERT_TRUE(slow.snap.target());
  EXPECT_EQ(slow.snap.target()->tip, (TipId{id, StrokeTip::kStart}));
  ASSERT_TRUE(slow.snap.attraction());
  EXPECT_EQ(slow.snap.attraction()->point, (Point{50, 50}));
  // The pen is not attracted if it moves past the end, away from it, or fast.
  Line past{fixture};
  past.draw(way({20, 48}, {80, 48}));
  EXPECT_EQ(past.attracted, 0);
  Line away{fixture};
  away.draw(way({50, 50}, {20, 30}));
  EXPECT_EQ(away.attracted, 0);
  Line fast{fixture};
  fast.now_ns = 0;
  fast.snap.begin({20, 50}, 0, kOptions, fixture.scene());
  for (double x = 20; x < 49; x += 0.3) {
    fast.snap.update({x, 50}, fast.now_ns += 1'000'000, kOptions, fixture.scene());
    EXPECT_FALSE(fast.snap.attraction());
    EXPECT_FALSE(fast.snap.target());
  }
}

TEST(InkSnap, R44_ADotOrAShortLineThatIsDrawnOnDoesNotPullBack) {
  for (const double length : {0.2, 1.0, 3.0, 5.0}) {
    Fixture fixture;
    const Point end{50 + length, 50};
    const StrokeId id = fixture.add(straight_stroke({50, 50}, end, 1, 1));
    Line line{fixture};
    line.snap.end(id);
    line.draw(way(end, {90, 55}), 15.0);
    EXPECT_EQ(line.attracted, 0) << length;
    // A scribble around it does not close it.
    Line scribble{fixture};
    std::vector<Point> points{end};
    testing::RandomStroke random(3);
    for (int k = 0; k < 12; ++k) {
      points =
          points + way(points.back(), {50 + random.uniform(-4, 4), 50 + random.uniform(-4, 4)});
    }
    scribble.draw(points + way(points.back(), {50, 50}));
    const auto& target = scribble.snap.target();
    EXPECT_TRUE(!target || target->on_curve) << length;
  }
}

TEST(InkSnap, R44_ASecondLineClosesTheOutline) {
  for (const double diameter : {4.0, 8.0, 20.0}) {
    Fixture fixture;
    const Point center{50, 50};
    const double r = 0.5 * diameter;
    // Half of the circle as one cubic.
    StrokeData half = straight_stroke(center - Vec{r, 0}, center + Vec{r, 0}, 1, 1).data();
    half.points = {center - Vec{r, 0}, center + Vec{-r, -4.0 / 3 * r},
                   center + Vec{r, -4.0 / 3 * r}, center + Vec{r, 0}};
    const StrokeId id = fixture.add(*Stroke::create(half));
    Line line{fixture};
    line.draw(arc(center, r, 3, 170));
    ASSERT_TRUE(line.snap.target()) << diameter;
    EXPECT_EQ(line.snap.target()->tip, (TipId{id, StrokeTip::kStart}));
    ASSERT_TRUE(line.snap.start_target());
    EXPECT_EQ(line.snap.start_target()->tip, (TipId{id, StrokeTip::kEnd}));
  }
}

TEST(InkSnap, R43_ALineMayMeetTheMiddleOfAnother) {
  Fixture fixture;
  fixture.add(straight_stroke({50, 20}, {50, 90}, 1, 1));
  Line line{fixture};
  line.draw(way({20, 50}, {49.7, 50}));
  ASSERT_TRUE(line.snap.target());
  EXPECT_TRUE(line.snap.target()->on_curve);
  EXPECT_LE(distance(line.snap.target()->point, {50, 50}), 0.01);
  EXPECT_TRUE(line.snap.attraction());
  Line from{fixture};
  from.draw(way({50.3, 50}, {80, 50}));
  ASSERT_TRUE(from.snap.start_target());
  EXPECT_TRUE(from.snap.start_target()->on_curve);
  // The pen is not attracted across a hatching.
  for (int i = 1; i < 6; ++i)
    fixture.add(straight_stroke({50 - 1.5 * i, 20}, {50 - 1.5 * i, 90}, 1, 1));
  Line across{fixture};
  across.draw(way({20, 50}, {49.7, 50}));
  EXPECT_FALSE(across.snap.target());
  EXPECT_EQ(across.attracted, 0);
}

TEST(InkSnap, R43_ALineMayMeetAClosedCurve) {
  Fixture fixture;
  StrokeData ring = straight_stroke({40, 50}, {60, 50}, 1, 1).data();
  const double h = 40.0 / 3;  // two arches, joined where the line is about to meet them
  ring.points = {{40, 50},     {40, 50 - h}, {60, 50 - h}, {60, 50},
                 {60, 50 + h}, {40, 50 + h}, {40, 50}};
  ring.joints = {JointKind::kSmooth, JointKind::kSmooth};
  ring.closed = true;
  ring.widths = {{0, 1}, {2, 1}};
  const Stroke closed = Stroke::create(ring).value();
  const StrokeId id = fixture.add(closed);
  for (const double u : {0.0, 0.3, 1.5, 1.9}) {
    const Point at = closed.position(u);
    const Vec out = normalized(at - Point{50, 50});
    Line line{fixture};
    line.draw(way(at + 30.0 * out, at + 0.4 * out));
    ASSERT_TRUE(line.snap.target()) << u;
    EXPECT_TRUE(line.snap.target()->on_curve) << u;
    EXPECT_EQ(line.snap.target()->tip.stroke, id);
    EXPECT_LE(distance(line.snap.target()->point, at), 0.2) << u;
    Line from{fixture};
    from.draw(way(at + 0.4 * out, at + 30.0 * out));
    ASSERT_TRUE(from.snap.start_target()) << u;
    EXPECT_LE(distance(from.snap.start_target()->point, at), 0.2) << u;
  }
}

TEST(InkSnap, R44_ATremblingPenAtRestDoesNotTravel) {
  Fixture fixture;
  Line line{fixture};
  testing::RandomStroke random(1);
  line.draw(way({0, 0}, {8, 0}));
  for (int k = 0; k < 20000; ++k) {
    line.snap.update({8 + random.uniform(-.03, .03), random.uniform(-.03, .03)},
                     line.now_ns += 1'000'000, kOptions, fixture.scene());
    ASSERT_FALSE(line.snap.target());
  }
}

}  // namespace
}  // namespace felt::ink_snap_test
