#include "tests/drivers/ink_difference.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace felt {
namespace {

constexpr int kPerSegment = 32;

struct InkPoint {
  Point at;
  double way_mm = 0.0;
  double width_mm = 0.0;
};

std::vector<InkPoint> points_of(const Stroke& stroke) {
  std::vector<InkPoint> points;
  double way_mm = 0.0;
  for (int i = 0; i <= kPerSegment * stroke.segment_count(); ++i) {
    const double u = static_cast<double>(i) / kPerSegment;
    const Point at = stroke.position(u);
    if (!points.empty()) way_mm += distance(points.back().at, at);
    points.push_back({at, way_mm, stroke.width_mm(u)});
  }
  return points;
}

double distance_to_piece(Point p, Point a, Point b) {
  const Vec ab = b - a, ap = p - a;
  const double length2 = dot(ab, ab);
  const double t = length2 > 0.0 ? std::clamp(dot(ap, ab) / length2, 0.0, 1.0) : 0.0;
  return distance(p, a + t * ab);
}

double farthest_mm(const std::vector<InkPoint>& from, const std::vector<InkPoint>& to) {
  double farthest = 0.0;
  for (const InkPoint& p : from) {
    double nearest = distance(p.at, to.front().at);
    for (std::size_t i = 1; i < to.size() && nearest > farthest; ++i) {
      nearest = std::min(nearest, distance_to_piece(p.at, to[i - 1].at, to[i].at));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

double width_at(const std::vector<InkPoint>& points, double share) {
  const double way_mm = share * points.back().way_mm;
  const auto next = std::lower_bound(points.begin(), points.end(), way_mm,
                                     [](const InkPoint& p, double way) { return p.way_mm < way; });
  if (next == points.begin()) return next->width_mm;
  const InkPoint& before = *std::prev(next);
  const double step = next->way_mm - before.way_mm;
  const double t = step > 0.0 ? (way_mm - before.way_mm) / step : 0.0;
  return before.width_mm + t * (next->width_mm - before.width_mm);
}

}  // namespace

InkDifference ink_difference(const Sketch& a, const Sketch& b) {
  InkDifference difference;
  if (a.size() != b.size()) {
    difference.other =
        std::to_string(a.size()) + " strokes and " + std::to_string(b.size()) + " strokes";
    return difference;
  }
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Stroke &one = a[k].stroke, &two = b[k].stroke;
    if (one.closed() != two.closed()) {
      difference.other = "stroke " + std::to_string(k + 1) + " is closed in one of them";
    }
    if (!(one.color() == two.color()) || one.material() != two.material()) {
      difference.other = "stroke " + std::to_string(k + 1) + " has another colour or material";
    }
    const auto in_one = points_of(one), in_two = points_of(two);
    difference.ends_mm =
        std::max({difference.ends_mm, distance(in_one.front().at, in_two.front().at),
                  distance(in_one.back().at, in_two.back().at)});
    difference.curve_mm =
        std::max({difference.curve_mm, farthest_mm(in_one, in_two), farthest_mm(in_two, in_one)});
    for (int i = 5; i <= 95; ++i) {
      const double share = 0.01 * i;
      difference.width_mm = std::max(difference.width_mm,
                                     std::fabs(width_at(in_one, share) - width_at(in_two, share)));
    }
  }
  return difference;
}

}  // namespace felt
