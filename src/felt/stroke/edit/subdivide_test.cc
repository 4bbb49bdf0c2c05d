#include "felt/stroke/edit/subdivide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "felt/geometry/nearest.h"
#include "felt/stroke/arc_map.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/stroke/testing/stroke_probe.h"

namespace felt::subdivide_test {
namespace {

using testing::distance_to;
/// Returns the largest distance of points on a from b.
double deviation(const Stroke& a, const Stroke& b) {
  double worst = 0.0;
  const int count = 40 * a.segment_count();
  for (int k = 0; k <= count; ++k) {
    worst = std::max(worst, distance_to(b, a.position(k / 40.0)));
  }
  return worst;
}

/// Converts u of `fine`, which is a subdivision of `coarse`, to u of `coarse`, by arc lengths.
double coarse_u(const ArcMap& coarse, const ArcMap& fine, double u) {
  return coarse.u_at(std::min(fine.length_at(u), coarse.length_mm()));
}

TEST(Subdivided, TracesTheSameInk) {
  int divided = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    testing::RandomStroke random(seed + 7);
    std::vector<double> us;
    for (int k = random.pick(0, 6); k > 0; --k) us.push_back(random.uniform(0, s.segment_count()));
    std::sort(us.begin(), us.end());
    std::vector<int> joints;
    const auto fine = subdivided(s, us, &joints);
    ASSERT_TRUE(fine) << fine.error().message;
    ASSERT_EQ(joints.size(), us.size());
    divided += fine->segment_count() > s.segment_count() ? 1 : 0;
    const ArcMap coarse_map(s), fine_map(*fine);
    EXPECT_NEAR(fine_map.length_mm(), coarse_map.length_mm(), 1e-4);
    for (std::size_t k = 0; k < us.size(); ++k) {
      // Points that are too close together share a joint.
      EXPECT_LE(std::fabs(fine_map.start_of(joints[k]) - coarse_map.length_at(us[k])),
                kMinSegmentMm + 1e-4);
    }
    for (int i = 0; i < fine->segment_count(); ++i) {
      if (fine->segment_count() > s.segment_count()) {
        EXPECT_GE(arc_length(fine->segment(i)), kMinSegmentMm - 1e-6);
      }
    }
    for (int k = 0; k <= 64; ++k) {
      const double u = fine->segment_count() * k / 64.0;
      const double v = coarse_u(coarse_map, fine_map, u);
      EXPECT_LE(distance(fine->position(u), s.position(v)), 1e-4);
    }
  }
  EXPECT_GT(divided, 300);
}

TEST(Subdivided, CarriesWidthsAndCopiesTheRest) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    const int n = s.segment_count();
    const double u = n - 0.6;
    const auto fine = subdivided(s, std::array{u});
    ASSERT_TRUE(fine);
    if (fine->segment_count() == n) continue;
    for (int i = 0; i + 1 < n; ++i) EXPECT_EQ(fine->segment(i), s.segment(i));
    for (int i = 0; i + 1 < n; ++i) EXPECT_EQ(fine->joint(i), s.joint(i));
    for (const WidthKnot& k : s.widths()) {
      const auto w = fine->widths();
      if (k.u <= n - 1) {
        EXPECT_NE(std::find(w.begin(), w.end(), k), w.end());
      }
    }
    for (int k = 0; k <= 64; ++k) {
      const double t = k / 64.0;
      EXPECT_NEAR(fine->width_mm(n - 1 + t), s.width_mm(n - 1 + 0.4 * t), 1e-9);
      EXPECT_NEAR(fine->width_mm(n + t), s.width_mm(n - 0.6 + 0.6 * t), 1e-9);
      EXPECT_NEAR(fine->tone(n - 1 + t), s.tone(n - 1 + 0.4 * t), 1e-9);
      EXPECT_NEAR(fine->tone(n + t), s.tone(n - 0.6 + 0.6 * t), 1e-9);
    }
    EXPECT_EQ(fine->joint(n), JointKind::kSmooth);
  }
}

TEST(Subdivided, NeverMakesSlivers) {
  const Stroke s = testing::straight_stroke({0, 0}, {10, 0}, 1, 2);
  std::vector<int> joints;
  auto fine = subdivided(s, std::array{0.001, 0.5, 0.501, 0.999}, &joints);
  ASSERT_TRUE(fine);
  EXPECT_EQ(fine->segment_count(), 2);
  EXPECT_EQ(joints, (std::vector{0, 1, 1, 2}));
  fine = subdivided(s, std::array{0.0, 1.0}, &joints);
  EXPECT_EQ(*fine, s);
  EXPECT_EQ(joints, (std::vector{0, 1}));
  // The stroke is shorter than two slivers, so a joint does not fit.
  const Stroke dot = testing::straight_stroke({0, 0}, {0.06, 0}, 1, 1);
  EXPECT_EQ(*subdivided(dot, std::array{0.5}), dot);
}

TEST(Subdivided, RefusesNonsense) {
  const Stroke s = testing::straight_stroke({0, 0}, {10, 0}, 1, 2);
  EXPECT_FALSE(subdivided(s, std::array{0.5, 0.4}));
  EXPECT_FALSE(subdivided(s, std::array{1.1}));
  EXPECT_FALSE(subdivided(s, std::array{-0.1}));
  EXPECT_FALSE(subdivided(s, std::array{std::nan("")}));
}

TEST(Subdivided, StandingHandlesAndCuspsKeepTheInvariants) {
  StrokeData d{.points = {{0, 0}, {0, 0}, {0, 0}, {10, 7}},
               .joints = {},
               .closed = false,
               .widths = {{0.0, 1.0}, {1.0, 1.0}}};
  for (int k = 1; k < 50; ++k) {
    EXPECT_TRUE(subdivided(*Stroke::create(d), std::array{k / 50.0, (k + 0.5) / 50.0}));
  }
  d.points = {{0, 0}, {10, 10}, {0, 10}, {10, 0}};  // a cusp at t = 0.5
  const auto cusp = subdivided(*Stroke::create(d), std::array{0.5});
  ASSERT_TRUE(cusp);
  EXPECT_EQ(cusp->segment_count(), 2);
  EXPECT_EQ(cusp->joint(1), JointKind::kCorner);
}

TEST(WithFewerSegments, TakesBackWhatSubdivisionMade) {
  int merged = 0, whole = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    const int n = s.segment_count();
    std::vector<double> us;
    for (int k = 1; k < 4 * n; ++k) us.push_back(k / 4.0);
    const auto fine = subdivided(s, us);
    ASSERT_TRUE(fine);
    const int m = fine->segment_count();
    for (const double tolerance : {0.01, 0.05, 0.5}) {
      const auto few = with_fewer_segments(*fine, 0, s.closed() ? 0 : m, tolerance);
      ASSERT_TRUE(few) << few.error().message;
      EXPECT_LE(few->segment_count(), m);
      EXPECT_LE(deviation(*fine, *few), tolerance + 1e-9);
      EXPECT_LE(deviation(*few, *fine), tolerance + 1e-9);
      merged += few->segment_count() < m ? 1 : 0;
      whole += few->segment_count() <= n ? 1 : 0;
    }
  }
  EXPECT_GT(merged, 800);
  EXPECT_GT(whole, 400);
}

/// Returns a random stroke, with segments divided into quarters, whose width changes by at most
/// 3 mm a segment.
Stroke quarters(std::uint64_t seed) {
  StrokeData d = testing::random_stroke(seed).data();
  testing::RandomStroke random(seed + 1);
  const int n = static_cast<int>(d.points.size() / 3);
  d.widths.clear();
  for (int k = 0; k <= 2 * n; ++k) {
    const double width_mm = random.uniform(0.5, 2.0);
    d.widths.push_back({0.5 * k, width_mm, random.uniform(0.2, 0.7)});
  }
  d.widths.back().width_mm = d.widths.front().width_mm;
  std::vector<double> us;
  for (int k = 1; k < 4 * n; ++k) us.push_back(k / 4.0);
  return subdivided(Stroke::create(std::move(d)).value(), us).value();
}

TEST(WithFewerSegments, KeepsWidthsWhereTheyAre) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke fine = quarters(seed);
    const int m = fine.segment_count();
    const auto few = with_fewer_segments(fine, 0, fine.closed() ? 0 : m, 0.02);
    ASSERT_TRUE(few);
    for (int k = 0; k < 4 * m; ++k) {
      const Point p = fine.position(0.25 * k);
      double best = 1e9, best_tone = 1e9;
      for (double u = 0.0; u < few->segment_count(); u += 0.002) {
        if (distance(few->position(u), p) > 0.1) continue;
        best = std::min(best, std::fabs(few->width_mm(u) - fine.width_mm(0.25 * k)));
        best_tone = std::min(best_tone, std::fabs(few->tone(u) - fine.tone(0.25 * k)));
      }
      EXPECT_LE(best, 0.01 + 3.0 * 0.002) << k;
      EXPECT_LE(best_tone, 0.01 + 1.0 * 0.002) << k;
    }
  }
}

TEST(WithFewerSegments, KeepsCornersAndJointsThatAreNamed) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke fine = quarters(seed);
    const int m = fine.segment_count();
    const int kept = m / 2;
    const auto few = with_fewer_segments(fine, 0, fine.closed() ? 0 : m, 0.05, std::array{kept});
    ASSERT_TRUE(few);
    const auto& points = few->data().points;
    const auto has = [&](Point p) {
      return std::find(points.begin(), points.end(), p) != points.end();
    };
    EXPECT_TRUE(has(fine.segment(kept).p[0]));
    for (int j = 0; j <= m; ++j) {
      if (fine.joint(j) == JointKind::kCorner) {
        EXPECT_TRUE(has(fine.position(j)));
      }
    }
  }
}

TEST(WithFewerSegments, GoesThroughThePlaceThatIsNamed) {
  int inside = 0, segments_kept = 0, segments_through = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke fine = quarters(seed);
    const int m = fine.segment_count(), last = fine.closed() ? 0 : m;
    for (int j = 1; j < m; j += 3) {
      const auto few = with_fewer_segments(fine, 0, last, 0.2, {}, j);
      const auto kept = with_fewer_segments(fine, 0, last, 0.2, std::array{j});
      ASSERT_TRUE(few);
      ASSERT_TRUE(kept);
      EXPECT_LE(distance_to(*few, fine.position(j)), 1e-10);
      const auto& points = few->data().points;
      inside += std::find(points.begin(), points.end(), fine.position(j)) == points.end() ? 1 : 0;
      segments_kept += kept->segment_count();
      segments_through += few->segment_count();
    }
  }
  EXPECT_GT(inside, 200);
  EXPECT_LT(segments_through, segments_kept);
}

TEST(WithFewerSegments, LeavesWhatIsOutsideBitForBit) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    std::vector<double> us;
    for (int k = 1; k < 5 * s.segment_count(); ++k) us.push_back(k / 5.0);
    const Stroke fine = *subdivided(s, us);
    const int m = fine.segment_count();
    const int first = m / 3, last = 2 * m / 3;
    if (last <= first) continue;
    const auto few = with_fewer_segments(fine, first, last, 0.1);
    ASSERT_TRUE(few);
    const int less = m - few->segment_count();
    for (int i = 0; i < first; ++i) EXPECT_EQ(few->segment(i), fine.segment(i));
    for (int i = last; i < m; ++i) EXPECT_EQ(few->segment(i - less), fine.segment(i));
    if (!s.closed()) continue;
    const auto round = with_fewer_segments(fine, last, first, 0.1);
    ASSERT_TRUE(round);
    for (int i = first; i < last; ++i) {
      bool found = false;
      for (int k = 0; k < round->segment_count(); ++k)
        found |= round->segment(k) == fine.segment(i);
      EXPECT_TRUE(found);
    }
  }
}

TEST(WithFewerSegments, RefusesNonsense) {
  const Stroke s = testing::straight_stroke({0, 0}, {10, 0}, 1, 2);
  EXPECT_FALSE(with_fewer_segments(s, 1, 0, 0.1));
  EXPECT_FALSE(with_fewer_segments(s, 0, 0, 0.1));
  EXPECT_FALSE(with_fewer_segments(s, 0, 2, 0.1));
  EXPECT_FALSE(with_fewer_segments(s, -1, 1, 0.1));
  EXPECT_FALSE(with_fewer_segments(s, 0, 1, std::nan("")));
  EXPECT_EQ(*with_fewer_segments(s, 0, 1, 0.1), s);
}

}  // namespace
}  // namespace felt::subdivide_test
