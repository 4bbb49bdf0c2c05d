#include "felt/recognise/even_path.h"

#include <cmath>

#include "felt/geometry/polyline.h"

namespace felt {

std::vector<Point> even_path(std::span<const Point> path, std::size_t count, double still_mm) {
  std::vector<Point> moved;
  moved.reserve(path.size());
  for (const Point p : path) {
    if (!is_in_range(p)) continue;
    if (moved.empty() || distance(moved.back(), p) > still_mm) moved.push_back(p);
  }
  if (moved.size() < 2 || count < 2) return {};
  std::vector<Point> even(count);
  resample(moved, even);
  return even;
}

Rect bounds_of(std::span<const Point> path) noexcept {
  Rect box;
  for (const Point p : path) box.extend(p);
  return box;
}

double diagonal_mm(std::span<const Point> path) noexcept {
  const Rect box = bounds_of(path);
  return std::hypot(box.width(), box.height());
}

}  // namespace felt
