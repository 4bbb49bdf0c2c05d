#include "felt/motion/stroke_blend.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/geometry/affine.h"
#include "felt/geometry/polyline.h"
#include "felt/motion/oriented_pair.h"
#include "felt/motion/stroke_shape.h"
#include "felt/stroke/edit/split.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::stroke_blend_test {
namespace {

/// Returns a smooth stroke through points, as a Catmull-Rom spline.
Stroke smooth_stroke(std::vector<Point> via, bool closed) {
  StrokeData data;
  data.closed = closed;
  const std::size_t n = via.size();
  const auto at = [&](std::ptrdiff_t i) {
    const auto count = static_cast<std::ptrdiff_t>(n);
    if (closed) return via[static_cast<std::size_t>((i + count) % count)];
    return via[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, count - 1))];
  };
  const auto slope = [&](std::ptrdiff_t i) { return (at(i + 1) - at(i - 1)) / 6.0; };
  const auto last = static_cast<std::ptrdiff_t>(closed ? n : n - 1);
  data.points.push_back(via.front());
  for (std::ptrdiff_t i = 0; i < last; ++i) {
    data.points.insert(data.points.end(), {at(i) + slope(i), at(i + 1) - slope(i + 1), at(i + 1)});
    if (i > 0) data.joints.push_back(JointKind::kSmooth);
  }
  if (closed) data.joints.push_back(JointKind::kSmooth);
  data.widths = {{0.0, 0.5}, {static_cast<double>(last), 1.0}};
  return Stroke::create(std::move(data)).value();
}

Stroke mapped_stroke(const Stroke& stroke, const Affine& map) {
  StrokeData data = stroke.data();
  for (Point& p : data.points) p = apply(map, p);
  return Stroke::create(std::move(data)).value();
}

/// Returns a lobed ring.
Stroke ring(std::uint64_t seed, double first_rad, int count) {
  Random random(seed);
  const double lobe = random.between(0.05, 0.35), phase = random.between(0.0, kTau);
  std::vector<Point> via;
  for (int i = 0; i < count; ++i) {
    const double a = first_rad + kTau * i / count;
    const double radius = 20.0 * (1.0 + lobe * std::sin(3.0 * a + phase));
    via.push_back({100.0 + radius * std::cos(a), 100.0 + radius * std::sin(a)});
  }
  return smooth_stroke(via, true);
}

/// Returns a wavy line along a direction.
Stroke wave(std::uint64_t seed, int count) {
  Random random(seed);
  const double height = random.between(1.0, 8.0), pace = random.between(0.1, 0.9);
  std::vector<Point> via;
  for (int i = 0; i < count; ++i) {
    const double x = 60.0 * i / (count - 1);
    via.push_back({20.0 + x, 50.0 + height * std::sin(pace * x / 5.0)});
  }
  return smooth_stroke(via, false);
}

Stroke stroke_at(const Stroke& a, const Stroke& b, double t) {
  const StrokeBlend blend(a, b, {});
  BlendPose pose;
  blend.pose(t, pose);
  Result<Stroke> stroke = blend.stroke(t, pose);
  EXPECT_TRUE(stroke) << (stroke ? "" : stroke.error().message);
  return *std::move(stroke);
}

/// Returns the largest distance of points of `a` from `b`.
double apart(const Stroke& a, const Stroke& b) {
  const std::vector<Point> line = coarse_line(b);
  double most = 0.0;
  for (const Point p : coarse_line(a)) {
    most = std::max(most, std::sqrt(nearest_on_polyline(line, p).distance_squared));
  }
  return most;
}

/// Returns the sum of the turns of a closed line.
double turning(const std::vector<Point>& line) {
  double sum = 0.0;
  const std::size_t n = line.size() - 1;  // the last point is the first one
  for (std::size_t i = 0; i < n; ++i) {
    const Vec in = line[i] - line[(i + n - 1) % n], out = line[i + 1] - line[i];
    sum += std::atan2(cross(in, out), dot(in, out));
  }
  return sum;
}

RC_GTEST_PROP(StrokeBlend, IsAValidStrokeBetweenAnyTwo, ()) {
  const auto a_seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto b_seed = *rc::gen::arbitrary<std::uint64_t>();
  const double t = *rc::gen::inRange(0, 1001) / 1000.0;
  const Stroke a = testing::random_stroke(a_seed), b = testing::random_stroke(b_seed);
  StrokeMatch match;
  match.from = match.to = 0;
  match.reversed = *rc::gen::arbitrary<bool>();
  const auto pair = oriented_pair(a, b, match, {});
  RC_ASSERT(pair.has_value());
  const StrokeBlend blend(pair->a, pair->b, {});
  BlendPose pose;
  blend.pose(t, pose);
  const Result<Stroke> stroke = blend.stroke(t, pose);
  RC_ASSERT(stroke.has_value());
  RC_ASSERT(check_invariants(stroke->data()).has_value());
  const Rect box = stroke->bounds();
  RC_ASSERT(box.x0 > -300.0 && box.y0 > -300.0 && box.x1 < 300.0 && box.y1 < 300.0);
}

RC_GTEST_PROP(StrokeBlend, StartsAsTheFirstAndEndsAsTheSecondStroke, ()) {
  const auto a_seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto b_seed = *rc::gen::arbitrary<std::uint64_t>();
  StrokeData a_data = testing::RandomStroke(a_seed).make(),
             b_data = testing::RandomStroke(b_seed).make();
  if (a_data.closed != b_data.closed) return;
  const Stroke a = Stroke::create(a_data).value(), b = Stroke::create(b_data).value();
  const StrokeBlend blend(a, b, {{3.0, 4.0}, {9.0, 2.0}, 0.7, 1.3});
  BlendPose pose;
  for (const bool is_end : {false, true}) {
    const Stroke& key = is_end ? b : a;
    blend.pose(is_end ? 1.0 : 0.0, pose);
    for (int i = 0; i <= 50; ++i) {
      const double u = key.segment_count() * i / 50.0;
      const double v = is_end ? blend.parameter_of_b(u) : blend.parameter_of_a(u);
      // The handles of smooth joints may differ by the tolerance of their invariant.
      RC_ASSERT(distance(StrokeBlend::position(pose, v), key.position(u)) < 1e-6);
    }
  }
}

TEST(StrokeBlend, RingsNeverTurnInsideOut) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Stroke a = ring(seed, random.between(0.0, kTau), 7 + static_cast<int>(seed % 6));
    const Affine map = then(rotation(random.between(-1.2, 1.2), {100.0, 100.0}),
                            scaling(random.between(0.6, 1.6)));
    Stroke b = mapped_stroke(ring(seed + 1000, random.between(0.0, kTau), 9), map);
    if (seed % 2 == 1) b = reversed(b);
    StrokeMatch match;
    match.from = match.to = 0;
    const auto pair = oriented_pair(a, b, match, {});
    ASSERT_TRUE(pair);
    const double a_area = area(coarse_line(pair->a)), b_area = area(coarse_line(pair->b));
    for (int i = 1; i < 12; ++i) {
      const Stroke between = stroke_at(pair->a, pair->b, i / 12.0);
      ASSERT_TRUE(between.closed());
      const double now = area(coarse_line(between));
      EXPECT_GT(now * a_area, 0.0);
      EXPECT_GT(std::fabs(now), 0.8 * std::min(std::fabs(a_area), std::fabs(b_area)));
      // Between lobes at different places it is rounder, and so larger.
      EXPECT_LT(std::fabs(now), 1.4 * std::max(std::fabs(a_area), std::fabs(b_area)));
      EXPECT_NEAR(std::fabs(turning(coarse_line(between))), kTau, 1e-6) << "once around";
    }
  }
}

TEST(StrokeBlend, NoTurnLeavesTheRangeOfBothStrokes) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Stroke a = wave(seed, 5 + static_cast<int>(seed % 7));
    const Stroke b =
        mapped_stroke(wave(seed + 500, 8), rotation(random.between(-1.5, 1.5), {50.0, 50.0}));
    const StrokeBlend blend(a, b, {});
    BlendPose poses[3];
    blend.pose(0.0, poses[0]);
    blend.pose(1.0, poses[2]);
    for (int i = 1; i < 8; ++i) {
      BlendPose& now = poses[1];
      blend.pose(i / 8.0, now);
      for (std::size_t k = 1; k < now.directions.size(); ++k) {
        const auto turn = [k](const BlendPose& pose) {
          const Vec in = pose.directions[k - 1], out = pose.directions[k];
          return std::atan2(cross(in, out), dot(in, out));
        };
        const auto [low, high] = std::minmax({turn(poses[0]), turn(poses[2])});
        EXPECT_GE(turn(now), low - 1e-7);
        EXPECT_LE(turn(now), high + 1e-7);
        const auto [shorter, longer] = std::minmax({poses[0].lengths[k], poses[2].lengths[k]});
        EXPECT_GE(now.lengths[k], shorter - 1e-9);
        EXPECT_LE(now.lengths[k], longer + 1e-9);
      }
    }
  }
}

TEST(StrokeBlend, AStrokeThatTurnsKeepsItsShape) {
  const Stroke a = wave(4, 9);
  const Affine map = then(rotation(2.5, {50.0, 50.0}), translation({30.0, -10.0}));
  const Stroke b = mapped_stroke(a, map);
  for (int i = 1; i < 8; ++i) {
    const Stroke between = stroke_at(a, b, i / 8.0);
    EXPECT_NEAR(shape_of(between).length_mm, shape_of(a).length_mm, 0.01);
    const Stroke upright = mapped_stroke(between, rotation(-2.5 * i / 8.0));
    const Vec shift = shape_of(a).centre - shape_of(upright).centre;
    EXPECT_LT(apart(mapped_stroke(upright, translation(shift)), a), 0.02);
  }
}

TEST(StrokeBlend, ASmallLoopDoesNotTurnTheRestOfTheLine) {
  // A straight line, and one with a small loop in its middle.
  std::vector<Point> plain, looped;
  for (int i = 0; i <= 12; ++i) plain.push_back({5.0 * i, 0.0});
  for (int i = 0; i <= 6; ++i) looped.push_back({5.0 * i, 0.0});
  for (int i = 1; i < 8; ++i) {
    const double a = kTau * i / 8.0;
    looped.push_back({30.0 + 1.5 * std::sin(a) + 0.2 * i, 1.5 - 1.5 * std::cos(a)});
  }
  for (int i = 7; i <= 12; ++i) looped.push_back({5.0 * i, 0.0});
  const Stroke between = stroke_at(smooth_stroke(looped, false), smooth_stroke(plain, false), 0.5);
  const Rect box = between.bounds();
  EXPECT_LT(box.height(), 6.0) << "the line folds over";
  EXPECT_GT(box.width(), 55.0);
}

TEST(StrokeBlend, CornersStayOnCorners) {
  const auto bent = [](double first_mm, double second_mm) {
    StrokeData data;
    const Cubic in = straight({0, 0}, {first_mm, 0}),
                out = straight({first_mm, 0}, {first_mm, second_mm});
    data.points = {in.p[0], in.p[1], in.p[2], in.p[3], out.p[1], out.p[2], out.p[3]};
    data.joints = {JointKind::kCorner};
    data.widths = {{0.0, 0.5}, {2.0, 0.5}};
    return Stroke::create(std::move(data)).value();
  };
  const Stroke between = stroke_at(bent(30, 20), bent(20, 30), 0.5);
  ASSERT_EQ(between.segment_count(), 2) << "both corners are one joint";
  EXPECT_EQ(between.joint(1), JointKind::kCorner);
  EXPECT_NEAR(distance(between.position(0.0), between.position(1.0)), 25.0, 1e-9);
  EXPECT_NEAR(distance(between.position(1.0), between.position(2.0)), 25.0, 1e-9);
}

TEST(StrokeBlend, WidthToneAndColourChangeEvenly) {
  Stroke a = testing::straight_stroke({0, 0}, {10, 0}, 1.0, 2.0);
  StrokeData data = testing::straight_stroke({0, 5}, {10, 5}, 3.0, 1.0).data();
  data.color = {200, 100, 50, 255};
  data.medium = "chalk";
  data.widths = {{0.0, 3.0, 0.2}, {1.0, 1.0, 0.6}};
  const Stroke b = Stroke::create(data).value();
  const Stroke between = stroke_at(a, b, 0.25);
  EXPECT_NEAR(between.width_mm(0.0), 1.5, 1e-12);
  EXPECT_NEAR(between.width_mm(1.0), 1.75, 1e-12);
  EXPECT_NEAR(between.tone(1.0), 0.75 * a.tone(1.0) + 0.25 * 0.6, 1e-12);
  EXPECT_EQ(between.color(), (Rgba{50, 25, 13, 255}));
  EXPECT_EQ(between.medium(), "pencil");
  EXPECT_EQ(stroke_at(a, b, 0.75).medium(), "chalk");
}

TEST(StrokeBlend, EndsAreFitted) {
  int missed = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Stroke a = wave(seed, 8), b = wave(seed + 300, 8);
    const StrokeBlend blend(a, b, {});
    BlendPose pose;
    blend.pose(0.5, pose);
    const Point start = pose.start + Vec{random.between(-8, 8), random.between(-8, 8)};
    const Point end = pose.end + Vec{random.between(-8, 8), random.between(-8, 8)};
    StrokeBlend::fit_ends(pose, start, end);
    const Stroke between = blend.stroke(0.5, pose).value();
    missed += distance(between.position(0.0), start) > 1e-6 ? 1 : 0;
    missed += distance(between.position(between.segment_count()), end) > 1e-6 ? 1 : 0;
  }
  EXPECT_EQ(missed, 0);
}

}  // namespace
}  // namespace felt::stroke_blend_test
