#include "scene.h"

#include <cmath>
#include <numbers>
#include <random>

#include "felt/geometry/testing/nearest_cases.h"

namespace felt::bench {
namespace {

constexpr double kPi = std::numbers::pi;

Vec polar(double angle, double length) {
  return {length * std::cos(angle), length * std::sin(angle)};
}

}  // namespace

double canvas_side(std::size_t n) {
  return 2000.0 * std::sqrt(static_cast<double>(n) / 1e4);
}

std::vector<BvhSegment> page(std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  const double side = canvas_side(n);
  std::vector<BvhSegment> segments;
  segments.reserve(n);
  for (std::uint32_t stroke = 0; segments.size() < n; ++stroke) {
    Point p{uniform(random, 0.0, side), 0.0};
    p.y = uniform(random, 0.0, side);
    double heading = uniform(random, -kPi, kPi);
    const auto count = static_cast<std::uint32_t>(1 + random() % 8);
    for (std::uint32_t i = 0; i < count && segments.size() < n; ++i) {
      const double length = uniform(random, 8.0, 48.0), turn = uniform(random, -1.0, 1.0);
      const Point end = p + polar(heading + turn, length);
      const double after = heading + 2.0 * turn + uniform(random, -0.3, 0.3);
      const Point b1 = p + polar(heading, 0.36 * length), b2 = end - polar(after, 0.36 * length);
      segments.push_back({Cubic{{p, b1, b2, end}}, {stroke, i}});
      p = end, heading = after;
    }
  }
  return segments;
}

std::vector<Point> pen_path(std::size_t ticks, double side, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<Point> path(ticks);
  Point p{0.5 * side, 0.5 * side};
  double heading = 0.0, bend = 0.0;
  for (Point& at : path) {
    bend = 0.98 * bend + uniform(random, -0.005, 0.005);
    heading += bend;
    Point next = p + polar(heading, 0.4);
    if (next.x < 0.0 || next.y < 0.0 || next.x > side || next.y > side) {
      heading += kPi;
      next = p + polar(heading, 0.4);
    }
    at = p = next;
  }
  return path;
}

std::vector<BvhSegment> circle_of_arcs(std::size_t n, Point centre, double radius) {
  std::vector<BvhSegment> segments;
  segments.reserve(n);
  const double angle = 2.0 * kPi / static_cast<double>(n);
  const double handle = 4.0 / 3.0 * std::tan(0.25 * angle);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec a = polar(angle * i, radius), b = polar(angle * (i + 1.0), radius);
    segments.push_back({Cubic{{centre + a, centre + a + handle * perp(a),
                               centre + b - handle * perp(b), centre + b}},
                        {0, i}});
  }
  return segments;
}

}  // namespace felt::bench
