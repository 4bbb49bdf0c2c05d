#include "felt/stroke/arc_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "felt/stroke/testing/random_stroke.h"

namespace felt::arc_map_test {
namespace {

TEST(ArcMap, LengthsAddUpAndComeBack) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    const ArcMap map(s);
    const int n = s.segment_count();
    EXPECT_EQ(map.length_at(0.0), 0.0);
    EXPECT_EQ(map.length_at(n), map.length_mm());
    double before = -1.0;
    for (int k = 0; k <= 60; ++k) {
      const double u = n * k / 60.0;
      const double length = map.length_at(u);
      EXPECT_GE(length, before);
      before = length;
      EXPECT_LE(distance(s.position(map.u_at(length)), s.position(u)), 1e-4);
      EXPECT_NEAR(map.length_at(map.u_at(length)), length, 1e-5);
    }
    for (int i = 0; i < n; ++i) {
      EXPECT_NEAR(map.start_of(i + 1) - map.start_of(i), arc_length(s.segment(i)), 2e-6);
    }
  }
}

TEST(ArcMap, AStraightLineIsItsOwnRuler) {
  const Stroke s = testing::straight_stroke({0, 0}, {30, 40}, 1, 1);
  const ArcMap map(s);
  EXPECT_NEAR(map.length_mm(), 50.0, 1e-9);
  EXPECT_NEAR(map.length_at(0.3), 15.0, 1e-9);
  EXPECT_NEAR(map.u_at(20.0), 0.4, 1e-9);
  EXPECT_EQ(map.u_at(-3.0), 0.0);
  EXPECT_EQ(map.u_at(51.0), 1.0);
  EXPECT_EQ(map.u_at(std::nan("")), 0.0);
  EXPECT_EQ(map.way(40.0, 10.0), -30.0);
}

TEST(ArcMap, ClosedStrokesGoRound) {
  int rings = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    if (!s.closed()) continue;
    ++rings;
    const ArcMap map(s);
    const double whole = map.length_mm();
    for (const double length : {0.1 * whole, 0.5 * whole, 0.9 * whole}) {
      EXPECT_NEAR(map.u_at(length + whole), map.u_at(length), 1e-3);
      EXPECT_NEAR(map.u_at(length - whole), map.u_at(length), 1e-3);
    }
    EXPECT_NEAR(map.way(0.9 * whole, 0.1 * whole), 0.2 * whole, 1e-9);
    EXPECT_NEAR(map.way(0.1 * whole, 0.9 * whole), -0.2 * whole, 1e-9);
    EXPECT_NEAR(map.way(0.1 * whole, 0.5 * whole), 0.4 * whole, 1e-9);
  }
  EXPECT_GT(rings, 10);
}

}  // namespace
}  // namespace felt::arc_map_test
