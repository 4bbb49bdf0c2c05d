#include "felt/recognise/testing/drawn_shapes.h"

#include <algorithm>
#include <cmath>

#include "felt/base/random.h"

namespace felt::testing {

std::vector<Point> joined(const std::vector<Point>& corners) {
  std::vector<Point> path;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const int steps = std::max(1, static_cast<int>(distance(corners[i], corners[i + 1])));
    for (int k = 0; k < steps; ++k) {
      path.push_back(lerp(corners[i], corners[i + 1], static_cast<double>(k) / steps));
    }
  }
  path.push_back(corners.back());
  return path;
}

std::vector<Point> ellipse_part(Point center, double a, double b, double from, double sweep,
                                double angle) {
  constexpr int kSteps = 90;
  const Vec u{std::cos(angle), std::sin(angle)}, v = perp(u);
  std::vector<Point> path;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = from + sweep * i / kSteps;
    path.push_back(center + a * std::cos(t) * u + b * std::sin(t) * v);
  }
  return path;
}

std::vector<Point> zigzag(int passes, double length_mm, double advance_mm) {
  std::vector<Point> corners{{0.0, 0.0}};
  for (int i = 1; i <= passes; ++i) {
    corners.push_back({i % 2 == 1 ? length_mm : 0.0, 0.5 * advance_mm * i});
  }
  return joined(corners);
}

std::vector<Point> unsteady(std::vector<Point> path, double rms_mm, std::uint64_t seed) {
  Random random(seed);
  Vec off;
  for (Point& p : path) {
    // A first-order filter of white noise with a memory of about ten points.
    off = 0.9 * off + 0.436 * rms_mm * Vec{random.normal(), random.normal()};
    p += off;
  }
  return path;
}

std::vector<Point> placed(std::vector<Point> path, double angle, double scale, Vec by) {
  const Vec u{std::cos(angle), std::sin(angle)}, v = perp(u);
  for (Point& p : path) p = Point{} + scale * (p.x * u + p.y * v) + by;
  return path;
}

}  // namespace felt::testing
