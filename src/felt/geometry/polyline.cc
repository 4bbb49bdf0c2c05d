#include "felt/geometry/polyline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/base/constants.h"

namespace felt {

LineNearest nearest_on_line(Point a, Point b, Point p) noexcept {
  const Vec along = b - a;
  const double length_squared = norm_squared(along);
  const double projected = dot(p - a, along);
  LineNearest hit{0.0, 0.0, a};
  if (projected > 0.0 && length_squared > 0.0) {
    hit.t = std::min(projected / length_squared, 1.0);
    hit.point = lerp(a, b, hit.t);
  }
  hit.distance_squared = distance_squared(hit.point, p);
  return hit;
}

PolylineNearest nearest_on_polyline(std::span<const Point> line, Point p) noexcept {
  PolylineNearest best;
  best.distance_squared = std::numeric_limits<double>::infinity();
  if (line.size() == 1) return {0, 0.0, distance_squared(line[0], p), line[0]};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const LineNearest hit = nearest_on_line(line[i], line[i + 1], p);
    if (hit.distance_squared < best.distance_squared) {
      best = {i, hit.t, hit.distance_squared, hit.point};
    }
  }
  return best;
}

double polyline_length(std::span<const Point> line) noexcept {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  return length;
}

Point point_at_length(std::span<const Point> line, double length_mm) noexcept {
  if (line.empty()) return {};
  if (!(length_mm > 0.0)) return line.front();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = distance(line[i - 1], line[i]);
    if (length_mm < step) return lerp(line[i - 1], line[i], length_mm / step);
    length_mm -= step;
  }
  return line.back();
}

void resample(std::span<const Point> line, std::span<Point> out) noexcept {
  if (line.empty() || out.empty()) {
    std::fill(out.begin(), out.end(), Point{});
    return;
  }
  const double total = polyline_length(line);
  out[0] = line.front();
  std::size_t i = 1;
  double before = 0.0;  // length up to point i - 1
  for (std::size_t k = 1; k + 1 < out.size(); ++k) {
    const double target = total * static_cast<double>(k) / static_cast<double>(out.size() - 1);
    while (i + 1 < line.size() && before + distance(line[i - 1], line[i]) < target) {
      before += distance(line[i - 1], line[i]);
      ++i;
    }
    const double step = i < line.size() ? distance(line[i - 1], line[i]) : 0.0;
    out[k] = step > 0.0 ? lerp(line[i - 1], line[i], std::clamp((target - before) / step, 0.0, 1.0))
                        : line[i - 1];
  }
  if (out.size() > 1) out.back() = line.back();
}

namespace {

double largest_coordinate(Point a, Point b) noexcept {
  return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y)});
}

bool on_edge(Point a, Point b, Point p) noexcept {
  const double width = 4.0 * kEpsilon * largest_coordinate(a, b);
  if (p.x < std::min(a.x, b.x) - width || p.x > std::max(a.x, b.x) + width ||
      p.y < std::min(a.y, b.y) - width || p.y > std::max(a.y, b.y) + width) {
    return false;
  }
  return nearest_on_line(a, b, p).distance_squared <= width * width;
}

// Returns 1 or -1, by the edge's direction, if the ray from p along +x crosses the edge; else 0.
// Edges are half-open in y, so that a ray through a corner crosses exactly one of its two edges.
int crossing(Point a, Point b, Point p) noexcept {
  const double side = cross(b - a, p - a);
  if (a.y <= p.y && b.y > p.y && side > 0.0) return 1;
  if (b.y <= p.y && a.y > p.y && side < 0.0) return -1;
  return 0;
}

}  // namespace

bool contains(std::span<const Point> polygon, Point p, FillRule rule) noexcept {
  int crossings = 0, winding = 0;
  for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
    const Point a = polygon[i], b = polygon[i + 1 < n ? i + 1 : 0];
    if (on_edge(a, b, p)) return true;
    const int turn = crossing(a, b, p);
    crossings += turn * turn;
    winding += turn;
  }
  return rule == FillRule::kEvenOdd ? crossings % 2 == 1 : winding != 0;
}

double area(std::span<const Point> polygon) noexcept {
  double twice = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    twice += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return 0.5 * twice;
}

std::size_t mark_simplified(std::span<const Point> line, double tolerance_mm,
                            std::span<std::uint8_t> keep) noexcept {
  const std::size_t n = std::min(line.size(), keep.size());
  if (n == 0) return 0;
  std::fill_n(keep.begin(), n, std::uint8_t{0});
  keep[0] = keep[n - 1] = 1;
  const double limit = tolerance_mm * tolerance_mm;
  std::size_t first = 0, last = n - 1, kept = n > 1 ? 2 : 1;
  while (first + 1 < n) {
    double worst = limit;
    std::size_t at = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double d = nearest_on_line(line[first], line[last], line[i]).distance_squared;
      if (d > worst) worst = d, at = i;
    }
    if (at != 0) {
      keep[at] = 1, last = at, ++kept;
      continue;
    }
    first = last;
    for (last = first + 1; last < n && keep[last] == 0;) ++last;
  }
  return kept;
}

std::vector<Point> simplified(std::span<const Point> line, double tolerance_mm) {
  std::vector<std::uint8_t> keep(line.size());
  std::vector<Point> out;
  out.reserve(mark_simplified(line, tolerance_mm, keep));
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (keep[i] != 0) out.push_back(line[i]);
  }
  return out;
}

}  // namespace felt
