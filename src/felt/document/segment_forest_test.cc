#include "felt/document/segment_forest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "felt/base/constants.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::segment_forest_test {
namespace {

using testing::RandomStroke;
using StrokePtr = std::shared_ptr<const Stroke>;
using Strokes = std::map<StrokeId, StrokePtr>;

StrokePtr moved(const Stroke& stroke, Vec by, double scale = 1.0) {
  StrokeData data = stroke.data();
  for (Point& p : data.points) p = Point{scale * p.x, scale * p.y} + by;
  return std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
}

/// Returns a stroke of about 10 segments of a few mm.
StrokePtr scribble(RandomStroke& random, Point start) {
  StrokeData data;
  data.points.push_back(start);
  const int size = random.pick(5, 15);
  for (int i = 0; i < 3 * size; ++i) {
    data.points.push_back(data.points.back() + Vec{random.uniform(-1, 2), random.uniform(-1, 2)});
  }
  data.joints.assign(static_cast<std::size_t>(size - 1), JointKind::kCorner);
  data.widths = {{0.0, 0.5}, {static_cast<double>(size), 0.5}};
  return std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
}

std::optional<SegmentForest::Hit> by_hand(const Strokes& strokes, Point q, double radius_mm) {
  std::optional<SegmentForest::Hit> best;
  for (const auto& [id, stroke] : strokes) {
    for (int i = 0; i < stroke->segment_count(); ++i) {
      const auto hit = nearest_within(stroke->segment(i), q, radius_mm * radius_mm);
      if (!hit || (best && best->nearest.distance_squared <= hit->distance_squared)) continue;
      best = SegmentForest::Hit{id, i, *hit};
    }
  }
  return best;
}

using Names = std::set<std::pair<std::uint64_t, int>>;

Names in_area_by_hand(const Strokes& strokes, const Rect& area) {
  Names names;
  for (const auto& [id, stroke] : strokes) {
    for (int i = 0; i < stroke->segment_count(); ++i) {
      if (bounds(stroke->segment(i)).intersects(area)) names.insert({id.value, i});
    }
  }
  return names;
}

Names in_area(const SegmentForest& forest, const Rect& area) {
  Names names;
  forest.for_each_in(area, [&](StrokeId id, int segment) {
    EXPECT_TRUE(names.insert({id.value, segment}).second) << "told twice";
  });
  return names;
}

void expect_right(const SegmentForest& forest, const Strokes& strokes, RandomStroke& random) {
  std::size_t segments = 0;
  for (const auto& [id, stroke] : strokes) {
    segments += static_cast<std::size_t>(stroke->segment_count());
  }
  ASSERT_EQ(forest.segment_count(), segments);
  ASSERT_EQ(forest.stroke_count(), strokes.size());
  for (int k = 0; k < 5; ++k) {
    const Point q{random.uniform(-20, 220), random.uniform(-20, 220)};
    const double radius = random.chance(0.2) ? 1e6 : random.uniform(0, 30);
    const auto hit = forest.nearest(q, radius), truth = by_hand(strokes, q, radius);
    ASSERT_EQ(hit.has_value(), truth.has_value());
    if (hit) {
      ASSERT_EQ(hit->nearest.distance_squared, truth->nearest.distance_squared);
      ASSERT_EQ(hit->stroke, truth->stroke);
      ASSERT_EQ(hit->segment, truth->segment);
    }
    const Rect area{q.x, q.y, q.x + random.uniform(0, 60), q.y + random.uniform(0, 60)};
    ASSERT_EQ(in_area(forest, area), in_area_by_hand(strokes, area));
  }
}

/// Makes changes like a user: strokes of all sizes are drawn, erased, moved, cut and lengthened.
std::vector<SegmentForest::Change> random_changes(const Strokes& strokes, std::uint64_t& last_id,
                                                  RandomStroke& random) {
  std::map<StrokeId, StrokePtr> changes;
  const auto any = [&] {
    return std::next(strokes.begin(), random.pick(0, static_cast<int>(strokes.size()) - 1));
  };
  for (int k = random.pick(0, 20); k > 0; --k) {
    const Point start{random.uniform(0, 200), random.uniform(0, 200)};
    changes[StrokeId{++last_id}] =
        random.chance(0.05) ? moved(*scribble(random, {0, 0}), {0, 0}, random.uniform(1, 40))
                            : scribble(random, start);
  }
  for (int k = random.pick(0, 10); k > 0 && !strokes.empty(); --k) {
    const auto [id, stroke] = *any();
    const double far = random.chance(0.5) ? 0.3 : 100.0;
    changes[id] = random.chance(0.5)
                      ? moved(*stroke, {random.uniform(-far, far), random.uniform(-far, far)})
                      : scribble(random, stroke->position(0.0));
  }
  for (int k = random.pick(0, 8); k > 0 && !strokes.empty(); --k) changes[any()->first] = nullptr;
  std::vector<SegmentForest::Change> list;
  for (const auto& [id, stroke] : changes) list.push_back({id, stroke});
  return list;
}

void carry_out(Strokes& strokes, std::span<const SegmentForest::Change> changes) {
  for (const auto& c : changes) {
    if (c.after) {
      strokes[c.id] = c.after;
    } else {
      strokes.erase(c.id);
    }
  }
}

TEST(SegmentForest, R19_AgreesWithBruteForceAfterAnyChanges) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE(seed);
    RandomStroke random(seed);
    SegmentForest forest;
    Strokes strokes;
    std::uint64_t last_id = 0;
    for (int round = 0; round < 120; ++round) {
      const auto changes = random_changes(strokes, last_id, random);
      forest.update(changes);
      carry_out(strokes, changes);
      expect_right(forest, strokes, random);
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(forest.leaf_count(), 5u) << "leaves were cut";
    while (!strokes.empty()) {
      const SegmentForest::Change gone{strokes.begin()->first, nullptr};
      forest.update({&gone, 1});
      strokes.erase(strokes.begin());
    }
    EXPECT_EQ(forest.segment_count(), 0u);
    EXPECT_EQ(forest.leaf_count(), 0u);
    EXPECT_FALSE(forest.nearest({10, 10}, 1e9));
  }
}

TEST(SegmentForest, ManyAtOnceAreSortedInWithWhatIsThere) {
  RandomStroke random(5);
  SegmentForest forest;
  Strokes strokes;
  std::uint64_t id = 0;
  for (const int size : {1, 100, 400, 900}) {
    std::vector<SegmentForest::Change> changes;
    for (int i = 0; i < size; ++i) {
      const Point start{random.uniform(0, 200), random.uniform(0, 200)};
      changes.push_back({StrokeId{++id}, scribble(random, start)});
    }
    if (!strokes.empty()) {
      changes.push_back({strokes.begin()->first, nullptr});
      changes.push_back({strokes.rbegin()->first, scribble(random, {50, 50})});
    }
    forest.update(changes);
    carry_out(strokes, changes);
    expect_right(forest, strokes, random);
  }
}

TEST(SegmentForest, OfEquallyNearOnesTheLowestStrokeWinsInAnyOrder) {
  const auto line = std::make_shared<const Stroke>(testing::straight_stroke({0, 0}, {10, 0}, 1, 1));
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    RandomStroke random(seed);
    SegmentForest forest;
    std::set<std::uint64_t> present;
    for (int k = 0; k < 1500; ++k) {
      const auto id = static_cast<std::uint64_t>(random.pick(3, 500));
      const bool goes = present.contains(id) && random.chance(0.5);
      const SegmentForest::Change c{StrokeId{id}, goes ? nullptr : line};
      forest.update({&c, 1});
      if (goes) {
        present.erase(id);
      } else {
        present.insert(id);
      }
      if (k % 50 != 0 || present.empty()) continue;
      ASSERT_EQ(forest.nearest({5, 3}, 8)->stroke.value, *present.begin());
    }
  }
}

TEST(SegmentForest, ClaimsNothingOfNonsenseAndLosesNothingFarAway) {
  SegmentForest forest;
  const auto put = [&](std::uint64_t id, Point a, Point b) {
    const SegmentForest::Change c{
        StrokeId{id}, std::make_shared<const Stroke>(testing::straight_stroke(a, b, 1, 1))};
    forest.update({&c, 1});
  };
  put(1, {0, 0}, {9, 0});
  put(2, {-1e300, 1e300}, {9, 0});
  put(3, {1e150, 5}, {1e150, 1e140});
  put(4, {1e17, 0}, {1e17, 50});
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(forest.nearest({kNan, 0}, 8));
  EXPECT_FALSE(forest.nearest({kInfinity, 0}, 8));
  EXPECT_FALSE(forest.nearest({0, 0}, kNan));
  EXPECT_FALSE(forest.nearest({0, 0}, -1));
  EXPECT_EQ(forest.nearest({0, 3}, 8)->stroke.value, 1u);
  EXPECT_EQ(forest.nearest({0, 3}, kInfinity)->stroke.value, 1u);
  EXPECT_EQ(forest.nearest({1e17, 20}, 8)->stroke.value, 4u);
  EXPECT_EQ(forest.nearest({-1e6, 0}, kInfinity)->stroke.value, 1u);
  EXPECT_TRUE(in_area(forest, {kNan, 0, 1, 1}).empty());
  EXPECT_EQ(in_area(forest, {-kInfinity, -kInfinity, kInfinity, kInfinity}).size(), 4u);
}

/// A page that grows with its strokes, so that the density stays about the same.
struct Page {
  explicit Page(int count, std::uint64_t seed = 1) : random(seed), side_mm(8.0 * std::sqrt(count)) {
    std::vector<SegmentForest::Change> changes;
    for (int i = 0; i < count; ++i) changes.push_back({StrokeId{++last_id}, fresh()});
    forest.update(changes);
  }
  StrokePtr fresh() { return scribble(random, place()); }
  Point place() { return {random.uniform(0, side_mm), random.uniform(0, side_mm)}; }

  RandomStroke random;
  double side_mm;
  std::uint64_t last_id = 0;
  SegmentForest forest;
};

double mean_nodes(Page& page) {
  double nodes = 0.0;
  constexpr int kQueries = 2000;
  for (int i = 0; i < kQueries; ++i) {
    SegmentForest::Work work;
    (void)page.forest.nearest(page.place(), 8.0, &work);
    nodes += work.nodes;
    EXPECT_LE(work.leaves, 12);
  }
  return nodes / kQueries;
}

TEST(SegmentForest, AHundredTimesTheStrokesCostAQueryNoMore) {
  Page small(1000), large(100000);
  EXPECT_GT(large.forest.segment_count(), 900000u);
  EXPECT_LT(mean_nodes(large), 1.3 * mean_nodes(small));
}

TEST(SegmentForest, WhatAnEditSortsIsAFewLeavesHoweverLargeThePage) {
  Page page(20000);
  std::uint64_t worst = 0;
  std::uint64_t before = page.forest.sorted_count();
  const std::uint64_t start = before, boxes_before = page.forest.sorted_leaf_count();
  constexpr int kEdits = 5000;
  for (int i = 0; i < kEdits; ++i) {
    const StrokeId id{static_cast<std::uint64_t>(page.random.pick(1, 25000))};
    const SegmentForest::Change c{id, page.random.chance(0.2) ? nullptr : page.fresh()};
    page.forest.update({&c, 1});
    worst = std::max(worst, page.forest.sorted_count() - before);
    before = page.forest.sorted_count();
  }
  EXPECT_LT(worst, 8 * SegmentForest::kLeafSegments);
  EXPECT_LT(static_cast<double>(before - start) / kEdits, 200.0);
  // The boxes of leaves are hardly ever sorted.
  const std::uint64_t boxes = page.forest.sorted_leaf_count() - boxes_before;
  EXPECT_LT(static_cast<double>(boxes) / kEdits, 20.0);
  EXPECT_LT(mean_nodes(page), 60.0);
}

}  // namespace
}  // namespace felt::segment_forest_test
