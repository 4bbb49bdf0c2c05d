#include "felt/tools/connect/tip_lead.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "felt/stroke/random_stroke.h"

namespace felt {
namespace {

using testing::RandomStroke;
using testing::straight_stroke;

constexpr StrokeTip kTips[] = {StrokeTip::kStart, StrokeTip::kEnd};

/// A wave of many segments, about `length` mm long.
Stroke long_stroke(int segments, double length) {
  StrokeData d;
  const double step = length / segments;
  d.points.push_back({0, 0});
  for (int i = 0; i < segments; ++i) {
    const double x = i * step, y = i % 2 == 0 ? 2.0 : -2.0;
    d.points.insert(d.points.end(), {{x + step / 3, y}, {x + step * 2 / 3, y}, {x + step, 0}});
    if (i > 0) d.joints.push_back(JointKind::kSmooth);
  }
  // Collinear handles at the joints: the wave is symmetric about each.
  d.widths = {{0.0, 1.0}, {0.3 * segments, 2.0}, {static_cast<double>(segments), 0.5}};
  return Stroke::create(d).value();
}

TEST(TipLead, PutsTheEndExactlyThereAndTheOtherEndStays) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    RandomStroke random(seed);
    StrokeData data = random.make();
    if (data.closed) continue;
    const Stroke stroke = Stroke::create(data).value();
    for (const StrokeTip tip : kTips) {
      const double way = std::pow(10.0, random.uniform(-3, 2));
      const double a = random.uniform(0, 2 * std::numbers::pi);
      const Point target = tip_point(stroke, tip) + way * Vec{std::cos(a), std::sin(a)};
      const auto led = TipLead(stroke, tip).at(target);
      ASSERT_TRUE(led) << seed << ": " << led.error().message;
      EXPECT_EQ(tip_point(*led, tip), target) << seed;
      EXPECT_EQ(tip_point(*led, opposite(tip)), tip_point(stroke, opposite(tip))) << seed;
      EXPECT_TRUE(check_invariants(led->data())) << seed;
      const double n0 = stroke.segment_count(), n1 = led->segment_count();
      EXPECT_EQ(led->width_mm(tip == StrokeTip::kStart ? n1 : 0.0),
                stroke.width_mm(tip == StrokeTip::kStart ? n0 : 0.0));
      EXPECT_EQ(led->width_mm(tip == StrokeTip::kStart ? 0.0 : n1),
                stroke.width_mm(tip == StrokeTip::kStart ? 0.0 : n0));
      EXPECT_EQ(led->tone(0.0), stroke.tone(0.0));
      EXPECT_EQ(led->tone(n1), stroke.tone(n0));
    }
  }
}

TEST(TipLead, ComingBackGivesTheStrokeAgain) {
  const Stroke stroke = long_stroke(10, 100);
  for (const StrokeTip tip : kTips) {
    const auto led = TipLead(stroke, tip).at(tip_point(stroke, tip));
    ASSERT_TRUE(led);
    EXPECT_EQ(*led, stroke);
  }
}

TEST(TipLead, BendsAQuarterAndGrowsTheRest) {
  const Stroke stroke = straight_stroke({0, 0}, {80, 0}, 1, 2);
  const TipLead lead(stroke, StrokeTip::kEnd);
  const auto bent = lead.at({80, 20});
  ASSERT_TRUE(bent);
  EXPECT_NEAR(bent->position(1).x, 40.0, 0.01);  // cut half-way, that half as it was
  EXPECT_EQ(bent->position(0.7).y, 0.0);
  EXPECT_GT(bent->position(1.3).y, 0.0);
  const auto grown = lead.at({80, 45});
  ASSERT_TRUE(grown);
  EXPECT_EQ(grown->segment_count(), bent->segment_count() + 1);
  const Cubic piece = grown->segment(grown->segment_count() - 1);
  EXPECT_NEAR(distance(piece.p[0], {80, 20}), 0.0, 1e-12);
  EXPECT_EQ(piece.p[3], (Point{80, 45}));
  EXPECT_EQ(grown->width_mm(grown->segment_count() - 1), 2.0);
}

TEST(TipLead, OfALongStrokeOnlyTheEndChanges) {
  const Stroke stroke = long_stroke(500, 2500);
  for (const StrokeTip tip : kTips) {
    const TipLead lead(stroke, tip);
    for (const double way : {0.1, 1.0, 20.0, 49.0, 300.0}) {
      const auto led = lead.at(tip_point(stroke, tip) + Vec{0, way});
      ASSERT_TRUE(led);
      // 450 segments at the other end: the same points, and the same widths.
      const bool end = tip == StrokeTip::kEnd;
      const auto &a = stroke.data().points, &b = led->data().points;
      const auto skip =
          static_cast<std::ptrdiff_t>(b.size()) - static_cast<std::ptrdiff_t>(a.size());
      for (std::size_t k = 0; k < 3 * 450; ++k) {
        const std::size_t i = end ? k : a.size() - 1 - k;
        ASSERT_EQ(a[i],
                  b[end ? i : static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + skip)]);
      }
      const double shifted = end ? 0 : led->segment_count() - stroke.segment_count();
      for (double u = end ? 0 : 50; u <= (end ? 450 : 500); u += 0.37) {
        ASSERT_NEAR(stroke.width_mm(u), led->width_mm(u + shifted), 1e-12) << u;
      }
    }
  }
}

TEST(TipLead, RefusesPlacesThatAreNone) {
  const TipLead lead(straight_stroke({0, 0}, {80, 0}, 1, 2), StrokeTip::kEnd);
  EXPECT_FALSE(lead.at({std::numeric_limits<double>::quiet_NaN(), 0}));
  EXPECT_FALSE(lead.at({0, std::numeric_limits<double>::infinity()}));
}

}  // namespace
}  // namespace felt
