#include "felt/geometry/intersect.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "felt/geometry/testing/nearest_cases.h"

namespace felt::intersect_test {
namespace {

constexpr int kSteps = 1500;

std::vector<Point> polyline_of(const Cubic& c) {
  std::vector<Point> points;
  for (int i = 0; i <= kSteps; ++i) points.push_back(evaluate(c, static_cast<double>(i) / kSteps));
  return points;
}

struct Place {
  double t1, t2;
};

/// Returns the proper crossings of the chords of two finely sampled curves.
std::vector<Place> sampled_crossings(const std::vector<Point>& a, const std::vector<Point>& b,
                                     bool same) {
  std::vector<Place> places;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    for (std::size_t j = same ? i + 2 : 0; j + 1 < b.size(); ++j) {
      if (std::max(a[i].x, a[i + 1].x) < std::min(b[j].x, b[j + 1].x) ||
          std::max(b[j].x, b[j + 1].x) < std::min(a[i].x, a[i + 1].x)) {
        continue;
      }
      const Vec da = a[i + 1] - a[i], db = b[j + 1] - b[j], from = b[j] - a[i];
      const double det = cross(da, db);
      // Nearly parallel chords do not prove a crossing of the curves.
      if (std::fabs(det) < 1e-2 * norm(da) * norm(db)) continue;
      const double s = cross(from, db) / det, t = cross(from, da) / det;
      if (s < 0.01 || s > 0.99 || t < 0.01 || t > 0.99) continue;
      places.push_back(
          {(static_cast<double>(i) + s) / kSteps, (static_cast<double>(j) + t) / kSteps});
    }
  }
  return places;
}

void check_places(const Cubic& f, const Cubic& g, const Crossings& found) {
  double last = -1.0;
  for (const Crossing& c : found) {
    ASSERT_TRUE(c.t1 >= 0.0 && c.t1 <= 1.0 && c.t2 >= 0.0 && c.t2 <= 1.0);
    ASSERT_LE(distance(evaluate(f, c.t1), evaluate(g, c.t2)), 1.1 * kMeetMm);
    ASSERT_EQ(c.point, evaluate(f, c.t1));
    ASSERT_GE(c.t1, last);
    last = c.t1;
  }
}

bool has(const Crossings& found, double t1, double t2, double within) {
  return std::any_of(found.begin(), found.end(), [&](const Crossing& c) {
    return std::fabs(c.t1 - t1) <= within && std::fabs(c.t2 - t2) <= within;
  });
}

TEST(Intersect, FindsEveryCrossingThatDenseSamplingFindsOnAnyKindOfCubic) {
  int crossings = 0;
  for (int k = 0; k < kCaseKinds; ++k) {
    if (static_cast<CaseKind>(k) == CaseKind::kTiny)
      continue;  // smaller than the check's tolerance
    for (unsigned seed = 0; seed < 24; ++seed) {
      std::mt19937_64 random(1000U * static_cast<unsigned>(k) + seed);
      const Cubic f = make_case(static_cast<CaseKind>(k), random).curve;
      const Cubic g = make_case(static_cast<CaseKind>(seed % 3 == 0 ? k : 0), random).curve;
      const Crossings found = intersections(f, g);
      ASSERT_TRUE(found.complete) << "kind " << k << ", seed " << seed << ", pairs " << found.pairs;
      check_places(f, g, found);
      for (const Place& p : sampled_crossings(polyline_of(f), polyline_of(g), false)) {
        ++crossings;
        EXPECT_TRUE(has(found, p.t1, p.t2, 4.0 / kSteps))
            << "kind " << k << ", seed " << seed << ": " << p.t1 << ", " << p.t2;
      }
    }
  }
  EXPECT_GT(crossings, 60);
}

TEST(Intersect, DoesNotReportAPlaceTwice) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 2000; ++i) {
    const Cubic f = make_case(CaseKind::kRandom, random).curve;
    const Cubic g = make_case(CaseKind::kLoop, random).curve;
    const Crossings found = intersections(f, g);
    ASSERT_LE(found.count, 9u) << "Bezout, case " << i;
    for (std::size_t a = 0; a + 1 < found.count; ++a) {
      for (std::size_t b = a + 1; b < found.count; ++b) {
        ASSERT_FALSE(std::fabs(found.places[a].t1 - found.places[b].t1) < 1e-9 &&
                     std::fabs(found.places[a].t2 - found.places[b].t2) < 1e-9);
      }
    }
  }
}

RC_GTEST_PROP(Intersect, TheOrderOfTheTwoDoesNotMatter, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const Cubic f = make_case(static_cast<CaseKind>(*rc::gen::inRange(0, 8)), random).curve;
  const Cubic g = make_case(static_cast<CaseKind>(*rc::gen::inRange(0, 8)), random).curve;
  const Crossings one = intersections(f, g), other = intersections(g, f);
  for (const Crossing& c : one) {
    if (c.kind != Crossing::Kind::kCross) continue;
    // Compares points, because t is inaccurate at a zero handle.
    RC_ASSERT(std::any_of(other.begin(), other.end(),
                          [&](const Crossing& o) { return distance(o.point, c.point) <= 1e-6; }));
  }
}

TEST(Intersect, StraightLinesCrossWhereTheyShould) {
  const Crossings x = intersections(straight({0, 0}, {10, 10}), straight({0, 10}, {10, 0}));
  ASSERT_EQ(x.count, 1u);
  EXPECT_NEAR(x.places[0].t1, 0.5, 1e-15);
  EXPECT_EQ(x.places[0].kind, Crossing::Kind::kCross);
  EXPECT_EQ(intersections(straight({0, 0}, {1, 0}), straight({0, 1}, {1, 1})).count, 0u);
  EXPECT_EQ(intersections(straight({0, 0}, {1, 0}), straight({2, 0}, {3, 0})).count, 0u);
}

TEST(Intersect, NineCrossingsOfTwoCubics) {
  // Each curve is a wave that crosses the three branches of the other curve.
  const Cubic f{{Point{0, 0}, {40, 100}, {-10, -60}, {30, 35}}};
  const Cubic g{{Point{0, 0}, {100, 40}, {-60, -10}, {35, 30}}};
  const Crossings found = intersections(f, g);
  EXPECT_TRUE(found.complete);
  check_places(f, g, found);
  const auto truth = sampled_crossings(polyline_of(f), polyline_of(g), false);
  EXPECT_GE(truth.size(), 5u);
  for (const Place& p : truth) EXPECT_TRUE(has(found, p.t1, p.t2, 2.0 / kSteps));
}

TEST(Intersect, EndsOnTheOtherAndSharedEndsCount) {
  const Cubic base = straight({0, 0}, {10, 0});
  const Crossings tee = intersections(base, straight({4, 0}, {4, 5}));
  ASSERT_EQ(tee.count, 1u);
  EXPECT_NEAR(tee.places[0].t1, 0.4, 1e-12);
  EXPECT_NEAR(tee.places[0].t2, 0.0, 1e-12);
  // A smooth joint: the next segment starts where this one ends.
  const auto [left, right] = split(Cubic{{Point{0, 0}, {10, 20}, {30, -20}, {40, 5}}}, 0.4);
  const Crossings joint = intersections(left, right);
  ASSERT_EQ(joint.count, 1u);
  EXPECT_NEAR(joint.places[0].t1, 1.0, 1e-4);
  EXPECT_LT(joint.pairs, 200);
  const Crossings collinear = intersections(base, straight({10, 0}, {20, 0}));
  ASSERT_EQ(collinear.count, 1u);
  EXPECT_NEAR(collinear.places[0].point.x, 10.0, 1e-9);
}

TEST(Intersect, ATangentIsOnePlace) {
  for (const double height : {1.0, 10.0, 100.0}) {
    const Cubic arch{{Point{0, 0}, {10, height}, {30, height}, {40, 0}}};
    const double top = evaluate(arch, 0.5).y;
    const Crossings touch = intersections(arch, straight({-5, top}, {50, top}));
    ASSERT_EQ(touch.count, 1u) << height;
    EXPECT_EQ(touch.places[0].kind, Crossing::Kind::kTouch);
    EXPECT_NEAR(touch.places[0].t1, 0.5, 1e-4);
    EXPECT_LT(touch.pairs, 1000);
    // A slightly lower line crosses the arch twice, a slightly higher one never.
    EXPECT_EQ(intersections(arch, straight({-5, top - 1e-5}, {50, top - 1e-5})).count, 2u);
    EXPECT_EQ(intersections(arch, straight({-5, top + 1e-5}, {50, top + 1e-5})).count, 0u);
  }
}

TEST(Intersect, OverlapsReportTheirTwoEnds) {
  const Cubic c{{Point{0, 0}, {10, 20}, {30, -20}, {40, 5}}};
  const auto check = [&](const Cubic& a, const Cubic& b, Point from, Point to) {
    const Crossings found = intersections(a, b);
    EXPECT_TRUE(found.complete) << found.pairs;
    EXPECT_LT(found.pairs, 500);
    check_places(a, b, found);
    ASSERT_EQ(found.count, 2u);
    EXPECT_EQ(found.places[0].kind, Crossing::Kind::kOverlap);
    EXPECT_EQ(found.places[1].kind, Crossing::Kind::kOverlap);
    EXPECT_LE(distance(found.places[0].point, from), 1e-7);
    EXPECT_LE(distance(found.places[1].point, to), 1e-7);
  };
  check(c, c, c.p[0], c.p[3]);
  check(c, reversed(c), c.p[0], c.p[3]);
  check(c, sub_segment(c, 0.2, 0.7), evaluate(c, 0.2), evaluate(c, 0.7));
  check(sub_segment(c, 0.0, 0.6), sub_segment(c, 0.3, 1.0), evaluate(c, 0.3), evaluate(c, 0.6));
  check(straight({0, 0}, {10, 0}), straight({4, 0}, {20, 0}), {4, 0}, {10, 0});
  const Cubic ring{{Point{0, 0}, {30, 40}, {-30, 40}, {0, 0}}};
  const Crossings rings = intersections(ring, ring);
  EXPECT_TRUE(rings.complete);
  EXPECT_GE(rings.count, 1u);
}

TEST(Intersect, WorkIsBounded) {
  // Nearly the same curve: closer than the width of a fat line of any reasonable size.
  const Cubic c{{Point{0, 0}, {100, 200}, {300, -200}, {400, 50}}};
  Cubic near = c;
  for (Point& p : near.p) p.y += 1e-8;
  EXPECT_LE(intersections(c, near).pairs, kIntersectPairs);
  EXPECT_LE(intersections(c, near, 50).pairs, 50);
  EXPECT_FALSE(intersections(c, near, 50).complete);
}

TEST(Intersect, DegenerateCubicsHaveAnAnswer) {
  const Cubic point{{Point{5, 0}, {5, 0}, {5, 0}, {5, 0}}};
  const Cubic line = straight({0, 0}, {10, 0});
  EXPECT_EQ(intersections(point, line).count, 1u);
  EXPECT_EQ(intersections(line, point).count, 1u);
  EXPECT_EQ(intersections(point, point).count, 1u);
  const Cubic fold{{Point{0, 0}, {20, 0}, {20, 0}, {0, 0}}};
  EXPECT_GE(intersections(fold, straight({3, -5}, {3, 5})).count, 2u);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    Cubic broken = line;
    broken.p[2].x = bad;
    EXPECT_EQ(intersections(broken, line).count, 0u);
    EXPECT_EQ(intersections(line, broken).count, 0u);
    EXPECT_FALSE(self_intersection(broken));
  }
}

TEST(Intersect, SelfCrossingsAreThoseOfDenseSampling) {
  int loops = 0;
  for (const CaseKind kind : {CaseKind::kRandom, CaseKind::kLoop, CaseKind::kNearLine,
                              CaseKind::kCusp, CaseKind::kDoubledEnds}) {
    for (unsigned seed = 0; seed < 40; ++seed) {
      std::mt19937_64 random(seed);
      const Cubic c = make_case(kind, random).curve;
      const auto found = self_intersection(c);
      if (found) {
        ASSERT_LT(found->t1, found->t2);
        ASSERT_LE(distance(evaluate(c, found->t1), evaluate(c, found->t2)), 1.1 * kMeetMm);
      }
      const auto line = polyline_of(c);
      for (const Place& p : sampled_crossings(line, line, true)) {
        ++loops;
        ASSERT_TRUE(found) << "seed " << seed;
        EXPECT_NEAR(found->t1, p.t1, 2.0 / kSteps);
        EXPECT_NEAR(found->t2, p.t2, 2.0 / kSteps);
      }
    }
  }
  EXPECT_GT(loops, 20);
}

TEST(Intersect, AClosedLoopMeetsItselfAtItsEnds) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937_64 random(seed);
    Cubic c = make_case(CaseKind::kRandom, random).curve;
    c.p[3] = c.p[0];
    const auto found = self_intersection(c);
    ASSERT_TRUE(found) << "seed " << seed;
    EXPECT_NEAR(found->t1, 0.0, 1e-9);
    EXPECT_NEAR(found->t2, 1.0, 1e-9);
  }
  EXPECT_FALSE(self_intersection(straight({0, 0}, {1, 1})));
  EXPECT_FALSE(self_intersection(Cubic{{Point{0, 0}, {1, 1}, {0, 1}, {1, 0}}})) << "a cusp";
}

}  // namespace
}  // namespace felt::intersect_test
