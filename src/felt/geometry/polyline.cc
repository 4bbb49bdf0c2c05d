#include "felt/geometry/polyline.h"

#include <algorithm>
#include <limits>

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

}  // namespace felt
