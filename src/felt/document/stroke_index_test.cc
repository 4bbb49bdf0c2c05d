#include "felt/document/stroke_index.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "felt/document/edit_builder.h"
#include "felt/document/testing/random_document.h"

namespace felt::stroke_index_test {
namespace {

std::optional<TipHit> by_hand(const Document& d, Point q, double radius,
                              std::span<const TipId> except) {
  std::optional<TipHit> best;
  for (const Layer& layer : d.layers()) {
    if (!layer.visible) continue;
    for (StrokeId id : layer.strokes) {
      const Stroke& s = *d.find(id);
      if (s.closed()) continue;
      for (StrokeTip tip : {StrokeTip::kStart, StrokeTip::kEnd}) {
        const TipHit hit{{id, tip}, tip_point(s, tip), distance(q, tip_point(s, tip))};
        if (std::find(except.begin(), except.end(), hit.id) != except.end()) continue;
        if (hit.distance_mm > radius) continue;
        if (!best || hit.distance_mm < best->distance_mm ||
            (hit.distance_mm == best->distance_mm && hit.id < best->id)) {
          best = hit;
        }
      }
    }
  }
  return best;
}

void expect_same(const std::optional<TipHit>& a, const std::optional<TipHit>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->id, b->id);
  EXPECT_EQ(a->point, b->point);
  EXPECT_EQ(a->distance_mm, b->distance_mm);
}

TEST(StrokeIndex, FindsTheNearestTipAfterAnyEdits) {
  int hits = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    testing::RandomEdits edits(seed);
    testing::RandomStroke random(seed + 1);
    Document d;
    StrokeIndex index(random.uniform(0.5, 20.0));
    std::vector<Edit> done;
    for (int k = 0; k < 30; ++k) {
      const bool back = !done.empty() && random.chance(0.3);
      const Edit edit = back ? done.back().inverse() : edits.next(d);
      ASSERT_TRUE(d.apply(edit));
      index.update(edit, d);
      if (back) {
        done.pop_back();
      } else {
        done.push_back(edit);
      }
      ASSERT_EQ(index.tip_count(), StrokeIndex(d).tip_count());
      for (int q = 0; q < 20; ++q) {
        const Point place{random.uniform(-5, 25), random.uniform(-5, 25)};
        const double radius = random.uniform(0.0, 12.0);
        std::vector<TipId> except;
        if (const auto hit = by_hand(d, place, radius, {}); hit && random.chance(0.3)) {
          except.push_back(hit->id);
        }
        const auto found = index.nearest_tip(d, place, radius, except);
        hits += found ? 1 : 0;
        expect_same(found, by_hand(d, place, radius, except));
      }
    }
  }
  EXPECT_GT(hits, 5000);
}

TEST(StrokeIndex, KnowsHowFarInkReachesBeyondItsLines) {
  Document d;
  StrokeIndex index(d);
  EXPECT_EQ(index.widest_half_mm(), 0.0);
  for (const double width : {1.0, 60.0, 3.0}) {
    const Edit edit{
        "Add",
        {{d.new_id(),
          nullptr,
          std::make_shared<const Stroke>(testing::straight_stroke({0, 0}, {9, 0}, 0.5, width)),
          {},
          {LayerId{1}, 0}}}};
    ASSERT_TRUE(d.apply(edit));
    index.update(edit, d);
  }
  EXPECT_EQ(index.widest_half_mm(), 30.0);
}

TEST(StrokeIndex, HiddenLayersAndClosedStrokesDoNotAttract) {
  Document d;
  EditBuilder edit(d);
  edit.add({1}, std::make_shared<const Stroke>(testing::straight_stroke({0, 0}, {9, 0}, 1, 1)));
  ASSERT_TRUE(d.apply(std::move(edit).build("Draw")));
  StrokeIndex index(d);
  EXPECT_TRUE(index.nearest_tip(d, {0, 1}, 2));
  ASSERT_TRUE(d.apply({"Hide", {}, {{{1}, LayerState{"Ink"}, LayerState{"Ink", false}, 0, 0}}}));
  EXPECT_FALSE(index.nearest_tip(d, {0, 1}, 2));
}

TEST(StrokeIndex, AnswersNonsenseWithNothing) {
  Document d;
  EditBuilder edit(d);
  edit.add({1},
           std::make_shared<const Stroke>(testing::straight_stroke({-1e300, 1e300}, {9, 0}, 1, 1)));
  ASSERT_TRUE(d.apply(std::move(edit).build("Draw")));
  const StrokeIndex index(d);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(index.nearest_tip(d, {nan, 0}, 8));
  EXPECT_FALSE(index.nearest_tip(d, {0, 0}, nan));
  EXPECT_FALSE(index.nearest_tip(d, {0, 0}, -1));
  EXPECT_EQ(index.nearest_tip(d, {8, 0}, 1e308)->point, (Point{9, 0}));
  EXPECT_EQ(index.nearest_tip(d, {-1e300, 1e300}, 1)->distance_mm, 0.0);
}

/// Searches by brute force, one segment after the other.
std::optional<StrokeHit> nearest_by_hand(const Document& d, Point q, double radius_mm) {
  std::optional<StrokeHit> best;
  double smallest = radius_mm * radius_mm;
  std::vector<StrokeId> ids;
  for (const Layer& layer : d.layers()) {
    if (!layer.visible || layer.locked) continue;
    ids.insert(ids.end(), layer.strokes.begin(), layer.strokes.end());
  }
  std::sort(ids.begin(), ids.end());
  for (const StrokeId id : ids) {
    const StrokePtr stroke = d.find(id);
    for (int i = 0; i < stroke->segment_count(); ++i) {
      const auto hit = nearest_within(stroke->segment(i), q, smallest);
      if (!hit || (best && hit->distance_squared >= smallest)) continue;
      smallest = hit->distance_squared;
      best = StrokeHit{id, i + hit->t, hit->point, std::sqrt(smallest)};
    }
  }
  return best;
}

TEST(StrokeIndex, R19_R20_FindsTheNearestPlaceAfterAnyEditsUndoAndLayersToggled) {
  int hits = 0, misses = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    testing::RandomEdits edits(seed);
    testing::RandomStroke random(seed + 1);
    Document d;
    StrokeIndex index;
    std::vector<Edit> done;
    for (int k = 0; k < 30; ++k) {
      const bool back = !done.empty() && random.chance(0.3);
      const Edit edit = back ? done.back().inverse() : edits.next(d);
      ASSERT_TRUE(d.apply(edit));
      index.update(edit, d);
      if (back) {
        done.pop_back();
      } else {
        done.push_back(edit);
      }
      for (int q = 0; q < 10; ++q) {
        const Point place{random.uniform(-40, 60), random.uniform(-40, 60)};
        const double radius = random.chance(0.2) ? 1e9 : 8.0;
        const auto found = index.nearest(place, radius), truth = nearest_by_hand(d, place, radius);
        ASSERT_EQ(found.has_value(), truth.has_value());
        ++(found ? hits : misses);
        if (!found) continue;
        ASSERT_EQ(found->distance_mm, truth->distance_mm);
        ASSERT_EQ(found->stroke, truth->stroke);
        ASSERT_EQ(found->point, truth->point);
        ASSERT_NEAR(found->u, truth->u, 1e-9);
      }
      const Rect area{random.uniform(0, 10), random.uniform(0, 10), 15.0, 12.0};
      std::set<StrokeId> inside;
      for (const Layer& layer : d.layers()) {
        if (!layer.visible || layer.locked) continue;
        for (const StrokeId id : layer.strokes) {
          for (int i = 0; i < d.find(id)->segment_count(); ++i) {
            if (bounds(d.find(id)->segment(i)).intersects(area)) inside.insert(id);
          }
        }
      }
      ASSERT_EQ(index.strokes_in(area), std::vector<StrokeId>(inside.begin(), inside.end()));
    }
  }
  EXPECT_GT(hits, 3000);
  EXPECT_GT(misses, 3000);
}

TEST(StrokeIndex, StrokesThatAreSortedLaterAreFoundAsIfTheyWereSortedAtOnce) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    testing::RandomEdits edits(seed);
    testing::RandomStroke random(seed + 1);
    Document d;
    for (int k = 0; k < 30; ++k) ASSERT_TRUE(d.apply(edits.next(d)));
    StrokeIndex later(d, 8.0, 0), sorted(d);
    EXPECT_EQ(later.tip_count(), sorted.tip_count());
    EXPECT_EQ(later.widest_half_mm(), sorted.widest_half_mm());
    EXPECT_EQ(later.farthest_handle_mm(), sorted.farthest_handle_mm());
    for (int k = 0; k < 20; ++k) {
      const Edit edit = edits.next(d);
      ASSERT_TRUE(d.apply(edit));
      later.update(edit, d);
      sorted.update(edit, d);
      ASSERT_EQ(later.tip_count(), sorted.tip_count());
      const Point place{random.uniform(-5, 25), random.uniform(-5, 25)};
      const double radius = random.uniform(0.0, 12.0);
      const Rect area{place.x, place.y, place.x + radius, place.y + radius};
      EXPECT_EQ(later.strokes_in(area), sorted.strokes_in(area));
      expect_same(later.nearest_tip(d, place, radius), sorted.nearest_tip(d, place, radius));
      const auto a = later.nearest(place, radius), b = sorted.nearest(place, radius);
      ASSERT_EQ(a.has_value(), b.has_value());
      if (!a) continue;
      EXPECT_EQ(a->distance_mm, b->distance_mm);
    }
  }
}

TEST(StrokeIndex, OpeningALargeDocumentSortsOnlyWhatIsAskedFor) {
  // One short stroke in each square of 20 mm, and one stroke that is longer than the width of the
  // page.
  constexpr int kSide = 150;
  constexpr double kPitchMm = 20.0;
  Document d;
  EditBuilder edit(d);
  const auto add = [&edit](Point a, Point b) {
    edit.add({1}, std::make_shared<const Stroke>(testing::straight_stroke(a, b, 1, 1)));
  };
  for (int i = 0; i < kSide * kSide; ++i) {
    const Point a{kPitchMm * (i % kSide), kPitchMm * (i / kSide)};
    add(a, {a.x + 5.0, a.y});
  }
  add({-1e9, 10}, {1e9, 10});
  ASSERT_TRUE(d.apply(std::move(edit).build("Draw")));
  ASSERT_GT(d.stroke_count(), StrokeIndex::kIndexedAtOnce);
  StrokeIndex index(d);
  constexpr std::size_t kAll = std::size_t{kSide} * kSide;
  EXPECT_EQ(index.unindexed_count(), kAll);  // the long stroke is indexed immediately
  EXPECT_EQ(index.tip_count(), 2 * (kAll + 1));
  EXPECT_EQ(index.nearest({1002, 1001}, 8)->point, (Point{1002, 1000}));
  EXPECT_EQ(index.nearest_tip(d, {1400, 1400}, 8)->point, (Point{1400, 1400}));
  EXPECT_GT(index.unindexed_count(), kAll - 50);
  EXPECT_LT(index.unindexed_count(), kAll);
  EXPECT_EQ(index.strokes_in({-1e9, -1e9, 1e9, 1e9}).size(), kAll + 1);
  EXPECT_EQ(index.unindexed_count(), 0u);
}

TEST(StrokeIndex, TheHundredThousandthStrokeCostsNoMoreThanTheFirst) {
  Document d;
  StrokeIndex index;
  testing::RandomStroke random(3);
  for (int k = 0; k < 100; ++k) {
    EditBuilder edit(d);
    for (int i = 0; i < 1000; ++i) {
      const Point a{random.uniform(0, 2000), random.uniform(0, 2000)};
      const Point b{random.uniform(0, 2000), random.uniform(0, 2000)};
      edit.add({1}, std::make_shared<const Stroke>(testing::straight_stroke(a, b, 1, 1)));
    }
    const Edit done = std::move(edit).build("Draw");
    ASSERT_TRUE(d.apply(done));
    index.update(done, d);
  }
  EXPECT_EQ(index.tip_count(), 200000u);
  int hits = 0;
  for (int k = 0; k < 100000; ++k) {
    hits += index.nearest_tip(d, {random.uniform(0, 2000), random.uniform(0, 2000)}, 8) ? 1 : 0;
  }
  EXPECT_GT(hits, 90000);
}

StrokePtr line_of(Point a, Point b, double width) {
  return std::make_shared<const Stroke>(testing::straight_stroke(a, b, width, width));
}

TEST(StrokeIndex, OneVeryBroadStrokeDoesNotWidenTheSearchForAllOthers) {
  Document d;
  StrokeIndex index;
  const auto apply = [&](EditBuilder edit) {
    const Edit done = std::move(edit).build("Edit");
    ASSERT_TRUE(d.apply(done));
    index.update(done, d);
  };
  const auto met = [&](const Rect& area) {
    std::multiset<StrokeId> ids;
    index.for_each_ink_in(area, [&](StrokeId id, int) { ids.insert(id); });
    return ids;
  };
  EditBuilder many(d);
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 50; ++x) {
      many.add(d.layers()[0].id, line_of({4.0 * x, 4.0 * y}, {4.0 * x + 3, 4.0 * y}, 1.0));
    }
  }
  apply(std::move(many));
  const Rect area{100, 100, 104, 104};
  const auto before = met(area);
  EditBuilder one(d);
  const StrokeId broad = one.add(d.layers()[0].id, line_of({0, -500}, {200, -500}, 1300.0));
  apply(std::move(one));
  auto after = met(area);
  EXPECT_EQ(after.count(broad), 1u) << "its ink is there";
  after.erase(broad);
  EXPECT_EQ(after, before) << "and no more of the others is visited";
  EXPECT_EQ(met({0, 300, 9, 309}).count(broad), 0u);
  EditBuilder narrow(d);
  narrow.replace(broad, line_of({0, -500}, {200, -500}, 1.0));
  apply(std::move(narrow));
  EXPECT_EQ(met(area), before);
  EXPECT_EQ(met({0, -500, 9, -499}).count(broad), 1u);
  EditBuilder gone(d);
  gone.remove(broad);
  apply(std::move(gone));
  EXPECT_TRUE(met({0, -500, 9, -499}).empty());
}

TEST(StrokeIndex, FindsAllInkAfterAnyEdits) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    testing::RandomEdits edits(seed);
    testing::RandomStroke random(seed + 1);
    Document d;
    StrokeIndex followed;
    for (int k = 0; k < 30; ++k) {
      const Edit edit = edits.next(d);
      ASSERT_TRUE(d.apply(edit));
      followed.update(edit, d);
      const StrokeIndex sorted_later(d, 8.0, 0);
      const StrokeIndex& index = k % 2 == 0 ? followed : sorted_later;
      const Point p{random.uniform(-50, 70), random.uniform(-50, 70)};
      std::set<StrokeId> met;
      index.for_each_ink_in({p.x, p.y, p.x + 1, p.y + 1},
                            [&](StrokeId id, int) { met.insert(id); });
      for (const Layer& layer : d.layers()) {
        for (const StrokeId id : layer.strokes) {
          if (!layer.visible || layer.locked) continue;
          const Stroke& s = *d.find(id);
          for (double u = 0.0; u <= s.segment_count(); u += 0.25) {
            if (distance(s.position(u), p) < 0.5 * s.width_mm(u)) {
              EXPECT_TRUE(met.contains(id));
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace felt::stroke_index_test
