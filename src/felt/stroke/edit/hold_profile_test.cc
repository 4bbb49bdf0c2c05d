#include "felt/stroke/edit/hold_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "felt/stroke/drawn_profile.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::hold_profile_test {
namespace {

constexpr double kToleranceMm = 0.01;

Stroke with_widths(const Stroke& stroke, std::vector<WidthKnot> widths) {
  StrokeData d = stroke.data();
  d.widths = std::move(widths);
  return Stroke::create(std::move(d)).value();
}

/// Returns the largest difference between two widths along a stroke.
template <class A, class B>
double farthest(const Stroke& stroke, A a, B b) {
  double worst = 0.0;
  for (double u = 0.0; u <= stroke.segment_count(); u += 0.003) {
    worst = std::max(worst, std::fabs(a(u) - b(u)));
  }
  return worst;
}

TEST(HoldProfile, LinesBetweenDrawnKnotsAreTheDrawnWidth) {
  double bent = 0.0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    const Stroke more = with_widths(s, drawn_knots(s, kToleranceMm));
    const auto drawn = [&](double u) { return drawn_width_mm(s, u); };
    EXPECT_LE(farthest(s, drawn, [&](double u) { return more.width_mm(u); }), 2.01 * kToleranceMm);
    // Drawing the new profile adds little to that.
    EXPECT_LE(farthest(s, drawn, [&](double u) { return drawn_width_mm(more, u); }),
              4.0 * kToleranceMm);
    bent = std::max(bent, farthest(s, drawn, [&](double u) { return s.width_mm(u); }));
  }
  EXPECT_GT(bent, 10.0 * kToleranceMm);
}

TEST(HoldProfile, HeldKnotsAreDrawnAsStraightLines) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    const Stroke held = with_widths(s, held_knots(s, kToleranceMm));
    const auto line = [&](double u) { return s.width_mm(u); };
    EXPECT_LE(farthest(s, line, [&](double u) { return held.width_mm(u); }), 1e-9);
    EXPECT_LE(farthest(s, line, [&](double u) { return drawn_width_mm(held, u); }),
              4.01 * kToleranceMm);
  }
}

TEST(HoldProfile, StraightProfilesGetNoKnots) {
  const Stroke s = testing::straight_stroke({0, 0}, {9, 0}, 1.0, 3.0);
  EXPECT_TRUE(std::ranges::equal(drawn_knots(s, kToleranceMm), s.widths()));
  EXPECT_TRUE(std::ranges::equal(held_knots(s, kToleranceMm), s.widths()));
}

}  // namespace
}  // namespace felt::hold_profile_test
