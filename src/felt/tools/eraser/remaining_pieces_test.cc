#include "felt/tools/eraser/remaining_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/geometry/nearest.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/stroke/testing/stroke_probe.h"

namespace felt::remaining_pieces_test {
namespace {

using testing::distance_to;
using testing::length_of;
using testing::RandomStroke;
using testing::share;
using testing::straight_stroke;

ParameterSet set_of(std::initializer_list<ParameterSet::Interval> parts) {
  ParameterSet set;
  for (const auto& p : parts) set.add(p);
  return set;
}

TEST(RemainingPieces, R40_OneHoleMakesTwoStrokesThatKeepTheWidthAtTheCuts) {
  const auto line = share(straight_stroke({0, 0}, {60, 0}, 1.0, 4.0));
  RemainingPieces remains(line);
  remains.cut(set_of({{0.25, 0.5}}));
  EXPECT_FALSE(remains.is_whole());
  const auto pieces = remains.pieces();
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(pieces[0]->width_mm(0), 1.0, 1e-9);
  EXPECT_NEAR(pieces[0]->width_mm(1), line->width_mm(0.25), 1e-9);
  EXPECT_NEAR(pieces[1]->width_mm(0), line->width_mm(0.5), 1e-9);
  EXPECT_NEAR(pieces[1]->width_mm(1), 4.0, 1e-9);
  EXPECT_NEAR(pieces[0]->position(1).x, 15.0, 1e-9);
  EXPECT_NEAR(pieces[1]->position(0).x, 30.0, 1e-9);
  for (const auto& p : pieces) {
    EXPECT_EQ(p->joint(0), JointKind::kEnd);
    EXPECT_EQ(p->joint(p->segment_count()), JointKind::kEnd);
    EXPECT_EQ(p->medium(), line->medium());
    EXPECT_EQ(p->color(), line->color());
  }
}

TEST(RemainingPieces, R39_R40_RandomHolesLeaveTheRestAsItWas) {
  int cuts = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    RandomStroke make(seed);
    const auto stroke = share(Stroke::create(make.make()).value());
    const double n = stroke->segment_count();
    ParameterSet erased;
    for (int k = make.pick(1, 6); k > 0; --k) {
      double from = make.uniform(-0.2, n);
      if (make.chance(0.2)) from = std::floor(from) + make.uniform(-1e-6, 1e-6);  // next to a joint
      erased.add({std::max(0.0, from), std::min(n, from + make.uniform(1e-7, 0.4))});
    }
    RemainingPieces remains(stroke);
    remains.cut(erased);
    if (remains.is_whole()) continue;
    const auto pieces = remains.pieces();
    ASSERT_LE(pieces.size(), erased.intervals().size() + 1);
    for (const auto& piece : pieces) {
      ASSERT_FALSE(piece->closed());
      ASSERT_TRUE(check_invariants(piece->data()));
      const double m = piece->segment_count();
      EXPECT_GE(length_of(*piece),
                std::max(RemainingPieces::kMinPieceMm, 0.5 * piece->width_mm(0.5 * m)) * 0.5);
      EXPECT_GE(length_of(*piece), RemainingPieces::kMinPieceMm - 0.1 - 1e-6);
      for (double share = 0.0; share <= 1.0; share += 0.05) {
        ASSERT_LE(distance_to(*stroke, piece->position(share * m)), 1e-6) << "seed " << seed;
      }
      ++cuts;
    }
    // Nothing remains in the holes. Outside of the holes everything remains except slivers.
    double kept = 0.0, whole = length_of(*stroke), holes = 0.0;
    for (const auto& piece : pieces) kept += length_of(*piece);
    for (const auto& hole : erased.intervals()) {
      for (int i = 0; i < stroke->segment_count(); ++i) {
        const double t0 = std::max(0.0, hole.from - i), t1 = std::min(1.0, hole.to - i);
        if (t0 < t1) holes += arc_length(stroke->segment(i), t0, t1);
      }
    }
    const double dropped = whole - holes - kept;
    EXPECT_GE(dropped, -2e-3 * static_cast<double>(erased.intervals().size()) - 1e-6) << seed;
    EXPECT_LE(dropped, 4.1 * static_cast<double>(erased.intervals().size() + 1)) << seed;
  }
  EXPECT_GT(cuts, 1000);
}

TEST(RemainingPieces, R40_ShortPiecesAreDropped) {
  RemainingPieces thin(share(straight_stroke({0, 0}, {10, 0}, 0.3, 0.3)));
  thin.cut(set_of({{0.024, 0.5}}));
  EXPECT_EQ(thin.pieces().size(), 1u) << "0.24 mm";
  thin.cut(set_of({{0.026, 0.5}}));
  EXPECT_EQ(thin.pieces().size(), 2u) << "0.26 mm";
  RemainingPieces broad(share(straight_stroke({0, 0}, {10, 0}, 4, 4)));
  broad.cut(set_of({{0.19, 0.5}}));
  EXPECT_EQ(broad.pieces().size(), 1u) << "1.9 mm of 4 mm width";
  broad.cut(set_of({{0.21, 0.5}}));
  EXPECT_EQ(broad.pieces().size(), 2u);
  broad.cut(set_of({{0.0, 1.0}}));
  EXPECT_TRUE(broad.pieces().empty());
  EXPECT_FALSE(broad.is_whole());
}

TEST(RemainingPieces, R40_NoPieceGetsASliverOfASegment) {
  const auto two =
      share(Stroke::create({.points = {{0, 0}, {3, 0}, {6, 0}, {9, 0}, {12, 0}, {15, 0}, {18, 0}},
                            .joints = {JointKind::kSmooth},
                            .closed = false,
                            .widths = {{0, 1}, {2, 2}}})
                .value());
  for (const double t : {1e-9, 1e-4, 5e-3}) {
    RemainingPieces remains(two);
    remains.cut(set_of({{0.2, 1.0 - t}}));
    ASSERT_EQ(remains.pieces().size(), 2u);
    EXPECT_EQ(remains.pieces()[1]->segment_count(), 1);
    EXPECT_EQ(remains.pieces()[1]->position(0), (Point{9, 0}));
    remains.cut(set_of({{1.0 + t, 1.7}}));
    ASSERT_EQ(remains.pieces().size(), 2u);
    EXPECT_EQ(remains.pieces()[0]->segment_count(), 1);
  }
  RemainingPieces remains(two);
  remains.cut(set_of({{0.2, 0.99}}));
  EXPECT_EQ(remains.pieces()[1]->segment_count(), 2) << "0.09 mm is no sliver";
}

Stroke ring() {
  return Stroke::create(
             {.points = {{0, 0}, {10, -10}, {20, -10}, {30, 0}, {20, 10}, {10, 10}, {0, 0}},
              .joints = {JointKind::kCorner, JointKind::kCorner},
              .closed = true,
              .widths = {{0, 1}, {1, 3}, {2, 1}}})
      .value();
}

TEST(RemainingPieces, AClosedStrokeIsOpenedAndItsSeamIsNoCut) {
  const auto closed = share(ring());
  RemainingPieces remains(closed);
  remains.cut(set_of({{0.4, 0.6}}));
  ASSERT_EQ(remains.pieces().size(), 1u);
  const Stroke& open = *remains.pieces()[0];
  EXPECT_FALSE(open.closed());
  EXPECT_EQ(open.segment_count(), 3);
  EXPECT_LE(distance(open.position(0), closed->position(0.6)), 1e-12);
  EXPECT_LE(distance(open.position(3), closed->position(0.4)), 1e-12);
  EXPECT_NEAR(open.width_mm(0), closed->width_mm(0.6), 1e-9);
  EXPECT_EQ(open.joint(2), JointKind::kCorner);
  remains.cut(set_of({{0.4, 0.6}, {1.4, 1.6}}));
  EXPECT_EQ(remains.pieces().size(), 2u);
  remains.cut(set_of({{0.0, 0.2}, {1.8, 2.0}}));  // across the seam
  ASSERT_EQ(remains.pieces().size(), 1u);
  EXPECT_LE(distance(remains.pieces()[0]->position(0), closed->position(0.2)), 1e-12);
  remains.cut(set_of({{0.0, 2.0}}));
  EXPECT_TRUE(remains.pieces().empty());
  remains.cut(set_of({{0.0, 0.2}}));
  ASSERT_EQ(remains.pieces().size(), 1u);
  EXPECT_LE(distance(remains.pieces()[0]->position(1), closed->position(1)), 1e-12);
  EXPECT_EQ(remains.pieces()[0]->segment_count(), 2);
}

TEST(RemainingPieces, WhatDidNotChangeIsTheSameObject) {
  RemainingPieces remains(share(straight_stroke({0, 0}, {60, 0}, 1, 1)));
  remains.cut(set_of({{0.25, 0.3}}));
  const auto before = remains.pieces();
  remains.cut(set_of({{0.25, 0.3}, {0.7, 0.8}}));
  const auto after = remains.pieces();
  ASSERT_EQ(after.size(), 3u);
  EXPECT_EQ(before[0], after[0]);
  EXPECT_NE(before[1], after[1]);
}

TEST(RemainingPieces, AHoleOfLessThanAMicrometreIsNone) {
  RemainingPieces remains(share(straight_stroke({0, 0}, {10, 0}, 1, 1)));
  remains.cut(set_of({{0.5, 0.5 + 0.9e-4}}));
  EXPECT_TRUE(remains.is_whole());
  remains.cut(set_of({{0.5, 0.5 + 1.1e-4}}));
  EXPECT_FALSE(remains.is_whole());
  EXPECT_EQ(remains.pieces().size(), 2u);
}

}  // namespace
}  // namespace felt::remaining_pieces_test
