#include "felt/tools/pull/strand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/geometry/nearest.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/stroke/testing/stroke_probe.h"
#include "felt/tools/pull/refit.h"

namespace felt::strand_test {
namespace {

using testing::random_stroke;
using testing::RandomStroke;
using testing::share;

TEST(Strand, UntouchedItIsTheSnapshot) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const StrokePtr stroke = share(random_stroke(seed));
    if (stroke->closed() && stroke->segment_count() == 1) continue;
    const Strand strand(stroke);
    EXPECT_EQ(strand.stroke().value(), *stroke);
    EXPECT_EQ(with_good_shapes(strand).value(), *stroke);
  }
}

TEST(Strand, DividedItIsTheSameInk) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const StrokePtr stroke = share(random_stroke(seed));
    Strand strand(stroke);
    RandomStroke random(seed + 1000);
    for (int k = 0; k < 5; ++k) {
      strand.divide(random.pick(0, strand.count() - 1), random.uniform(0.01, 0.99));
    }
    strand.divide_evenly(random.pick(0, strand.count() - 1), 2.0, 5);
    const Result<Stroke> now = strand.stroke();
    ASSERT_TRUE(now) << now.error().message;
    for (int k = 0; k <= 200; ++k) {
      const double u = k / 200.0 * stroke->segment_count();
      const StrandPlace place = strand.locate(u);
      const double v = place.segment + place.t;
      EXPECT_LT(distance(now->position(v), stroke->position(u)), 1e-9);
      EXPECT_NEAR(now->width_mm(v), stroke->width_mm(u), 1e-6);
    }
  }
}

TEST(Strand, SliversAreNotMade) {
  Strand strand(share(testing::straight_stroke({0, 0}, {1, 0}, 1.0, 1.0)));
  EXPECT_FALSE(strand.divide(0, 0.01));
  EXPECT_FALSE(strand.divide(0, 0.96));
  EXPECT_TRUE(strand.divide(0, 0.1));
  EXPECT_EQ(strand.divide_evenly(1, 1e-9, 4), 4);
  EXPECT_EQ(strand.count(), 5);
}

/// The ink keeps its width and tone, regardless of how the strand is divided.
TEST(Strand, WidthAndToneGoWithTheirPlace) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    const StrokePtr was = share(testing::random_stroke(seed));
    Strand strand(was);
    strand.divide_evenly(0, 1e-9, 4);
    const Result<Stroke> now = strand.stroke();
    ASSERT_TRUE(now) << now.error().message;
    for (int k = 0; k <= 100; ++k) {
      const double v = strand.count() * k / 100.0;
      const int i = std::min(static_cast<int>(v), strand.count() - 1);
      const double u0 = strand.snapshot_u(i), u1 = strand.snapshot_u(i + 1);
      const double u = u0 + (v - i) * (u1 - u0);
      EXPECT_NEAR(now->width_mm(v), was->width_mm(u), 1e-9) << v;
      EXPECT_NEAR(now->tone(v), was->tone(u), 1e-9) << v;
    }
  }
}

/// Tests zero-length handles at smooth joints (R28).
TEST(Strand, R28_StandingHandlesKeepJointsSmooth) {
  // Zero-length handles on both sides of two smooth joints.
  const StrokePtr valid = share(Stroke::create({.points = {{0, 0},
                                                           {3, 0},
                                                           {10, 0},
                                                           {10, 0},
                                                           {10, 0},
                                                           {20, 0},
                                                           {20, 0},
                                                           {20, 0},
                                                           {28, 0},
                                                           {28, 4}},
                                                .joints = {JointKind::kSmooth, JointKind::kSmooth},
                                                .closed = false,
                                                .widths = {{0.0, 1.0}, {3.0, 1.0}}})
                                    .value());
  RandomStroke random(7);
  for (int round = 0; round < 500; ++round) {
    SCOPED_TRACE(round);
    Strand strand(valid);
    for (int k = 0; k < 6; ++k) {
      const int i = random.pick(0, 2);
      const double t = random.chance(0.2) ? random.pick(0, 1) : random.uniform(0.0, 1.0);
      const Vec pull{random.uniform(-5, 5), random.uniform(-5, 5)};
      strand.prepare(i);
      strand.bend(i, t, soft_weights(t, strand.compliance(i, t, random.chance(0.5))), pull);
      const Result<Stroke> now = strand.stroke();
      ASSERT_TRUE(now) << now.error().message;
    }
  }
}

TEST(Strand, R28_AHandleThatIsPulledToNothing) {
  // The pull moves the left handle of the second segment to its joint, exactly or nearly.
  const StrokePtr stroke =
      share(Stroke::create({.points = {{0, 0}, {3, 0}, {7, 0}, {10, 0}, {13, 0}, {17, 5}, {20, 5}},
                            .joints = {JointKind::kSmooth},
                            .closed = false,
                            .widths = {{0.0, 1.0}, {2.0, 1.0}}})
                .value());
  for (const double t : {0.2, 0.5, 0.7}) {
    const EditWeights w = soft_weights(t);
    for (const double off : {0.0, 1e-9, 1e-7, 1e-5}) {
      const Vec pull = Vec{-3.0 / (w.w[1] - w.w[0]), off};
      Strand strand(stroke);
      strand.prepare(1);
      const Point before = evaluate(strand.segment(1), t);
      ASSERT_TRUE(strand.bend(1, t, w, pull));
      const Result<Stroke> now = strand.stroke();
      ASSERT_TRUE(now) << now.error().message;
      EXPECT_LT(distance(evaluate(strand.segment(1), t), before + pull), 1e-9);
    }
  }
}

TEST(Strand, WhatWouldFoldToNothingIsLeft) {
  Strand strand(share(testing::straight_stroke({0, 0}, {1, 0}, 1.0, 1.0)));
  const Cubic before = strand.segment(0);
  EXPECT_FALSE(strand.bend(0, 0.5, {{0, 0, 0, 1}}, {std::nan(""), 0.0}));
  EXPECT_FALSE(strand.bend(0, 0.5, {{0, 1.0 / 3, 2.0 / 3, 1}}, {-1.0, 0.0}));
  EXPECT_EQ(strand.segment(0), before);
  EXPECT_FALSE(strand.is_changed(0));
}

TEST(Refit, IllShapedSegmentsAreMended) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const StrokePtr stroke = share(random_stroke(seed));
    Strand strand(stroke);
    RandomStroke random(seed);
    const int i = random.pick(0, strand.count() - 1);
    strand.prepare(i);
    if (!strand.bend(i, 0.4, soft_weights(0.4), {random.uniform(-9, 9), random.uniform(-9, 9)})) {
      continue;
    }
    const Result<Stroke> bent = strand.stroke();
    ASSERT_TRUE(bent);
    const Result<Stroke> done = with_good_shapes(strand);
    ASSERT_TRUE(done) << done.error().message;
    int ill_before = 0, ill_after = 0;
    for (int k = 0; k < bent->segment_count(); ++k) ill_before += !is_well_shaped(*bent, k);
    for (int k = 0; k < done->segment_count(); ++k) {
      ill_after += !is_well_shaped(*done, k);
    }
    // Cusps and loops within a micrometre of their joints keep a bad shape, because the ink itself
    // has this shape.
    EXPECT_LE(ill_after, ill_before + 2);
    // The ink does not move.
    for (int k = 0; k <= 300; ++k) {
      const Point p = bent->position(k / 300.0 * bent->segment_count());
      double near = 1e9;
      for (int s = 0; s < done->segment_count(); ++s) {
        near = std::min(near, nearest(done->segment(s), p).distance_squared);
      }
      EXPECT_LE(std::sqrt(near), 2.5 * kRefitToleranceMm);
    }
  }
}

}  // namespace
}  // namespace felt::strand_test
