#include "felt/tools/pull/nib_push.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "felt/geometry/nearest.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/stroke/testing/stroke_probe.h"

namespace felt::nib_push_test {
namespace {

using testing::length_of;
using testing::random_stroke;
using testing::RandomStroke;
using testing::share;

constexpr double kRadius = 3.0;

/// Returns a smooth line of n segments along x with waves of this height.
StrokePtr line(int n, double segment_mm, double wave_mm = 0.0) {
  StrokeData d;
  d.points.push_back({0, 0});
  for (int k = 0; k < n; ++k) {
    const double x = segment_mm * k, y = k % 2 == 0 ? wave_mm : -wave_mm;
    d.points.insert(
        d.points.end(),
        {{x + segment_mm / 3.0, y}, {x + 2.0 * segment_mm / 3.0, y}, {x + segment_mm, 0}});
    if (k > 0) d.joints.push_back(JointKind::kSmooth);
  }
  d.widths = {{0.0, 1.0}, {static_cast<double>(n), 1.0}};
  return share(Stroke::create(d).value());
}

struct Near {
  double distance_mm = std::numeric_limits<double>::infinity();
  Point point;
};

Near nearest_place(const Stroke& stroke, Point p) {
  Near best;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Nearest near = nearest(stroke.segment(i), p);
    const double d = std::sqrt(near.distance_squared);
    if (d < best.distance_mm) best = {d, near.point};
  }
  return best;
}

/// Moves along a polyline in samples `step_mm` apart and calls `check` after each.
template <class Check>
void go(NibPush& push, const std::vector<Point>& way, double step_mm, Check check) {
  Point last = way.front();
  push.move(last, last);
  check(last, false);
  for (std::size_t k = 1; k < way.size(); ++k) {
    const int steps =
        std::max(1, static_cast<int>(std::ceil(distance(way[k - 1], way[k]) / step_mm)));
    for (int i = 1; i <= steps; ++i) {
      const Point next = lerp(way[k - 1], way[k], static_cast<double>(i) / steps);
      const double before = nearest_place(*push.stroke(), next).distance_mm;
      const StrokePtr old = push.stroke();
      const bool moved = push.move(last, next);
      // Without contact, along the step or at its end, nothing moves.
      if (step_mm <= 0.5 * kRadius && before >= kRadius) {
        ASSERT_FALSE(moved);
      }
      if (!moved) {
        ASSERT_EQ(old, push.stroke());
      }
      check(next, moved);
      last = next;
    }
  }
}

TEST(NibPush, R27_ACrossingPartsTheLineAndNeverFlipsIt) {
  for (const double speed : {20.0, 200.0, 1000.0, 16'600.0}) {  // mm/s at 1 kHz; 1 m/s at 60 Hz
    for (const double x : {60.0, 55.3, 47.9, 36.0}) {
      for (const double wave : {0.0, 4.0}) {
        NibPush push(line(10, 12.0, wave), kRadius);
        go(push, {{x, -20}, {x, 25}}, 1e-3 * speed, [&](Point pen, bool) {
          const Near near = nearest_place(*push.stroke(), pen);
          ASSERT_GE(near.distance_mm, kRadius - 1e-6) << speed << ", " << x << ", " << pen.y;
          // The line is ahead of the pen: at the x of the pen, the y of the line is larger.
          const Near ahead = nearest_place(*push.stroke(), pen + Vec{0.0, kRadius});
          if (pen.y > -3.0) {
            ASSERT_GT(ahead.point.y, pen.y);
          }
        });
        // The straight line of 120 mm now goes around the pen, 28 mm away, so it is at least 137 mm
        // long.
        if (wave == 0.0) {
          EXPECT_LT(length_of(*push.stroke()), 150.0);
        }
      }
    }
  }
}

TEST(NibPush, R27_StrokesOfEveryShapeKeepClearOfTheNib) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    const StrokePtr stroke = share(random_stroke(seed));
    RandomStroke random(seed + 27);
    const auto place = [&] { return Point{random.uniform(-5, 25), random.uniform(-5, 25)}; };
    NibPush push(stroke, kRadius);
    go(push, {place(), place(), place()}, 0.4, [&](Point pen, bool) {
      ASSERT_GE(nearest_place(*push.stroke(), pen).distance_mm, kRadius - 1e-6);
    });
  }
}

TEST(NibPush, R27_NeverPulls) {
  NibPush push(line(10, 12.0), kRadius);
  go(push, {{60, -20}, {60, 5}}, 0.5, [](Point, bool) {});
  const StrokePtr parted = push.stroke();
  EXPECT_NEAR(nearest_place(*parted, {60, 20}).point.y, 8.0, 1e-6);
  // Nothing moves when the nib leaves, on any path through the dent.
  go(push, {{60, 5}, {60, -20}, {90, -20}}, 0.5, [&](Point, bool moved) { ASSERT_FALSE(moved); });
  EXPECT_EQ(push.stroke(), parted);
}

TEST(NibPush, R27_StridesJumpOverNothing) {
  // The nib moves 500 mm in one sample, which would take too many steps of less than half a radius.
  for (const double x : {60.0, 47.3, 12.0}) {
    NibPush push(line(10, 12.0), kRadius);
    push.move({x, -450}, {x, -450});
    EXPECT_TRUE(push.move({x, -450}, {x, 50}));
    EXPECT_GE(nearest_place(*push.stroke(), {x, 50}).distance_mm, kRadius - 1e-6);
    EXPECT_GT(nearest_place(*push.stroke(), {x, 80}).point.y, 52.9);
  }
  EXPECT_TRUE(nib_meets(line(1, 120.0)->segment(0), {60, -450}, {60, 50}, kRadius));
  EXPECT_FALSE(nib_meets(line(1, 120.0)->segment(0), {60, -450}, {60, -50}, kRadius));
}

TEST(NibPush, R27_LandingOnALinePartsItToTheSideAwayFromThePen) {
  for (const double side : {-1.0, 1.0}) {
    NibPush push(line(10, 12.0), kRadius);
    ASSERT_TRUE(push.move({50, 0}, {50, 0}, {0.0, side}));  // the pen came from the side `side`
    EXPECT_NEAR(nearest_place(*push.stroke(), {50, -5.0 * side}).point.y, -kRadius * side, 1e-2);
  }
  NibPush push(line(10, 12.0), kRadius);  // without a direction, the line may move to either side
  ASSERT_TRUE(push.move({50, 0}, {50, 0}));
  EXPECT_GE(nearest_place(*push.stroke(), {50, 0}).distance_mm, kRadius - 1e-6);
}

TEST(NibPush, WhatIsFarFromTheNibStaysBitForBit) {
  const StrokePtr stroke = line(20, 12.0, 3.0);
  NibPush push(stroke, kRadius);
  go(push, {{120, -20}, {120, 2}}, 0.5, [](Point, bool) {});
  const Result<Stroke> done = push.finished({120, 2});
  ASSERT_TRUE(done);
  for (const Stroke& now : {*push.stroke(), *done}) {
    for (int i = 0; i < 5; ++i) {
      EXPECT_EQ(now.segment(i), stroke->segment(i));
      EXPECT_EQ(now.segment(now.segment_count() - 1 - i), stroke->segment(19 - i));
    }
  }
  EXPECT_LE(done->segment_count(), push.stroke()->segment_count());
}

TEST(NibPush, R27_ARimThatShutsTheNibInIsWidened) {
  // A closed drop of ink around the pen, smaller than the nib.
  const StrokePtr drop = share(Stroke::create({.points = {{10, 10}, {13, 10}, {10, 13}, {10, 10}},
                                               .joints = {JointKind::kCorner},
                                               .closed = true,
                                               .widths = {{0.0, 0.5}, {1.0, 0.5}}})
                                   .value());
  NibPush push(drop, kRadius);
  push.move({10.8, 10.8}, {10.8, 10.8});
  EXPECT_GE(nearest_place(*push.stroke(), {10.8, 10.8}).distance_mm, kRadius - 1e-6);
}

}  // namespace
}  // namespace felt::nib_push_test
