#include "felt/tools/eraser/crossing_span.h"

#include <gtest/gtest.h>

#include <limits>

#include "felt/tools/testing/tool_fixture.h"

namespace felt::crossing_span_test {
namespace {

using testing::Fixture;
using testing::straight_stroke;

struct Span {
  double from, to;
  bool whole;
};

Span span_at(const Fixture& fixture, StrokeId id, double u,
             int budget = std::numeric_limits<int>::max()) {
  StrokeCrossings crossings(id, fixture.document.find(id));
  SpanSearch search({u, u});
  const Scene scene = fixture.scene();
  for (int i = 0; i < 100'000; ++i) {
    int left = budget;
    if (search.advance(crossings, scene, left))
      return {search.from(), search.to(), search.is_whole()};
  }
  ADD_FAILURE() << "never done";
  return {};
}

/// A line along x from 0 to 100, with lines across it at 20, 50 and 80.
struct Fence {
  Fixture fixture;
  StrokeId rail = fixture.add(straight_stroke({0, 0}, {100, 0}, 1, 1));
  std::vector<StrokeId> posts;

  explicit Fence(double from = -10, double to = 10) {
    for (const double x : {20.0, 50.0, 80.0}) {
      posts.push_back(fixture.add(straight_stroke({x, from}, {x, to}, 1, 1)));
    }
  }
};

TEST(CrossingSpan, StopsAtTheNeighbouringCrossings) {
  const Fence f;
  const Span middle = span_at(f.fixture, f.rail, 0.3);
  EXPECT_NEAR(middle.from, 0.2, 1e-12);
  EXPECT_NEAR(middle.to, 0.5, 1e-12);
  EXPECT_FALSE(middle.whole);
  const Span first = span_at(f.fixture, f.rail, 0.1);
  EXPECT_EQ(first.from, 0.0);
  EXPECT_NEAR(first.to, 0.2, 1e-12);
  const Span last = span_at(f.fixture, f.rail, 0.99);
  EXPECT_NEAR(last.from, 0.8, 1e-12);
  EXPECT_EQ(last.to, 1.0);
}

TEST(CrossingSpan, AnEndHalfAMillimetreAwayIsATee) {
  for (const double gap : {0.0, 0.2, 0.49}) {
    const Fence f(gap, 10);
    const Span s = span_at(f.fixture, f.rail, 0.3);
    EXPECT_NEAR(s.from, 0.2, 1e-9) << gap;
    EXPECT_NEAR(s.to, 0.5, 1e-9) << gap;
  }
  const Fence beyond(0.51, 10);
  EXPECT_TRUE(span_at(beyond.fixture, beyond.rail, 0.3).whole);
  // An end that extends beyond the line by less than kTeeMm makes one crossing, not two.
  const Fence through(-0.3, 10);
  StrokeCrossings crossings(through.rail, through.fixture.document.find(through.rail));
  int budget = 1'000'000;
  const Scene scene = through.fixture.scene();
  const auto* places = crossings.on_segment(0, scene, budget);
  ASSERT_NE(places, nullptr);
  EXPECT_EQ(places->size(), 3u);
}

TEST(CrossingSpan, WithoutCrossingsTheWholeStrokeGoes) {
  Fixture fixture;
  const StrokeId open = fixture.add(straight_stroke({0, 0}, {10, 0}, 1, 1));
  EXPECT_TRUE(span_at(fixture, open, 0.5).whole);
  const auto ring =
      Stroke::create(
          {.points = {{40, 0}, {50, -10}, {60, -10}, {70, 0}, {60, 10}, {50, 10}, {40, 0}},
           .joints = {JointKind::kCorner, JointKind::kCorner},
           .closed = true,
           .widths = {{0, 1}, {2, 1}}})
          .value();
  const StrokeId closed = fixture.add(ring);
  EXPECT_TRUE(span_at(fixture, closed, 0.5).whole);
  // With a single crossing, the search finds no second crossing, so the whole stroke is erased.
  fixture.add(straight_stroke({55, -20}, {55, 0}, 1, 1));
  EXPECT_TRUE(span_at(fixture, closed, 0.1).whole);
  // With two crossings, each side is a span, including the side with the seam.
  fixture.add(straight_stroke({55, 0}, {55, 20}, 1, 1));
  const Span right = span_at(fixture, closed, 0.9);
  EXPECT_NEAR(right.from, 0.5, 1e-9);
  EXPECT_NEAR(right.to, 1.5, 1e-9);
  const Span left = span_at(fixture, closed, 0.1);
  EXPECT_NEAR(left.from, 1.5, 1e-9);
  EXPECT_NEAR(left.to, 0.5, 1e-9);
  EXPECT_FALSE(left.whole);
}

TEST(CrossingSpan, AStrokeCrossesItselfButNotAtItsJoints) {
  // A smooth loop of three segments. The segments at its ends cross each other.
  const Stroke loop = Stroke::create({.points = {{0, 40},
                                                 {10, 30},
                                                 {20, 20},
                                                 {30, 10},
                                                 {40, 0},
                                                 {-10, 0},
                                                 {0, 10},
                                                 {10, 20},
                                                 {20, 30},
                                                 {30, 40}},
                                      .joints = {JointKind::kCorner, JointKind::kCorner},
                                      .closed = false,
                                      .widths = {{0, 1}, {3, 1}}})
                          .value();
  Fixture fixture;
  const StrokeId id = fixture.add(loop);
  const Span top = span_at(fixture, id, 1.5);
  EXPECT_NEAR(loop.position(top.from).x, 15.0, 1e-6);
  EXPECT_NEAR(loop.position(top.to).x, 15.0, 1e-6);
  EXPECT_LT(top.from, 1.0);
  EXPECT_GT(top.to, 2.0);
  const Span leg = span_at(fixture, id, 0.1);
  EXPECT_EQ(leg.from, 0.0);
  EXPECT_NEAR(leg.to, top.from, 1e-12);
  // One segment with a loop.
  const StrokeId one =
      fixture.add(Stroke::create({.points = {{100, 0}, {140, 30}, {80, 30}, {120, 0}},
                                  .joints = {},
                                  .closed = false,
                                  .widths = {{0, 1}, {1, 1}}})
                      .value());
  const Span bow = span_at(fixture, one, 0.5);
  EXPECT_FALSE(bow.whole);
  EXPECT_NEAR(bow.from + bow.to, 1.0, 1e-9);
}

TEST(CrossingSpan, ASmallBudgetFindsTheSameLater) {
  Fixture fixture;
  std::vector<StrokeId> ids;
  for (std::uint64_t seed = 0; seed < 12; ++seed)
    ids.push_back(fixture.add(testing::random_stroke(seed)));
  for (const StrokeId id : ids) {
    const double n = fixture.document.find(id)->segment_count();
    for (const double share : {0.1, 0.5, 0.83}) {
      const Span all = span_at(fixture, id, share * n), bit = span_at(fixture, id, share * n, 5);
      EXPECT_EQ(all.from, bit.from);
      EXPECT_EQ(all.to, bit.to);
      EXPECT_EQ(all.whole, bit.whole);
    }
  }
}

TEST(CrossingSpan, CopiesUponEachOtherAreBounded) {
  Fixture fixture;
  const Stroke s = testing::random_stroke(5);
  const StrokeId id = fixture.add(s);
  for (int i = 0; i < 5; ++i) fixture.add(s);
  (void)span_at(fixture, id, 0.5);
}

}  // namespace
}  // namespace felt::crossing_span_test
