#include "felt/tools/eraser/swept.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "felt/geometry/polyline.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/tools/eraser/below_zero.h"

namespace felt::swept_test {
namespace {

using testing::RandomStroke;
using testing::straight_stroke;

double bernstein(const std::vector<double>& c, double t) {
  std::vector<double> v = c;
  for (std::size_t step = 1; step < v.size(); ++step) {
    for (std::size_t k = 0; k + step < v.size(); ++k) v[k] = (1 - t) * v[k] + t * v[k + 1];
  }
  return v[0];
}

bool in_parts(const UnitParts& parts, double t) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const UnitParts::Part& p) { return t > p.from && t < p.to; });
}

RC_GTEST_PROP(BelowZero, AgreesWithTheSignEverywhere, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<double> c(2 + random() % 6);
  for (double& x : c) x = random() % 6 == 0 ? 0.0 : value(random);
  const UnitParts parts = below_zero(c);
  double last = -1.0;
  for (const auto& p : parts) {
    RC_ASSERT(p.from > last && p.from < p.to && p.from >= 0.0 && p.to <= 1.0);
    last = p.to;
    for (const double end : {p.from, p.to}) {
      RC_ASSERT(end == 0.0 || end == 1.0 || std::fabs(bernstein(c, end)) < 1e-13);
    }
  }
  for (int i = 0; i <= 3000; ++i) {
    const double t = i / 3000.0, v = bernstein(c, t);
    if (std::fabs(v) > 1e-13 && t > 0.0 && t < 1.0) {
      RC_ASSERT(in_parts(parts, t) == (v < 0.0));
    }
  }
}

TEST(BelowZero, MissesNoNarrowDip) {
  // (t - m)^2 - depth in Bernstein form.
  for (const double m : {0.5, 0.1, 0.77777}) {
    for (const double depth : {1e-2, 1e-6, 1e-10}) {
      const std::array<double, 3> dip{m * m - depth, m * m - m - depth, (1 - m) * (1 - m) - depth};
      const UnitParts parts = below_zero(dip);
      ASSERT_FALSE(parts.empty()) << m << ", " << depth;
      EXPECT_NEAR(parts.begin()->from, m - std::sqrt(depth), 1e-9);
      EXPECT_NEAR((parts.end() - 1)->to, m + std::sqrt(depth), 1e-9);
    }
  }
  const std::array<double, 3> touch{0.25, -0.25, 0.25};
  EXPECT_TRUE(below_zero(touch).empty()) << "it touches zero, and is nowhere below";
  EXPECT_TRUE(below_zero(std::array<double, 2>{std::nan(""), -1.0}).empty());
  EXPECT_EQ(*below_zero(std::array<double, 2>{0.0, -1.0}).begin(), (UnitParts::Part{0.0, 1.0}));
}

TEST(ParameterSet, UnitesWhateverTheOrder) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937_64 random(seed);
    std::vector<ParameterSet::Interval> parts;
    for (int i = 0; i < 20; ++i) {
      const double from = static_cast<double>(random() % 100);
      parts.push_back({from, from + static_cast<double>(random() % 8)});
    }
    ParameterSet one, other;
    for (const auto& p : parts) one.add(p);
    std::shuffle(parts.begin(), parts.end(), random);
    for (const auto& p : parts) {
      const bool known = other.contains(p) || p.from >= p.to;
      EXPECT_EQ(other.add(p), !known);
      EXPECT_TRUE(other.contains(p) || p.from >= p.to);
    }
    EXPECT_EQ(one, other) << "seed " << seed;
    for (std::size_t i = 0; i + 1 < one.intervals().size(); ++i) {
      EXPECT_LT(one.intervals()[i].to, one.intervals()[i + 1].from);
    }
  }
}

Capsule random_capsule(RandomStroke& make) {
  const auto place = [&] { return Point{make.uniform(-2, 22), make.uniform(-2, 22)}; };
  const Point from = place();
  Point to = make.chance(0.3) ? place() : from + Vec{make.uniform(-1, 1), make.uniform(-1, 1)};
  if (make.chance(0.2)) to = from;
  return {from, to, make.chance(0.5) ? 2.0 : make.uniform(0.2, 5.0), make.chance(0.5)};
}

double radius_at(const Stroke& stroke, const Capsule& c, double u) {
  return c.radius_mm + (c.adds_half_width ? 0.5 * stroke.width_mm(u) : 0.0);
}

bool is_in(const ParameterSet& set, double u) {
  const auto& all = set.intervals();
  return std::any_of(all.begin(), all.end(), [&](const auto& i) { return u > i.from && u < i.to; });
}

TEST(Swept, R39_IsWhatLiesInTheCapsuleAndNothingElse) {
  int inside = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    RandomStroke make(seed);
    const Stroke stroke = Stroke::create(make.make()).value();
    const Capsule capsule = random_capsule(make);
    ParameterSet swept;
    for (int i = 0; i < stroke.segment_count(); ++i) add_swept(stroke, i, capsule, swept);
    const auto depth = [&](double u) {
      const Point p = stroke.position(u);
      return radius_at(stroke, capsule, u) -
             std::sqrt(nearest_on_line(capsule.from, capsule.to, p).distance_squared);
    };
    const int n = stroke.segment_count();
    for (int k = 1; k < 1000 * n; ++k) {
      const double u = k / 1000.0, d = depth(u);
      if (std::fabs(d) < 1e-9) continue;
      ASSERT_EQ(is_in(swept, u), d > 0.0) << "seed " << seed << ", u " << u << ", depth " << d;
      inside += d > 0.0 ? 1 : 0;
    }
    for (const auto& i : swept.intervals()) {
      for (const double end : {i.from, i.to}) {
        const bool is_cut = end > 0.0 && end < n;
        EXPECT_LE(is_cut ? std::fabs(depth(end)) : 0.0, 1e-9) << "seed " << seed;
      }
    }
  }
  EXPECT_GT(inside, 10'000);
}

TEST(Swept, R39_OneStepIsAHundredSubsteps) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    RandomStroke make(seed);
    const Stroke stroke = Stroke::create(make.make()).value();
    const Capsule whole = random_capsule(make);
    ParameterSet one, many;
    for (int i = 0; i < stroke.segment_count(); ++i) {
      add_swept(stroke, i, whole, one);
      for (int k = 0; k < 100; ++k) {
        Capsule part = whole;
        part.from = lerp(whole.from, whole.to, k / 100.0);
        part.to = lerp(whole.from, whole.to, (k + 1) / 100.0);
        add_swept(stroke, i, part, many);
      }
    }
    ASSERT_EQ(one.intervals().size(), many.intervals().size()) << "seed " << seed;
    for (std::size_t k = 0; k < one.intervals().size(); ++k) {
      const auto a = one.intervals()[k], b = many.intervals()[k];
      EXPECT_LE(distance(stroke.position(a.from), stroke.position(b.from)), 1e-6);
      EXPECT_LE(distance(stroke.position(a.to), stroke.position(b.to)), 1e-6);
    }
  }
}

TEST(Swept, AGrazeIsFound) {
  for (const double depth : {1e-3, 1e-6, 1e-9}) {
    const Stroke line = straight_stroke({-50, 2.0 - depth}, {37, 2.0 - depth}, 1, 1);
    ParameterSet swept;
    EXPECT_TRUE(add_swept(line, 0, {{0, 0}, {0, 0}, 2.0, false}, swept));
    ASSERT_EQ(swept.intervals().size(), 1u);
    const auto hole = swept.intervals()[0];
    EXPECT_NEAR(distance(line.position(hole.from), line.position(hole.to)),
                2.0 * std::sqrt(4.0 * depth - depth * depth), 1e-6);
    const Stroke beyond = straight_stroke({-50, 2.0 + depth}, {37, 2.0 + depth}, 1, 1);
    EXPECT_FALSE(add_swept(beyond, 0, {{0, 0}, {0, 0}, 2.0, false}, swept));
  }
}

TEST(Swept, BroadInkIsReachedFromFartherAway) {
  const Stroke wedge = straight_stroke({0, 4}, {10, 4}, 0.1, 8.0);
  ParameterSet middle, ink;
  EXPECT_FALSE(add_swept(wedge, 0, {{-5, 0}, {15, 0}, 2.0, false}, middle));
  EXPECT_TRUE(add_swept(wedge, 0, {{-5, 0}, {15, 0}, 2.0, true}, ink));
  ASSERT_EQ(ink.intervals().size(), 1u);
  EXPECT_NEAR(wedge.width_mm(ink.intervals()[0].from), 4.0, 1e-9);
  EXPECT_EQ(ink.intervals()[0].to, 1.0);
}

}  // namespace
}  // namespace felt::swept_test
