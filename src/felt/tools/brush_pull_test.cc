#include "felt/tools/brush_pull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "felt/geometry/nearest.h"
#include "felt/stroke/edit/subdivide.h"
#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/stroke/testing/stroke_probe.h"
#include "felt/stroke/testing/test_ink.h"
#include "tests/support/repeats.h"

namespace felt::brush_pull_test {
namespace {

using testing::distance_to;
using testing::random_stroke;
using testing::RandomStroke;
using testing::share;
using testing::straight_stroke;

/// Returns a line of the pencil. A smooth line is as drawn by hand, half a millimetre per sample.
Stroke drawn(std::uint64_t seed, int samples,
             testing::InkShape shape = testing::InkShape::kSmooth) {
  testing::TestInk ink(seed);
  InkFitter fitter{InkFitOptions{}};
  std::int64_t now = 0;
  for (const Point p : ink.draw(shape, samples)) {
    fitter.push({p, 0.5, now += 5'000'000});
  }
  fitter.end();
  fitter.refine();
  return fitter.stroke().value();
}

/// An ellipse of n smooth segments.
Stroke ring(int n, Point c = {50, 50}, double a = 20.0, double b = 12.0) {
  StrokeData d;
  d.closed = true;
  const double step = 2.0 * std::numbers::pi / n;
  const double h = 4.0 / 3.0 * std::tan(step / 4.0);
  const auto at = [&](double x) { return c + Vec{a * std::cos(x), b * std::sin(x)}; };
  const auto along = [&](double x) { return Vec{-a * std::sin(x), b * std::cos(x)}; };
  d.points.push_back(at(0.0));
  for (int i = 0; i < n; ++i) {
    const double x0 = i * step, x1 = (i + 1) * step;
    const Point end = i + 1 == n ? d.points.front() : at(x1);
    d.points.insert(d.points.end(),
                    {d.points.back() + h * along(x0), end - h * along(i + 1 == n ? 0.0 : x1), end});
    d.joints.push_back(JointKind::kSmooth);
  }
  d.widths = {{0.0, 1.0}, {static_cast<double>(n), 1.0}};
  return Stroke::create(std::move(d)).value();
}

double largest_turn_deg(const Stroke& s) {
  double worst = 0.0;
  const int n = s.segment_count();
  for (int j = s.closed() ? 0 : 1; j < n; ++j) {
    if (s.joint(j) != JointKind::kSmooth) continue;
    const Vec in = tangent(s.segment(j > 0 ? j - 1 : n - 1), 1.0);
    worst = std::max(worst, angle_between(in, tangent(s.segment(j), 0.0)));
  }
  return worst * 180.0 / std::numbers::pi;
}

/// Returns true if `after` contains, bit for bit, every segment of `before` that lies outside of
/// its joints first..last.
bool keeps_outside(const Stroke& before, const Stroke& after, double first_u, double last_u) {
  const bool wraps = last_u <= first_u;
  for (int i = 0; i < before.segment_count(); ++i) {
    const bool outside = wraps ? i >= last_u && i + 1 <= first_u : i + 1 <= first_u || i >= last_u;
    if (!outside) continue;
    bool found = false;
    for (int k = 0; k < after.segment_count(); ++k) found |= after.segment(k) == before.segment(i);
    if (!found) return false;
  }
  return true;
}

TEST(BrushPull, R21_TheCurvePassesThroughThePen) {
  double worst = 0.0;
  int pulls = 0;
  const auto strokes = static_cast<std::uint64_t>(repeats(60));
  for (std::uint64_t seed = 0; seed < strokes; ++seed) {
    SCOPED_TRACE(seed);
    const StrokePtr s = share(random_stroke(seed));
    RandomStroke random(seed + 3);
    for (int i = 0; i < s->segment_count(); ++i) {
      for (const double t : {0.0, 1e-9, 0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99, 1.0 - 1e-9, 1.0}) {
        const BrushPull pull(s, i + t, {.radius_mm = random.uniform(1.0, 60.0)});
        const Vec v{random.uniform(-15, 15), random.uniform(-15, 15)};
        const Point pen = s->position(i + t) + v;
        for (const auto& result : {pull.at(v), pull.finished(v)}) {
          if (!result) continue;
          ++pulls;
          worst = std::max(worst, distance_to(*result, pen));
        }
      }
    }
  }
  EXPECT_LE(worst, 1e-9);
  EXPECT_GT(pulls, repeats(3800));
}

TEST(BrushPull, R23_ItDependsOnTheDisplacementAlone) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const StrokePtr s = share(random_stroke(seed));
    RandomStroke random(seed + 5);
    const double u0 = random.uniform(0.0, s->segment_count());
    const BrushPull pull(s, u0), again(s, u0);
    const Vec v{random.uniform(-15, 15), random.uniform(-15, 15)};
    const auto before = pull.at(v);
    for (int k = 0; k < 20; ++k) (void)pull.at({random.uniform(-40, 40), random.uniform(-40, 40)});
    const auto after = pull.at(v);
    const auto other = again.at(v);
    ASSERT_EQ(before.has_value(), after.has_value());
    if (before) {
      EXPECT_EQ(*before, *after);
      EXPECT_EQ(*before, *other);
    }
    EXPECT_EQ(*pull.at({}), *s);
    EXPECT_EQ(*pull.finished({}), *s);
    EXPECT_FALSE(pull.at({std::nan(""), 0.0}));
    EXPECT_FALSE(pull.at({std::numeric_limits<double>::infinity(), 0.0}));
  }
}

TEST(BrushPull, OutsideTheSpanEveryByteStays) {
  int pulls = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const StrokePtr s = share(seed % 2 == 0 ? random_stroke(seed) : drawn(seed, 300));
    RandomStroke random(seed + 5);
    const BrushPull pull(s, random.uniform(0.0, s->segment_count()), {.radius_mm = 6.0});
    const Vec v{random.uniform(-6, 6), random.uniform(-6, 6)};
    for (const auto& result : {pull.at(v), pull.finished(v)}) {
      if (!result) continue;
      ++pulls;
      EXPECT_TRUE(keeps_outside(*s, *result, pull.first_u(), pull.last_u()));
    }
  }
  EXPECT_GT(pulls, 560);
}

TEST(BrushPull, NoPullIsRefused) {
  // Ink of every kind with segments hardly longer than I5 requires. The pull compresses the
  // segments along its direction below that length.
  using testing::InkShape;
  constexpr std::array kShapes = {InkShape::kSmooth, InkShape::kDense,   InkShape::kZigzag,
                                  InkShape::kSpiral, InkShape::kHairpin, InkShape::kFractal};
  int pulls = 0, refused = 0;
  double worst = 0.0;
  for (std::uint64_t seed = 0; pulls < repeats(2000); ++seed) {
    SCOPED_TRACE(seed);
    RandomStroke random(seed + 1);
    const Stroke ink = drawn(seed, 150, kShapes[seed % kShapes.size()]);
    const ArcMap map(ink);
    std::vector<double> us;
    for (double way = 0.0; way < map.length_mm(); way += random.chance(0.5) ? 0.052 : 3.0) {
      us.push_back(map.u_at(way));
    }
    const StrokePtr s = share(subdivided(ink, us).value());
    for (int k = 0; k < 20; ++k, ++pulls) {
      const double u0 = random.uniform(0.0, s->segment_count());
      const BrushPull pull(s, u0);
      const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
      const Vec v = random.uniform(2.0, 25.0) * Vec{std::cos(angle), std::sin(angle)};
      for (const auto& result : {pull.at(v), pull.finished(v)}) {
        refused += result ? 0 : 1;
        EXPECT_TRUE(result) << result.error().message;
        if (result) worst = std::max(worst, distance_to(*result, s->position(u0) + v));
      }
    }
  }
  EXPECT_EQ(refused, 0);
  EXPECT_LE(worst, 1e-9);
}

TEST(BrushPull, TheLiftAddsFewSegmentsAndMovesLittle) {
  // A shaky line already has enough segments for a pull, so the lift adds only few.
  double added = 0.0, moved = 0.0;
  constexpr int kPulls = 60;
  for (std::uint64_t seed = 0; seed < kPulls; ++seed) {
    SCOPED_TRACE(seed);
    const StrokePtr s = share(drawn(seed, 700, testing::InkShape::kDense));
    RandomStroke random(seed + 9);
    const BrushPull pull(s, random.uniform(0.0, s->segment_count()));
    const Vec v{random.uniform(-10, 10), random.uniform(-10, 10)};
    const Stroke held = pull.at(v).value(), left = pull.finished(v).value();
    added += left.segment_count() - s->segment_count();
    for (int k = 0; k <= 400; ++k) {
      const double part = k / 400.0;
      moved = std::max({moved, distance_to(left, held.position(part * held.segment_count())),
                        distance_to(held, left.position(part * left.segment_count()))});
    }
  }
  RecordProperty("segments_added_mean", std::to_string(added / kPulls));
  EXPECT_LE(added, 1.5 * kPulls);
  EXPECT_LE(moved, BrushOptions{}.tolerance_mm + 1e-9);
}

TEST(BrushReach, EndsWithinTheRadiusOfTheGrab) {
  // Includes strokes with a corner that is held.
  int held = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = random_stroke(seed);
    const ArcMap map(s);
    RandomStroke random(seed + 2);
    for (const double radius : {1.0, 3.0, 10.0}) {
      const double u0 = random.uniform(0.0, s.segment_count());
      const BrushReach reach = brush_reach(s, map, u0, {.radius_mm = radius});
      if (reach.is_whole) continue;
      for (const BrushSide& side : {reach.before, reach.after}) {
        held += side.held_mm > 0.0 ? 1 : 0;
        EXPECT_LE(side.held_mm + side.way_mm, radius + 1e-9);
      }
    }
  }
  EXPECT_GT(held, 100);
}

TEST(BrushPull, TheInfluenceFallsOffAlongTheInk) {
  // A straight line of two unequal segments. The pull is away from joints, so that the radius is
  // exact.
  StrokeData d{.points = {{0, 0}, {20, 0}, {40, 0}, {60, 0}, {80, 0}, {90, 0}, {100, 0}},
               .joints = {JointKind::kSmooth},
               .closed = false,
               .widths = {{0.0, 1.0}, {2.0, 3.0}}};
  const StrokePtr s = share(Stroke::create(d).value());
  const double tolerance = 0.03;
  const BrushPull pull(s, 0.5, {.radius_mm = 24.0, .tolerance_mm = tolerance});
  const Stroke pulled = pull.at({0.0, 10.0}).value();
  for (int k = 0; k <= 1000; ++k) {
    const double u = pulled.segment_count() * k / 1000.0;
    const Point p = pulled.position(u);
    EXPECT_NEAR(p.y, 10.0 * influence(std::fabs(p.x - s->position(0.5).x) / 24.0), tolerance);
    // Widths stay with the ink. Here they are a function of x, by u of the original line.
    const double was = p.x < 60.0 ? 0.0 : 1.0;
    if (std::fabs(p.x - 60.0) > 1e-6 && p.x < 60.0) {
      EXPECT_NEAR(pulled.width_mm(u), 1.0 + (was + p.x / 60.0), 1e-6);
    }
  }
}

TEST(BrushPull, FollowsTheExactDisplacementOnCurvedInk) {
  const double tolerance = 0.03;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const StrokePtr s = share(drawn(seed, 400));
    const ArcMap map(*s);
    const BrushOptions options{.radius_mm = 15.0, .free_ends = true, .tolerance_mm = tolerance};
    const double u0 = 0.5 * s->segment_count();
    const BrushPull pull(s, u0, options);
    const BrushReach reach = brush_reach(*s, map, u0, options);
    const Vec v{6.0, -5.0};
    const auto pulled = pull.at(v);
    ASSERT_TRUE(pulled);
    for (double way = -20.0; way <= 20.0; way += 0.5) {
      const double place = reach.grab_mm + way;
      if (place < 0.0 || place > map.length_mm()) continue;
      const BrushSide& side = way < 0.0 ? reach.before : reach.after;
      const Point exact = s->position(map.u_at(place)) +
                          influence((std::fabs(way) - side.held_mm) / side.radius_mm) * v;
      EXPECT_LE(distance_to(*pulled, exact), tolerance);
    }
  }
}

TEST(BrushReach, OfAnOpenLineThatIsShorterIsAllOfIt) {
  const Stroke s = straight_stroke({0, 0}, {30, 0}, 1, 1);
  const ArcMap map(s);
  const BrushReach reach = brush_reach(s, map, 0.5, {.radius_mm = 100.0});
  EXPECT_EQ(reach.first_u(map), 0.0);
  EXPECT_EQ(reach.last_u(map), 1.0);
  const BrushPull pull(share(s), 0.5, {.radius_mm = 100.0});
  EXPECT_EQ(pull.first_u(), 0.0);
  EXPECT_EQ(pull.last_u(), 1.0);
  const Stroke r = pull.at({0.0, 5.0}).value();
  EXPECT_EQ(r.segment_count(), 2);
  EXPECT_LE(distance(r.position(1.0), {15, 5}), 1e-12);
}

TEST(BrushPull, R26_EndsAndCornersStayUnlessTakenHoldOf) {
  StrokeData d{.points = {{0, 0}, {10, 0}, {20, 0}, {30, 0}, {30, 10}, {30, 20}, {30, 30}},
               .joints = {JointKind::kCorner},
               .closed = false,
               .widths = {{0.0, 1.0}, {2.0, 1.0}}};
  const StrokePtr s = share(Stroke::create(d).value());
  const Vec v{-3.0, 8.0};
  {
    const Stroke r = BrushPull(s, 0.5, {.radius_mm = 50.0}).at(v).value();
    EXPECT_EQ(r.data().points.front(), s->data().points.front());
    EXPECT_EQ(tangent(r.segment(0), 0.0), (Vec{1.0, 0.0}));
    const int last = r.segment_count() - 1;
    EXPECT_EQ(r.segment(last), s->segment(1));
    EXPECT_EQ(r.joint(last), JointKind::kCorner);
    EXPECT_LE(angle_between(tangent(r.segment(last - 1), 1.0), {1.0, 0.0}), 1e-12);
  }
  for (const double u0 : {0.95, 1.0, 1.06}) {  // within 2 mm of the corner
    const Stroke r = BrushPull(s, u0, {.radius_mm = 20.0}).at(v).value();
    EXPECT_LE(distance_to(r, Point{30, 0} + v), 1e-12);
    EXPECT_LE(distance_to(r, s->position(u0) + v), 1e-12);
    EXPECT_EQ(std::count(r.data().joints.begin(), r.data().joints.end(), JointKind::kCorner), 1);
    for (int j = 1; j < r.segment_count(); ++j) {
      if (r.joint(j) != JointKind::kCorner) continue;
      EXPECT_LE(distance(r.position(j), Point{30, 0} + v), 1e-12);
      EXPECT_LE(angle_between(tangent(r.segment(j - 1), 1.0), {1.0, 0.0}), 1e-9);
      EXPECT_LE(angle_between(tangent(r.segment(j), 0.0), {0.0, 1.0}), 1e-9);
    }
  }
  {
    const Stroke r = BrushPull(s, 0.0, {.radius_mm = 20.0}).at(v).value();
    EXPECT_LE(distance(r.data().points.front(), Point{0, 0} + v), 1e-12);
    EXPECT_EQ(r.data().points.back(), s->data().points.back());
  }
  {
    const BrushPull free(s, 0.5, {.radius_mm = 50.0, .free_ends = true});
    const Stroke r = free.at(v).value();
    const double w = influence(15.0 / 50.0);
    EXPECT_LE(distance(r.data().points.front(), Point{0, 0} + w * v), 1e-9);
    EXPECT_LE(distance_to(r, Point{30, 0} + w * v), 1e-9);
    EXPECT_EQ(std::count(r.data().joints.begin(), r.data().joints.end(), JointKind::kCorner), 1);
  }
}

TEST(BrushPull, R26_ClosedStrokesWrapOneAndTwoSegmentsIncluded) {
  for (const int n : {1, 2, 3, 8}) {
    // A closed stroke of one segment: a drop with a smooth seam.
    const Stroke drop = Stroke::create({.points = {{20, 20}, {60, 20}, {-20, 20}, {20, 20}},
                                        .joints = {JointKind::kCorner},
                                        .closed = true,
                                        .widths = {{0.0, 1.0}, {1.0, 1.0}}})
                            .value();
    Stroke loop = drop;
    if (n == 1) {
      StrokeData d = drop.data();
      d.points = {{20, 20}, {60, 20}, {30, 70}, {20, 20}};
      loop = Stroke::create(d).value();
    } else {
      loop = ring(n);
    }
    const StrokePtr s = share(loop);
    for (const double radius : {3.0, 12.0, 30.0, 200.0}) {
      const int places = repeats(40);
      for (int k = 0; k <= places; ++k) {
        SCOPED_TRACE(std::to_string(n) + " " + std::to_string(radius) + " " + std::to_string(k));
        const double u0 = double(n) * k / places;
        for (const bool is_free : {false, true}) {
          const BrushPull pull(s, u0, {.radius_mm = radius, .free_ends = is_free});
          for (const Vec v : {Vec{4.0, 3.0}, Vec{-9.0, 2.0}, Vec{0.0, -30.0}}) {
            for (const auto& result : {pull.at(v), pull.finished(v)}) {
              ASSERT_TRUE(result) << result.error().message;
              EXPECT_TRUE(result->closed());
              EXPECT_LE(distance_to(*result, s->position(u0) + v), 1e-9);
              EXPECT_LE(largest_turn_deg(*result), 1e-6);
              EXPECT_TRUE(keeps_outside(*s, *result, pull.first_u(), pull.last_u()));
            }
          }
        }
      }
    }
  }
}

TEST(BrushPull, R28_StandingHandlesDoNoHarm) {
  // Handles of zero length on both sides of smooth joints, at ends, and everywhere.
  StrokeData d{.points = {{0, 0},
                          {0, 0},
                          {20, 5},
                          {20, 5},
                          {20, 5},
                          {40, 10},
                          {40, 10},
                          {40, 10},
                          {60, 15},
                          {60, 15}},
               .joints = {JointKind::kSmooth, JointKind::kSmooth},
               .closed = false,
               .widths = {{0.0, 1.0}, {3.0, 1.0}}};
  const StrokePtr s = share(Stroke::create(d).value());
  for (int k = 0; k <= 60; ++k) {
    SCOPED_TRACE(k);
    for (const Vec v : {Vec{5.0, 8.0}, Vec{-1.0, 0.5}, Vec{0.0, 1e-7}, Vec{-30.0, 20.0}}) {
      for (const bool is_free : {false, true}) {
        const BrushPull pull(s, k / 20.0, {.radius_mm = 18.0, .free_ends = is_free});
        const auto r = pull.at(v);
        ASSERT_TRUE(r) << r.error().message;
        EXPECT_LE(largest_turn_deg(*r), 1e-6);
        EXPECT_LE(distance_to(*r, s->position(k / 20.0) + v), 1e-9);
      }
    }
  }
}

TEST(BrushPull, InkThatIsPushedTogetherFoldsAndStaysValid) {
  const StrokePtr s = share(straight_stroke({0, 0}, {100, 0}, 1, 1));
  const BrushPull pull(s, 0.5, {.radius_mm = 20.0});
  int failures = 0;
  for (int k = -600; k <= 600; ++k) {
    for (const double y : {0.0, 1e-9, 0.01, 3.0}) {
      const auto r = pull.at({0.1 * k, y});
      failures += r ? 0 : 1;
      if (r) {
        EXPECT_LE(distance_to(*r, Point{50.0 + 0.1 * k, y}), 1e-9);
      }
    }
  }
  EXPECT_EQ(failures, 0);
}

/// Returns the point on a stroke nearest to p.
Nearest nearest_on(const Stroke& s, Point p) {
  Nearest best{.t = 0.0, .distance_squared = std::numeric_limits<double>::infinity(), .point = {}};
  for (int i = 0; i < s.segment_count(); ++i) {
    const Nearest near = nearest(s.segment(i), p);
    if (near.distance_squared < best.distance_squared) best = near;
  }
  return best;
}

constexpr int kManyPulls = repeats(10'000);

TEST(BrushPull, R24_TenThousandPullsLeaveAGoodLine) {
  const Stroke first = drawn(1, 200);
  const double length = ArcMap(first).length_mm();
  StrokePtr s = share(first);
  RandomStroke random(1);
  double worst_turn = 0.0, longest = 0.0, min_handle = 1.0;
  int largest = 0, refused = 0;
  for (int k = 0; k < kManyPulls; ++k) {
    // Random pulls to a position within 2 mm of the original line, repeatedly out and back.
    const double u0 = random.uniform(0.0, s->segment_count());
    const Point home = nearest_on(first, s->position(u0)).point;
    const Point pen = home + Vec{random.uniform(-1.4, 1.4), random.uniform(-1.4, 1.4)};
    const auto next = BrushPull(s, u0).finished(pen - s->position(u0));
    if (!next) {
      ++refused;
      continue;
    }
    s = share(*next);
    worst_turn = std::max(worst_turn, largest_turn_deg(*s));
    largest = std::max(largest, s->segment_count());
    if (k % 100 == 0) longest = std::max(longest, ArcMap(*s, 1e-3).length_mm());
  }
  for (int i = 0; i < s->segment_count(); ++i) {
    const Cubic c = s->segment(i);
    const double handle = std::min(distance(c.p[0], c.p[1]), distance(c.p[2], c.p[3]));
    min_handle = std::min(min_handle, handle / arc_length(c));
  }
  RecordProperty("segments_before", first.segment_count());
  RecordProperty("segments_after", s->segment_count());
  RecordProperty("segments_most", largest);
  RecordProperty("length_before_mm", std::to_string(length));
  RecordProperty("length_after_mm", std::to_string(ArcMap(*s).length_mm()));
  RecordProperty("length_longest_mm", std::to_string(longest));
  EXPECT_LE(worst_turn, 1e-6);
  EXPECT_LE(largest, 3 * first.segment_count());
  EXPECT_LE(s->segment_count(), 2 * first.segment_count());
  EXPECT_LE(longest, length + 2.0 * 10.0);
  EXPECT_GE(min_handle, 0.02);
  EXPECT_LE(s->widths().size(), static_cast<std::size_t>(s->segment_count()) + 20u);
  EXPECT_EQ(refused, 0);
}

}  // namespace
}  // namespace felt::brush_pull_test
