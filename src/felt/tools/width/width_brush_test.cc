#include "felt/tools/width/width_brush.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/stroke/profile_builder.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/stroke/width_profile.h"

namespace felt::width_brush_test {
namespace {

using testing::RandomStroke;
using testing::straight_stroke;

/// Returns the stroke with another profile. The test fails if the result breaks an invariant.
Stroke with_widths(const Stroke& stroke, std::vector<WidthKnot> widths) {
  StrokeData data = stroke.data();
  data.widths = std::move(widths);
  auto made = Stroke::create(std::move(data));
  EXPECT_TRUE(made) << made.error().message;
  return made ? *made : stroke;
}

TEST(WidthBrush, R46_WidthAtUChangesByExactlyTheAmountAndNothingBeyondTheReach) {
  int changed = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke stroke = testing::random_stroke(seed);
    const ArcMap map(stroke);
    RandomStroke random(seed + 1000);
    const double u = random.uniform(0.0, stroke.segment_count());
    const double reach = random.chance(0.5) ? 10.0 : random.uniform(1.0, 30.0);
    const double amount = random.uniform(0.0, 3.0);
    WidthBrush brush(stroke, map, reach, 60.0);
    const double at = map.length_at(u);
    brush.add(u, at, amount);
    EXPECT_NEAR(brush.width_mm(u, at), stroke.width_mm(u) + amount, 1e-9);
    const std::vector<double> pinned{u};
    const Stroke result = with_widths(stroke, brush.profile(pinned));
    EXPECT_NEAR(result.width_mm(u), stroke.width_mm(u) + amount, 1e-9);
    for (int i = 0; i <= 500; ++i) {
      const double v = stroke.segment_count() * i / 500.0;
      const double way = std::fabs(map.way(at, map.length_at(v)));
      // The last line of the bump ends at the first place beyond the reach.
      if (way > reach + WidthBrush::kSpacingMm) {
        EXPECT_NEAR(result.width_mm(v), stroke.width_mm(v), 1e-9);
        EXPECT_NEAR(result.tone(v), stroke.tone(v), 1e-9);
      } else {
        EXPECT_GE(result.width_mm(v), stroke.width_mm(v) - WidthBrush::kToleranceMm);
        EXPECT_LE(result.width_mm(v), stroke.width_mm(v) + 1.01 * amount + 0.02);
        EXPECT_NEAR(result.tone(v), stroke.tone(v), kFollowedTone + 1e-9);
      }
    }
    changed += result != stroke;
  }
  EXPECT_GT(changed, 390);
}

TEST(WidthBrush, ALineTooLongForItsPlacesHasAWidthAllTheSame) {
  // The stroke is 500 km long, so ten million places are farther apart than the reach.
  const Stroke stroke = straight_stroke({0, 0}, {5e8, 0}, 1, 1);
  const ArcMap map(stroke);
  WidthBrush brush(stroke, map, 10.0, 6.0);
  const double u = 0.3000001;
  for (const double at : {u, u + 2e-8, u + 5e-8}) {
    brush.add(at, map.length_at(at), 1.0);
    EXPECT_TRUE(std::isfinite(brush.width_mm(at, map.length_at(at))));
  }
}

TEST(WidthBrush, R46_KnotsBeyondTheReachStayBitForBit) {
  StrokeData data = straight_stroke({0, 0}, {100, 0}, 1, 1).data();
  data.widths.clear();
  for (int i = 0; i <= 100; ++i) data.widths.push_back({0.01 * i, 1.0 + 0.3 * std::sin(0.7 * i)});
  const Stroke stroke = Stroke::create(data).value();
  const ArcMap map(stroke);
  WidthBrush brush(stroke, map, 10.0, 6.0);
  brush.add(0.5, 50.0, 1.0);
  const auto profile = brush.profile({});
  for (const WidthKnot& old : stroke.widths()) {
    if (std::fabs(old.u - 0.5) <= 0.1001) continue;
    EXPECT_EQ(std::ranges::count(profile, old), 1) << old.u;
  }
}

TEST(WidthBrush, R46_WidthsStayWithinTheLimits) {
  const Stroke stroke = straight_stroke({0, 0}, {60, 0}, 1, 9);
  const ArcMap map(stroke);
  for (const double amount : {50.0, -50.0}) {
    WidthBrush brush(stroke, map, 10.0, 6.0);
    for (double s = 0.0; s <= 60.0; s += 0.5) brush.add(map.u_at(s), s, amount);
    const Stroke result = with_widths(stroke, brush.profile({}));
    for (int i = 0; i <= 600; ++i) {
      const double u = i / 600.0, before = stroke.width_mm(u);
      EXPECT_GE(result.width_mm(u), kMinWidthMm);
      // Ink broader than 6 mm keeps its width and does not get broader.
      EXPECT_LE(result.width_mm(u), std::max(6.0, before) + WidthBrush::kToleranceMm);
      if (amount > 0) {
        EXPECT_GE(result.width_mm(u), before - 1e-9);
      } else {
        EXPECT_NEAR(result.width_mm(u), kMinWidthMm, WidthBrush::kToleranceMm);
      }
    }
    // A change of direction takes effect immediately, because nothing was accumulated beyond the
    // limit.
    brush.add(0.25, 15.0, amount > 0 ? -0.5 : 0.5);
    EXPECT_NEAR(brush.width_mm(0.25, 15.0), amount > 0 ? 5.5 : kMinWidthMm + 0.5, 1e-9);
  }
}

TEST(WidthBrush, BreakpointsDoNotPileUp) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    RandomStroke random(seed);
    Stroke stroke = straight_stroke({0, 0}, {100, 30}, 1, 2);
    for (int gesture = 0; gesture < 300; ++gesture) {
      const ArcMap map(stroke);
      WidthBrush brush(stroke, map, random.uniform(1.0, 15.0), 6.0);
      const double s = random.uniform(0.0, map.length_mm()), u = map.u_at(s);
      brush.add(u, s, random.uniform(-0.5, 0.5));
      const std::vector<double> pinned{u};
      stroke = with_widths(stroke, brush.profile(pinned));
    }
    // The stroke is 104 mm long: at most one knot per half millimetre, plus the pins that no later
    // gesture reached.
    EXPECT_LE(stroke.widths().size(), 230u);
  }
}

TEST(ProfileKnots, ThinnedStaysWithinTheToleranceAndKeepsWhatMustStay) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    RandomStroke random(seed);
    std::vector<ProfileKnot> knots;
    double w = 1.0;
    for (int i = 0; i <= random.pick(1, 600); ++i) {
      w += random.uniform(-0.02, 0.02);
      knots.push_back({{0.01 * i, w}, random.chance(0.02)});
    }
    if (knots.size() < 2) continue;
    const double tolerance = random.uniform(0.0, 0.1);
    const auto thin = thinned(knots, tolerance);
    EXPECT_EQ(thin.front(), knots.front().knot);
    EXPECT_EQ(thin.back(), knots.back().knot);
    for (const ProfileKnot& k : knots) {
      EXPECT_NEAR(width_at(thin, k.knot.u), k.knot.width_mm, tolerance + 1e-12);
      if (k.stays) {
        EXPECT_EQ(std::ranges::count(thin, k.knot), 1);
      }
    }
  }
}

TEST(ProfileKnots, AStraightProfileNeedsItsEndsOnly) {
  std::vector<ProfileKnot> knots;
  for (int i = 0; i <= 150; ++i) knots.push_back({{0.125 * i, 1.0 + 0.25 * i, 0.005 * i}, false});
  EXPECT_EQ(thinned(knots, 1e-12).size(), 2u);
  // A tone with a turning point does not fit one straight line.
  for (std::size_t i = 0; i < 75; ++i) knots[i].knot.tone = 0.75 - 0.005 * static_cast<double>(i);
  EXPECT_EQ(thinned(knots, 1e-12).size(), 3u);
}

TEST(ProfileKnots, ScaledIsAFactorWithinTheLimits) {
  const std::vector<WidthKnot> knots{{0.0, 1.0, 0.1}, {0.5, 4.0, 0.9}, {1.0, 9.0, 0.5}};
  EXPECT_EQ(scaled(knots, 1.5, 6.0),
            (std::vector<WidthKnot>{{0.0, 1.5, 0.1}, {0.5, 6.0, 0.9}, {1.0, 9.0, 0.5}}));
  EXPECT_EQ(scaled(knots, 0.5, 6.0),
            (std::vector<WidthKnot>{{0.0, 0.5, 0.1}, {0.5, 2.0, 0.9}, {1.0, 4.5, 0.5}}));
  EXPECT_EQ(scaled(knots, 0.001, 6.0)[0].width_mm, kMinWidthMm);
}

}  // namespace
}  // namespace felt::width_brush_test
