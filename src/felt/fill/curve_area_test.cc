#include "felt/fill/curve_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "felt/stroke/testing/random_stroke.h"

namespace felt::curve_area_test {
namespace {

TEST(CurveArea, ADotAroundThePointHasAParityAtOnce) {
  for (const double x : {0.0, 1.0, -12.25, 1e9}) {
    for (const int ulps : {0, 1, 3}) {
      double far = x;
      for (int i = 0; i < ulps; ++i) far = std::nextafter(far, std::numeric_limits<double>::max());
      const Point near_p{x, x}, far_p{far, far};
      const Cubic dot{{near_p, far_p, far_p, near_p}};
      EXPECT_EQ(ray_parity(dot, near_p), 0) << x << " " << ulps;
      EXPECT_EQ(ray_parity(dot, far_p), 0) << x << " " << ulps;
      const Cubic way{{near_p, near_p, far_p, far_p}};
      EXPECT_LE(ray_parity(way, near_p), 1);
    }
  }
}

TEST(CurveArea, ALineIsCrossedOnceFromItsLeft) {
  testing::RandomStroke random(7);
  for (int i = 0; i < 200; ++i) {
    const Point a{random.uniform(-50, 50), random.uniform(-50, 50)};
    const Point b{random.uniform(-50, 50), random.uniform(-50, 50)};
    const Cubic line{{a, lerp(a, b, 1.0 / 3.0), lerp(a, b, 2.0 / 3.0), b}};
    const Point p{random.uniform(-60, 60), random.uniform(-60, 60)};
    const bool between = (a.y <= p.y) != (b.y <= p.y);
    const double x = a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
    EXPECT_EQ(ray_parity(line, p), between && x > p.x ? 1 : 0);
  }
}

}  // namespace
}  // namespace felt::curve_area_test
