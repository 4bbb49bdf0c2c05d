#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "felt/stroke/outline/outline.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::testing {

/// The tolerance with which strokes are flattened for the brute-force check.
inline constexpr double kOracleToleranceMm = 1e-4;

/// Returns the winding number of the contours around q.
inline int winding(const Outline& outline, Point q) {
  int count = 0;
  for (std::size_t k = 0; k < outline.contour_count(); ++k) {
    const auto c = outline.contour(k);
    Point a = c.back();
    for (Point b : c) {
      const double side = cross(b - a, q - a);
      if (a.y <= q.y && b.y > q.y && side > 0) ++count;
      if (a.y > q.y && b.y <= q.y && side < 0) --count;
      a = b;
    }
  }
  return count;
}

/// Returns how far q is outside the ink between two dabs: the minimum of |q - c| - r between them,
/// with c and r interpolated linearly. It is convex, so the zero of its derivative is the minimum.
inline double distance_outside(const Dab& a, const Dab& b, Point q) {
  const Vec way = b.center - a.center;
  const double length = norm(way), slope = (b.radius_mm - a.radius_mm) / length;
  const auto at = [&](double s) {
    return distance(q, lerp(a.center, b.center, s)) - std::lerp(a.radius_mm, b.radius_mm, s);
  };
  double best = std::min(at(0.0), at(1.0));
  if (length > 0.0 && std::fabs(slope) < 1.0) {
    const double x = dot(q - a.center, way) / length, y = cross(way, q - a.center) / length;
    const double s = (x + slope * std::fabs(y) / std::sqrt(1.0 - slope * slope)) / length;
    best = std::min(best, at(std::clamp(s, 0.0, 1.0)));
  }
  return best;
}

/// Returns how far q is outside the ink of a row of dabs.
inline double distance_outside(const std::vector<Dab>& dabs, Point q) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < dabs.size(); ++i) {
    best = std::min(best, distance_outside(dabs[i - 1], dabs[i], q));
  }
  return best;
}

/// Checks `count` points, half of them near an edge. The outline must contain every point that is
/// inside the ink by more than the margin, and must not contain a point that is outside by more
/// than the margin. No winding number may have the wrong sign.
inline void expect_outline_is_the_ink(const Outline& outline, const Stroke& s, double margin,
                                      std::uint64_t seed, int count) {
  std::vector<Dab> dense;
  flatten(s, kOracleToleranceMm, dense);
  RandomStroke random(seed);
  const Rect box = s.bounds().inflated(0.5);
  for (int k = 0; k < count; ++k) {
    Point q{random.uniform(box.x0, box.x1), random.uniform(box.y0, box.y1)};
    if (k % 2 == 0) {
      const Dab d =
          dense[static_cast<std::size_t>(random.pick(0, static_cast<int>(dense.size()) - 1))];
      const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
      const double r = d.radius_mm + random.uniform(-3.0, 3.0) * margin;
      q = d.center + r * Vec{std::cos(angle), std::sin(angle)};
    }
    const double outside = distance_outside(dense, q);
    const int w = winding(outline, q);
    EXPECT_LE(w, 0) << "wound the wrong way at " << q.x << ", " << q.y;
    if (outside < -margin - kOracleToleranceMm) {
      EXPECT_NE(w, 0) << "hole at " << q.x << ", " << q.y << ", " << -outside << " deep";
    }
    if (outside > margin + kOracleToleranceMm) {
      EXPECT_EQ(w, 0) << "ink at " << q.x << ", " << q.y << ", " << outside << " outside";
    }
  }
}

}  // namespace felt::testing
