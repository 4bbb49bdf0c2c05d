#include "felt/tactile/inner_circle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "felt/geometry/polyline.h"
#include "felt/geometry/rect.h"

namespace felt {
namespace {

/// Returns the distance from a point to the edge of the area; negative outside.
double depth_of(const Outline& polygons, Point p) {
  double nearest = std::numeric_limits<double>::infinity();
  bool is_inside = false;
  for (std::size_t k = 0; k < polygons.contour_count(); ++k) {
    const std::span<const Point> contour = polygons.contour(k);
    for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
      const Point a = contour[j], b = contour[i];
      nearest = std::min(nearest, nearest_on_line(a, b, p).distance_squared);
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) {
        is_inside = !is_inside;
      }
    }
  }
  return is_inside ? std::sqrt(nearest) : -std::sqrt(nearest);
}

/// The search ends after this many tests of a cell against an edge: less than a second.
constexpr std::size_t kMaxEdgeTests = 200'000'000;

struct SearchCell {
  Point middle{};
  double half_mm = 0.0;
  double depth_mm = 0.0;

  [[nodiscard]] double bound_mm() const noexcept {
    return depth_mm + std::numbers::sqrt2 * half_mm;
  }
  friend bool operator<(const SearchCell& a, const SearchCell& b) noexcept {
    return a.bound_mm() < b.bound_mm();
  }
};

}  // namespace

InnerCircle largest_inner_circle(const Outline& polygons, double tolerance_mm) {
  Rect box;
  for (const Point& p : polygons.points) box.extend(p);
  if (box.empty()) return {};
  std::priority_queue<SearchCell> cells;
  const auto add = [&](Point middle, double half_mm) {
    cells.push({middle, half_mm, depth_of(polygons, middle)});
  };
  add({0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)},
      0.5 * std::max(box.width(), box.height()));
  SearchCell best = cells.top();
  const std::size_t max_cells = kMaxEdgeTests / polygons.points.size() + 256;
  for (std::size_t seen = 0; !cells.empty() && seen < max_cells; ++seen) {
    const SearchCell cell = cells.top();
    cells.pop();
    if (cell.depth_mm > best.depth_mm) best = cell;
    // A depth that is not positive is no circle, however small its cell is.
    if (cell.bound_mm() - std::max(best.depth_mm, 0.0) <= 0.5 * tolerance_mm) break;
    const double half = 0.5 * cell.half_mm;
    for (const Vec step :
         {Vec{-half, -half}, Vec{half, -half}, Vec{-half, half}, Vec{half, half}}) {
      add(cell.middle + step, half);
    }
  }
  if (best.depth_mm <= 0.0) return {best.middle, 0.0};
  return {best.middle, 2.0 * best.depth_mm};
}

}  // namespace felt
