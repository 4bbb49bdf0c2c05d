#include "felt/gather/bundle_path.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "felt/gather/testing/rough_lines.h"
#include "felt/geometry/polyline.h"

namespace felt::bundle_path_test {
namespace {

// Arcs of a circle with radius 40, which together go round once.
std::vector<RoughLine> ring(int arcs, double overlap) {
  std::vector<RoughLine> lines;
  for (int i = 0; i < arcs; ++i) {
    RoughLine line;
    const double first = 2.0 * std::numbers::pi * i / arcs;
    const double sweep = 2.0 * std::numbers::pi / arcs * (1.0 + overlap);
    const double radius = 40.0 + (i % 2 == 0 ? 0.5 : -0.5);
    for (int k = 0; k <= 50; ++k) {
      const double a = first + sweep * k / 50.0;
      line.push_back({radius * std::cos(a), radius * std::sin(a)});
    }
    if (i % 3 == 1) std::reverse(line.begin(), line.end());
    lines.push_back(std::move(line));
  }
  return lines;
}

TEST(BundlePath, OneLineStaysAsItIs) {
  const RoughLine line{{0, 0}, {10, 3}, {20, 0}};
  const std::vector<RoughLine> lines{{}, line, {{4, 4}}};
  const BundlePath path = bundle_path(lines).value();
  EXPECT_EQ(path.points, line);
  EXPECT_FALSE(path.closed);
}

TEST(BundlePath, RefusesWhatHasNoLengthOrIsNotFinite) {
  EXPECT_FALSE(bundle_path({}));
  EXPECT_FALSE(bundle_path(std::vector<RoughLine>{{{1, 1}}, {}}));
  EXPECT_FALSE(bundle_path(std::vector<RoughLine>{{{1, 1}, {std::nan(""), 2}}, {{0, 0}, {1, 0}}}));
}

TEST(BundlePath, TwoParallelLinesGiveTheLineBetweenThem) {
  const std::vector<RoughLine> lines{{{0, 0}, {100, 0}}, {{100, 4}, {0, 4}}};
  const BundlePath path = bundle_path(lines).value();
  for (const Point p : path.points) EXPECT_NEAR(p.y, 2.0, 1e-6);
  EXPECT_NEAR(path.points.front().x, 0.0, 1.0);
  EXPECT_NEAR(path.points.back().x, 100.0, 1.0);
  EXPECT_NEAR(path.strip_mm, 4.0, 1e-3);
}

TEST(BundlePath, LinesThatEndAlmostTogetherGiveTheMiddleUpToTheirEnds) {
  for (int k = 0; k < 400; ++k) {
    const double first = 0.01 * (k % 20) - 0.1, last = 0.01 * (k / 20) - 0.1;
    std::vector<RoughLine> lines(2);
    for (int i = 0; i <= 80; ++i) lines[0].push_back({first + i * (80.0 + last - first) / 80, 40});
    for (int i = 0; i <= 80; ++i) lines[1].push_back({1.0 * i, 42});
    const BundlePath path = bundle_path(lines).value();
    for (const Point p : path.points) ASSERT_NEAR(p.y, 41.0, 0.05) << first << ' ' << last;
  }
}

TEST(BundlePath, LinesThatEndWithinTheTailGiveTheMiddleUpToTheEndOfTheStrip) {
  for (int k = 0; k < 600; ++k) {
    const double first = 0.1 * (k % 25) - 2.4, last = 0.1 * (k / 25) - 1.2;
    std::vector<RoughLine> lines(2);
    for (int i = 0; i <= 80; ++i) lines[0].push_back({first + i * (80.0 + last - first) / 80, 40});
    for (int i = 0; i <= 80; ++i) lines[1].push_back({1.0 * i, 42});
    const BundlePath path = bundle_path(lines).value();
    for (const Point p : path.points) EXPECT_NEAR(p.y, 41.0, 0.05) << first << ' ' << last;
  }
}

// A pen that turns back just before it is lifted leaves a hook.
TEST(BundlePath, HooksAtTheEndsOfLinesDoNotBendTheMiddle) {
  for (int k = 0; k < 400; ++k) {
    const double hook = 0.05 * (k % 20), last = 0.1 * (k / 20) - 1.0;
    std::vector<RoughLine> lines{{}, {{0, 42}, {80, 42}}};
    lines[0].push_back({hook, 40});
    for (int i = 0; i <= 80; ++i) lines[0].push_back({i * (80.0 + last) / 80, 40});
    lines[0].push_back({80.0 + last - hook, 40});
    const BundlePath path = bundle_path(lines).value();
    for (const Point p : path.points) EXPECT_NEAR(p.y, 41.0, 0.05) << hook << ' ' << last;
  }
}

TEST(BundlePath, ALineThatLeavesAndEndsDoesNotMakeTheMiddleTurnBack) {
  for (const double away : {4.0, 10.0, 20.0}) {
    std::vector<RoughLine> lines{{{0, 0}, {150, 0}}, {}};
    for (int i = 0; i <= 60; ++i) lines[1].push_back({1.0 * i, away * i * i / 3600.0});
    const BundlePath path = bundle_path(lines).value();
    const double sign = path.points.back().x > path.points.front().x ? 1.0 : -1.0;
    for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
      const Vec step = sign * (path.points[k + 1] - path.points[k]);
      EXPECT_LT(std::fabs(step.y), 1.5 * step.x) << away << " at x " << path.points[k].x;
    }
  }
}

TEST(BundlePath, LinesThatTurnBackToTheirStartGiveALine) {
  for (const double half : {1e-6, 0.3, 20.0}) {
    const RoughLine there_and_back{{0, 0}, {half, 0}, {0, 0}};
    const RoughLine beside{{half, 0.1}, {0, 0.1}, {half, 0.1}};
    const Result<BundlePath> path = bundle_path(std::vector<RoughLine>{there_and_back, beside});
    ASSERT_TRUE(path);
    EXPECT_GE(path->points.size(), 2U);
    for (const Point p : path->points) {
      EXPECT_TRUE(p.x >= -1.0 && p.x <= half + 1.0 && std::fabs(p.y) <= 1.0) << p.x << ' ' << p.y;
    }
  }
}

TEST(BundlePath, LinesThatContinueEachOtherBecomeOne) {
  const std::vector<RoughLine> lines{{{0, 0}, {40, 0}}, {{90, 0}, {45, 0}}, {{30, 1}, {60, 1}}};
  const BundlePath path = bundle_path(lines).value();
  EXPECT_NEAR(std::fabs(path.points.back().x - path.points.front().x), 90.0, 2.0);
  EXPECT_NEAR(polyline_length(path.points), 90.0, 3.0);
}

TEST(BundlePath, ArcsThatGoRoundBecomeARing) {
  for (const int arcs : {3, 5, 9}) {
    const BundlePath path = bundle_path(ring(arcs, 0.4)).value();
    EXPECT_TRUE(path.closed) << arcs;
    EXPECT_EQ(path.points.front(), path.points.back());
    for (const Point p : path.points) EXPECT_NEAR(std::hypot(p.x, p.y), 40.0, 0.75) << arcs;
    EXPECT_NEAR(polyline_length(path.points), 80.0 * std::numbers::pi, 4.0) << arcs;
  }
}

TEST(BundlePath, ARingWithAGapStaysOpen) {
  std::vector<RoughLine> lines = ring(5, 0.4);
  lines.resize(4);
  const BundlePath path = bundle_path(lines).value();
  EXPECT_FALSE(path.closed);
  for (const Point p : path.points) EXPECT_NEAR(std::hypot(p.x, p.y), 40.0, 0.75);
}

// A random cubic without a loop or a sharp bend, about 100 mm long.
Cubic random_cubic(TestRandom& random) {
  const auto bend = [&] { return 25.0 * random.signed_unit(); };
  return {{{{0, 0}, {33.0, bend()}, {66.0, bend()}, {100.0, bend()}}}};
}

RC_GTEST_PROP(BundlePath, JitteredCopiesGatherToTheirMiddle, (std::uint64_t seed)) {
  TestRandom random(seed);
  const Cubic middle = random_cubic(random);
  const int count = 3 + static_cast<int>(random.below(8));
  std::vector<RoughLine> lines = jittered_copies(middle, count, 2.0, seed);
  for (RoughLine& line : lines) {
    if (random.below(2) == 1) std::reverse(line.begin(), line.end());
  }
  const BundlePath path = bundle_path(lines).value();
  RC_ASSERT(!path.closed);
  // The mean of the copies is their exact middle, because all have the same parameter.
  RoughLine mean(61, Point{0, 0});
  double widest = 0.0;
  const std::vector<RoughLine> forwards = jittered_copies(middle, count, 2.0, seed);
  for (std::size_t k = 0; k < mean.size(); ++k) {
    for (const RoughLine& line : forwards) mean[k] += (line[k] - Point{0, 0}) / count;
    for (const RoughLine& line : forwards) {
      for (const RoughLine& other : forwards) {
        const Vec across = perp(tangent(middle, static_cast<double>(k) / 60.0));
        widest = std::max(widest, std::fabs(dot(line[k] - other[k], across)));
      }
    }
  }
  // The first and last 6 mm do not count: not all copies reach so far.
  int far = 0;
  for (std::size_t k = 4; k + 4 < mean.size(); ++k) {
    const PolylineNearest at = nearest_on_polyline(path.points, mean[k]);
    far += std::sqrt(at.distance_squared) > 0.1 * widest ? 1 : 0;
    RC_ASSERT(std::sqrt(at.distance_squared) <= 0.2 * widest);
  }
  RC_ASSERT(far <= 5);  // of 53
}

RC_GTEST_PROP(BundlePath, IsDeterministic, (std::uint64_t seed)) {
  TestRandom random(seed);
  const std::vector<RoughLine> lines = jittered_copies(random_cubic(random), 5, 2.0, seed);
  RC_ASSERT(bundle_path(lines).value() == bundle_path(lines).value());
}

}  // namespace
}  // namespace felt::bundle_path_test
