#include "felt/tools/connect/tip_lead.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "felt/stroke/testing/random_stroke.h"

namespace felt::tip_lead_test {
namespace {

using testing::RandomStroke;
using testing::straight_stroke;

constexpr StrokeTip kBothTips[] = {StrokeTip::kStart, StrokeTip::kEnd};

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
  // The handles at the joints are collinear, because the wave is symmetric about each joint.
  d.widths = {{0.0, 1.0}, {0.3 * segments, 2.0}, {static_cast<double>(segments), 0.5}};
  return Stroke::create(d).value();
}

constexpr double kRadians = std::numbers::pi / 180.0;

/// Returns by how much the tangent turns along the whole stroke, including at joints.
double total_turn_deg(const Stroke& stroke) {
  double turn = 0.0;
  Vec last = tangent(stroke.segment(0), 0.0);
  for (int i = 0; i < stroke.segment_count(); ++i) {
    for (int k = 0; k <= 200; ++k) {
      const Vec t = tangent(stroke.segment(i), k / 200.0);
      turn += angle_between(last, t);
      last = t;
    }
  }
  return turn / kRadians;
}

double added_turn_deg(const Stroke& before, const Stroke& after) {
  return total_turn_deg(after) - total_turn_deg(before);
}

double largest_joint_deg(const Stroke& stroke) {
  double largest = 0.0;
  for (int j = 1; j < stroke.segment_count(); ++j) {
    largest = std::max(largest, angle_between(tangent(stroke.segment(j - 1), 1.0),
                                              tangent(stroke.segment(j), 0.0)));
  }
  return largest / kRadians;
}

TEST(TipLead, PutsTheEndExactlyThereAndTheOtherEndStays) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    RandomStroke random(seed);
    StrokeData data = random.make();
    if (data.closed) continue;
    const Stroke stroke = Stroke::create(data).value();
    for (const StrokeTip tip : kBothTips) {
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
  for (const StrokeTip tip : kBothTips) {
    const auto led = TipLead(stroke, tip).at(tip_point(stroke, tip));
    ASSERT_TRUE(led);
    EXPECT_EQ(*led, stroke);
  }
}

TEST(TipLead, GoesOnAheadAndBendsSideways) {
  const Stroke stroke = straight_stroke({0, 0}, {80, 0}, 1, 2);
  const TipLead lead(stroke, StrokeTip::kEnd);
  const auto ahead = lead.at({140, 0});
  ASSERT_TRUE(ahead);
  EXPECT_EQ(ahead->segment(0), stroke.segment(0));
  EXPECT_EQ(ahead->segment(1), straight({80, 0}, {140, 0}));
  const auto bent = lead.at({80, 14});
  ASSERT_TRUE(bent);
  EXPECT_NEAR(bent->position(1).x, 40.0, 0.01);  // cut halfway; the rest is unchanged
  EXPECT_EQ(bent->position(0.7).y, 0.0);
  EXPECT_GT(bent->position(1.3).y, 0.0);
  // Small gaps keep the tangent of the end.
  EXPECT_EQ(tip_direction(*lead.at({80, 5}), StrokeTip::kEnd), (Vec{1, 0}));
}

TEST(TipLead, R45_TheEndGoesThereOnOneFairCurveWithoutCorners) {
  const double h = 60 * 0.5522847498;  // a quarter of a circle
  StrokeData quarter = straight_stroke({0, 0}, {60, 60}, 1, 2).data();
  quarter.points = {{0, 0}, {h, 0}, {60, 60 - h}, {60, 60}};
  for (const Stroke& stroke :
       {straight_stroke({0, 0}, {80, 0}, 1, 2), Stroke::create(quarter).value()}) {
    for (const StrokeTip tip : kBothTips) {
      const TipLead lead(stroke, tip);
      const Point from = tip_point(stroke, tip);
      const Vec ahead = tip_direction(stroke, tip);
      for (const double way : {2.0, 20.0, 60.0, 200.0}) {
        for (double a = -120; a <= 120; a += 7.5) {
          const double c = std::cos(a * kRadians), s = std::sin(a * kRadians);
          const Vec shift = way * Vec{c * ahead.x - s * ahead.y, s * ahead.x + c * ahead.y};
          const auto led = lead.at(from + shift);
          ASSERT_TRUE(led) << way << " " << a;
          EXPECT_EQ(tip_point(*led, tip), from + shift);
          // The turn is at most 1.5 times the turn to the target. If the target is near and beside
          // the end, the stroke turns towards the target and back, because its end keeps the
          // tangent.
          EXPECT_LE(added_turn_deg(stroke, *led), 1.5 * std::fabs(a) + 40.0) << way << " " << a;
          EXPECT_LE(largest_joint_deg(*led), 1e-6) << way << " " << a;
        }
      }
    }
  }
}

TEST(TipLead, R45_ArrivesInTheDirectionOfTheTarget) {
  const Stroke stroke = straight_stroke({0, 0}, {80, 0}, 1, 2);
  const TipLead lead(stroke, StrokeTip::kEnd);
  for (double a = -90; a <= 90; a += 15) {
    for (double b = -180; b < 180; b += 15) {
      const Point target = Point{80, 0} + 60 * Vec{std::cos(a * kRadians), std::sin(a * kRadians)};
      const Vec arrival{std::cos(b * kRadians), std::sin(b * kRadians)};
      const auto led = lead.at(target, arrival);
      ASSERT_TRUE(led) << a << " " << b;
      EXPECT_EQ(tip_point(*led, StrokeTip::kEnd), target);
      EXPECT_LT(angle_between(tip_direction(*led, StrokeTip::kEnd), arrival), 1e-6)
          << a << " " << b;
      EXPECT_LE(largest_joint_deg(*led), 1e-6) << a << " " << b;
      // Any curve turns towards the target and from there to the direction of arrival. A smooth
      // curve turns slightly more.
      const double needed = std::fabs(a) + std::fabs(std::remainder(b - a, 360.0));
      EXPECT_LE(added_turn_deg(stroke, *led), 1.5 * needed + 20.0) << a << " " << b;
    }
  }
}

TEST(TipLead, OfALongStrokeOnlyTheEndChanges) {
  const Stroke stroke = long_stroke(500, 2500);
  for (const StrokeTip tip : kBothTips) {
    const TipLead lead(stroke, tip);
    for (const double way : {0.1, 1.0, 20.0, 49.0, 300.0}) {
      const auto led = lead.at(tip_point(stroke, tip) + Vec{0, way});
      ASSERT_TRUE(led);
      // The 450 segments at the other end keep their points and widths.
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
}  // namespace felt::tip_lead_test
