#include "felt/geometry/bvh.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include "felt/base/constants.h"
#include "felt/geometry/testing/nearest_cases.h"

namespace felt::bvh_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr BvhWorkCap kNoCap{1 << 30, 1 << 30};

// Short segments of all kinds, spread over a square; `kind` < 0 mixes them.
std::vector<BvhSegment> scatter(std::size_t n, std::mt19937_64& random) {
  std::vector<BvhSegment> segments(n);
  const double side = 40.0 * std::sqrt(static_cast<double>(n) + 1.0);
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto kind = static_cast<CaseKind>(random() % (kCaseKinds - 1));
    Cubic c = make_case(kind, random).curve;
    const Vec to{uniform(random, 0.0, side), uniform(random, 0.0, side)};
    for (Point& p : c.p) p = Point{} + 0.2 * (p - Point{}) + to;
    segments[i] = {c, {i / 3, i % 3}};
  }
  return segments;
}

Point point_near(const std::vector<BvhSegment>& segments, std::mt19937_64& random) {
  if (segments.empty()) return {1, 2};
  const Cubic& c = segments[random() % segments.size()].curve;
  return c.p[0] + Vec{uniform(random, -60.0, 60.0), uniform(random, -60.0, 60.0)};
}

double brute_force(const SegmentBvh& tree, Point p) {
  double best = kInfinity;
  for (std::uint32_t h = 0; h < tree.size(); ++h) {
    best = std::min(best, nearest(tree.curve(h), p).distance_squared);
  }
  return best;
}

// Expects that the hit is correct and proven, and has the right reference.
void expect_right(const SegmentBvh& tree, const SegmentBvh::Query& query) {
  const SegmentBvh::Hit hit = tree.nearest(query);
  const double truth = brute_force(tree, query.point);
  ASSERT_TRUE(hit.proven);
  const bool exists = std::isfinite(truth) && truth <= query.radius_mm * query.radius_mm;
  ASSERT_EQ(static_cast<bool>(hit), exists);
  if (!hit) return;
  EXPECT_NEAR(hit.nearest.distance_squared, truth, 1e-12 * (1.0 + truth));
  EXPECT_EQ(hit.ref, tree.ref(hit.handle));
  EXPECT_EQ(hit.nearest.point, evaluate(tree.curve(hit.handle), hit.nearest.t));
}

class BvhOfSize : public ::testing::TestWithParam<std::size_t> {};

TEST_P(BvhOfSize, AgreesWithBruteForce) {
  std::mt19937_64 random(GetParam());
  const std::vector<BvhSegment> segments = scatter(GetParam(), random);
  SegmentBvh tree;
  tree.build(segments);
  ASSERT_EQ(tree.size(), segments.size());
  for (std::uint32_t h = 0; h < tree.size(); ++h) {
    ASSERT_EQ(tree.curve(h), segments[h].curve);
    ASSERT_EQ(tree.ref(h), segments[h].ref);
  }
  SegmentBvh::Query query;
  query.cap = kNoCap;
  for (int i = 0; i < 200; ++i) {
    query.point = point_near(segments, random);
    query.radius_mm = i % 2 == 0 ? kInfinity : 5.0;
    query.seed = i % 3 == 0 ? SegmentBvh::kNone : static_cast<std::uint32_t>(random() % 2000);
    expect_right(tree, query);
  }
}

TEST_P(BvhOfSize, FindsTheSegmentsInARectangle) {
  std::mt19937_64 random(GetParam());
  const std::vector<BvhSegment> segments = scatter(GetParam(), random);
  SegmentBvh tree;
  tree.build(segments);
  for (int i = 0; i < 50; ++i) {
    Rect area;
    area.extend(point_near(segments, random));
    area = area.inflated(uniform(random, 0.0, 80.0));
    std::vector<int> times(segments.size(), 0);
    tree.for_each_in(area, [&](std::uint32_t handle) { ++times[handle]; });
    for (std::uint32_t h = 0; h < segments.size(); ++h) {
      const Rect box = bounds(segments[h].curve);
      ASSERT_GE(times[h], box.intersects(area) ? 1 : 0);
      ASSERT_LE(times[h], box.inflated(1e-3).intersects(area) ? 1 : 0);
    }
  }
}

TEST_P(BvhOfSize, StaysRightWhenSegmentsAreRefittedAndErased) {
  std::mt19937_64 random(GetParam());
  std::vector<BvhSegment> segments = scatter(GetParam(), random);
  SegmentBvh tree;
  tree.build(segments);
  for (int i = 0; i < 100 && !segments.empty(); ++i) {
    const auto handle = static_cast<std::uint32_t>(random() % segments.size());
    if (i % 5 == 4) {
      tree.erase(handle);
    } else {
      const Vec by{uniform(random, -90.0, 90.0), uniform(random, -90.0, 90.0)};
      Cubic moved = segments[handle].curve;
      for (Point& p : moved.p) p += by;
      tree.refit(handle, moved);
    }
    if (i == 60) tree.rebuild();
    expect_right(tree, {point_near(segments, random), kInfinity, handle, kNoCap});
  }
  EXPECT_TRUE(GetParam() <= 64 || tree.degradation() > 1.0);
  tree.rebuild();
  EXPECT_EQ(tree.degradation(), 1.0);
}

INSTANTIATE_TEST_SUITE_P(Bvh, BvhOfSize,
                         ::testing::Values(0, 1, 2, 7, 8, 9, 63, 64, 65, 100, 511, 513, 1500));

TEST(Bvh, AnEmptyTreeFindsNothing) {
  const SegmentBvh tree;
  const SegmentBvh::Hit hit = tree.nearest({{1, 2}});
  EXPECT_FALSE(hit);
  EXPECT_TRUE(hit.proven);
  tree.for_each_in(Rect{-1e9, -1e9, 1e9, 1e9}, [](std::uint32_t) { FAIL(); });
  EXPECT_FALSE(tree.rebuild_advised());
}

TEST(Bvh, OfIdenticalSegmentsAllAreEquallyGood) {
  const std::vector<BvhSegment> segments(100, {straight({0, 0}, {10, 0}), {5, 6}});
  SegmentBvh tree;
  tree.build(segments);
  const SegmentBvh::Hit hit = tree.nearest({{3, 2}, kInfinity, 77, kNoCap});
  EXPECT_EQ(hit.nearest.distance_squared, 4.0);
  EXPECT_EQ(hit.handle, 0U) << "the lowest handle, whatever the seed";
  std::set<std::uint32_t> seen;
  tree.for_each_in(Rect{1, -1, 2, 1}, [&](std::uint32_t h) { seen.insert(h); });
  EXPECT_EQ(seen.size(), segments.size());
}

TEST(Bvh, ACircleOfArcsAroundThePenRespectsTheCap) {
  constexpr std::uint32_t kArcs = 5000;
  constexpr double kRadius = 50.0;
  std::vector<BvhSegment> segments;
  const auto at = [](double i) {
    const double angle = 2.0 * std::numbers::pi * i / kArcs;
    return Vec{kRadius * std::cos(angle), kRadius * std::sin(angle)};
  };
  const double handle = 4.0 / 3.0 * std::tan(0.5 * std::numbers::pi / kArcs);
  for (std::uint32_t i = 0; i < kArcs; ++i) {
    const Vec a = at(i), b = at(i + 1.0);
    segments.push_back({Cubic{{Point{} + a, Point{} + (a + handle * perp(a)),
                               Point{} + (b - handle * perp(b)), Point{} + b}},
                        {}});
  }
  SegmentBvh tree;
  tree.build(segments);
  const BvhWorkCap cap{64, 100};
  const SegmentBvh::Hit hit = tree.nearest({{0, 0}, kInfinity, SegmentBvh::kNone, cap});
  EXPECT_FALSE(hit.proven);
  EXPECT_LE(hit.used.nodes, cap.nodes);
  EXPECT_LE(hit.used.pieces, cap.pieces);
  ASSERT_TRUE(hit) << "the best so far is an answer";
  EXPECT_NEAR(std::sqrt(hit.nearest.distance_squared), kRadius, 1e-9);
  EXPECT_TRUE(tree.nearest({{0, 0}, 10.0}).proven) << "a radius keeps the search small";
  const SegmentBvh::Hit nothing = tree.nearest({{0, 0}, kInfinity, 3, {0, 0}});
  EXPECT_FALSE(nothing);
  EXPECT_FALSE(nothing.proven);
}

TEST(Bvh, InputThatIsNotFiniteIsNeverFound) {
  std::vector<BvhSegment> segments(20, {straight({0, 0}, {10, 0}), {}});
  segments[7].curve.p[2].x = kNan;
  segments[0].curve.p[0].y = kInfinity;
  SegmentBvh tree;
  tree.build(segments);
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    EXPECT_EQ(tree.nearest({{5, 1}, kInfinity, seed, kNoCap}).handle, 1U);
  }
  for (const Point p : {Point{kNan, 0}, Point{0, -kInfinity}}) EXPECT_FALSE(tree.nearest({p}));
  EXPECT_FALSE(tree.nearest({{5, 1}, kNan}));
  EXPECT_FALSE(tree.nearest({{5, 1}, -1.0}));
  EXPECT_TRUE(tree.nearest({{5, 0}, 0.0}));
  tree.for_each_in(Rect{}, [](std::uint32_t) { FAIL() << "an empty rectangle"; });
}

TEST(Bvh, HugeAndTinyCoordinatesAreFound) {
  std::vector<BvhSegment> segments;
  for (const double size : {1e-30, 1.0, 1e9, 1e30, 1e100}) {
    segments.push_back({straight({size, size}, {2 * size, size}), {}});
    segments.push_back({straight({-size, -size}, {-2 * size, size}), {}});
  }
  for (int i = 0; i < 20; ++i) segments.push_back({straight({7e5 + i, 7e5}, {8e5, 9e5}), {}});
  SegmentBvh tree;
  tree.build(segments);
  for (std::uint32_t h = 0; h < tree.size(); ++h) {
    const Point p = evaluate(tree.curve(h), 0.5);
    const SegmentBvh::Hit hit = tree.nearest({p, kInfinity, SegmentBvh::kNone, kNoCap});
    EXPECT_LE(hit.nearest.distance_squared, brute_force(tree, p)) << h;
  }
}

TEST(Bvh, AdvisesToRebuildOnceBoxesHaveGrown) {
  std::mt19937_64 random(5);
  const std::vector<BvhSegment> segments = scatter(1000, random);
  SegmentBvh tree;
  tree.build(segments);
  EXPECT_FALSE(tree.rebuild_advised());
  for (std::uint32_t h = 0; h < 100; ++h) {
    tree.refit(h, segments[999 - h].curve);
    tree.refit(999 - h, segments[h].curve);
  }
  EXPECT_TRUE(tree.rebuild_advised());
  tree.rebuild();
  EXPECT_FALSE(tree.rebuild_advised());
}

}  // namespace
}  // namespace felt::bvh_test
