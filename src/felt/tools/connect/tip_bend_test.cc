#include "felt/tools/connect/tip_bend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "felt/stroke/testing/random_stroke.h"

namespace felt::tip_bend_test {
namespace {

using testing::RandomStroke;
using testing::straight_stroke;

constexpr StrokeTip kTips[] = {StrokeTip::kStart, StrokeTip::kEnd};

double length_mm(const Stroke& s) {
  double length = 0.0;
  for (int i = 0; i < s.segment_count(); ++i) length += arc_length(s.segment(i));
  return length;
}

TEST(TipBend, FollowsItsLawAlongTheStroke) {
  // A straight line with segments of different lengths, so that u is not proportional to the
  // length.
  const Stroke line = Stroke::create({.points = {{0, 0},
                                                 {1, 0},
                                                 {9, 0},
                                                 {10, 0},
                                                 {11, 0},
                                                 {12, 0},
                                                 {40, 0},
                                                 {60, 0},
                                                 {61, 0},
                                                 {80, 0}},
                                      .joints = {JointKind::kSmooth, JointKind::kSmooth},
                                      .closed = false,
                                      .widths = {{0, 1}, {3, 2}}})
                          .value();
  const double reach = 36.0, shift = 9.0;
  const Stroke bent = with_tip_bent(line, StrokeTip::kEnd, {80, shift}, reach).value();
  for (double u = 0; u <= bent.segment_count(); u += 0.01) {
    const Point p = bent.position(u);
    const double x = std::min((80 - p.x) / reach, 1.0);
    EXPECT_NEAR(p.y, shift * (1 - 3 * x * x + 2 * x * x * x), 0.08 * shift) << u;
  }
  EXPECT_EQ(tip_direction(bent, StrokeTip::kEnd), (Vec{1, 0}));
}

TEST(TipBend, RandomStrokesKeepTheirInvariantsTangentAndTheRest) {
  int bent_count = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    RandomStroke random(seed);
    const StrokeData data = random.make();
    if (data.closed) continue;
    const Stroke stroke = Stroke::create(data).value();
    const double reach = random.uniform(0.2, 0.9) * length_mm(stroke);
    const double way = random.uniform(0.0, 0.45) * reach, a = random.uniform(0, 6.28);
    for (const StrokeTip tip : kTips) {
      const Point target = tip_point(stroke, tip) + way * Vec{std::cos(a), std::sin(a)};
      const auto bent = with_tip_bent(stroke, tip, target, reach);
      if (!bent) {
        EXPECT_TRUE(way > 0.3 * reach || bent.error().code == ErrorCode::kInvalidData)
            << seed << ": " << bent.error().message;
        continue;
      }
      ++bent_count;
      EXPECT_TRUE(check_invariants(bent->data())) << seed;
      EXPECT_EQ(tip_point(*bent, tip), target);
      EXPECT_EQ(tip_point(*bent, opposite(tip)), tip_point(stroke, opposite(tip)));
      EXPECT_EQ(bent->tone(0.0), stroke.tone(0.0));
      EXPECT_EQ(bent->tone(bent->segment_count()), stroke.tone(stroke.segment_count()));
      const double turn = angle_between(tip_direction(*bent, tip), tip_direction(stroke, tip));
      EXPECT_LT(turn, 1e-6) << seed;
      // Segments beyond the reach keep their points, bit for bit.
      const int n = stroke.segment_count(), more = bent->segment_count() - n;
      const bool end = tip == StrokeTip::kEnd;
      double far = length_mm(stroke) - reach - 0.1;
      for (int i = 0; i < n; ++i) {
        far -= arc_length(stroke.segment(end ? i : n - 1 - i));
        if (far < 0.0) break;
        const Cubic was = stroke.segment(end ? i : n - 1 - i);
        EXPECT_EQ(bent->segment(end ? i : n - 1 - i + more), was) << seed;
      }
      EXPECT_TRUE(more == 0 || more == 1);
    }
  }
  EXPECT_GT(bent_count, 1000);
}

TEST(TipBend, R45_TheAngleAtTheEndStaysHoweverFarItIsLed) {
  const Stroke line = straight_stroke({0, 0}, {80, 0}, 1, 1);
  for (double a = 0; a < 6.28; a += 0.1) {
    for (const double way : {0.01, 1.0, 10.0, 19.9}) {
      const Point target = Point{80, 0} + way * Vec{std::cos(a), std::sin(a)};
      const auto bent = with_tip_bent(line, StrokeTip::kEnd, target, 40.0);
      ASSERT_TRUE(bent);
      EXPECT_LT(angle_between(tip_direction(*bent, StrokeTip::kEnd), {1, 0}), 1e-9);
    }
  }
}

TEST(TipBend, RefusesWhatWouldFold) {
  const Stroke line = straight_stroke({0, 0}, {80, 0}, 1, 1);
  EXPECT_FALSE(with_tip_bent(line, StrokeTip::kEnd, {59.9, 0}, 40));
  EXPECT_TRUE(with_tip_bent(line, StrokeTip::kEnd, {60, 0}, 40));
  EXPECT_FALSE(with_tip_bent(line, StrokeTip::kEnd, {79, 0}, 90));
  EXPECT_FALSE(with_tip_bent(line, StrokeTip::kEnd, {std::nan(""), 0}, 40));
  EXPECT_EQ(*with_tip_bent(line, StrokeTip::kEnd, {80, 0}, 40), line);
}

}  // namespace
}  // namespace felt::tip_bend_test
