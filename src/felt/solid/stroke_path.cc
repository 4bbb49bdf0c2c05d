#include "felt/solid/stroke_path.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace stroke_paths {

/// Appends the points at the distances step, 2 step, ... along a polyline, fewer than `count`.
void append_points(std::span<const Point> path, double step_mm, std::size_t count,
                   std::vector<Point>& out) {
  double next = step_mm, passed = 0.0;
  for (std::size_t i = 1; i < path.size() && out.size() < count; ++i) {
    const double length = distance(path[i - 1], path[i]);
    while (next <= passed + length && out.size() < count) {
      out.push_back(lerp(path[i - 1], path[i], length > 0.0 ? (next - passed) / length : 0.0));
      next = step_mm * static_cast<double>(out.size());
    }
    passed += length;
  }
}

double turn(Point a, Point b, Point c) {
  return cross(b - a, c - a);
}

bool is_between(Point a, Point b, Point p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool segments_meet(Point a, Point b, Point c, Point d) {
  const double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (((abc > 0.0 && abd < 0.0) || (abc < 0.0 && abd > 0.0)) &&
      ((cda > 0.0 && cdb < 0.0) || (cda < 0.0 && cdb > 0.0))) {
    return true;
  }
  return (abc == 0.0 && is_between(a, b, c)) || (abd == 0.0 && is_between(a, b, d)) ||
         (cda == 0.0 && is_between(c, d, a)) || (cdb == 0.0 && is_between(c, d, b));
}

/// Returns true if the path turns back onto itself at b.
bool folds(Point a, Point b, Point c) {
  return turn(a, b, c) == 0.0 && dot(b - a, c - b) <= 0.0;
}

}  // namespace stroke_paths

double path_length(std::span<const Point> path) noexcept {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length += distance(path[i - 1], path[i]);
  return length;
}

std::vector<Point> resampled(std::span<const Point> path, double step_mm) {
  const double length = path_length(path);
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::round(length / step_mm)));
  std::vector<Point> out{path.front()};
  stroke_paths::append_points(path, length / static_cast<double>(steps), steps, out);
  if (length > 0.0) out.push_back(path.back());
  return out;
}

std::vector<Point> resampled_ring(std::span<const Point> ring, int count) {
  std::vector<Point> closed(ring.begin(), ring.end());
  closed.push_back(ring.front());
  std::vector<Point> out{ring.front()};
  stroke_paths::append_points(closed, path_length(closed) / count, static_cast<std::size_t>(count),
                              out);
  return out;
}

std::optional<std::size_t> self_crossing(std::span<const Point> path, PathEnds ends) {
  using namespace stroke_paths;
  const std::size_t n = path.size();
  if (n < 3) return std::nullopt;
  const std::size_t segments = ends == PathEnds::kClosed ? n : n - 1;
  const auto at = [&](std::size_t i) { return path[i % n]; };
  for (std::size_t i = 0; i < segments; ++i) {
    if (i + 1 < segments && folds(at(i), at(i + 1), at(i + 2))) return i + 1;
    for (std::size_t k = i + 2; k < segments; ++k) {
      if (k + 1 == segments && i == 0 && ends == PathEnds::kClosed) continue;
      if (segments_meet(at(i), at(i + 1), at(k), at(k + 1))) return i;
    }
  }
  if (ends == PathEnds::kClosed && folds(at(n - 1), at(0), at(1))) return 0;
  return std::nullopt;
}

double ring_area(std::span<const Point> ring) noexcept {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    twice += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  }
  return 0.5 * twice;
}

}  // namespace felt
