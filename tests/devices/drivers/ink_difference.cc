#include "tests/devices/drivers/ink_difference.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace felt {
namespace {

constexpr int kPerSegment = 32;
constexpr double kShiftMm = 0.15;

struct InkPoint {
  Point at;
  double way_mm = 0.0;
  double width_mm = 0.0;
};

std::vector<InkPoint> points_of(const Stroke& stroke) {
  std::vector<double> parameters;
  for (int i = 0; i <= kPerSegment * stroke.segment_count(); ++i) {
    parameters.push_back(static_cast<double>(i) / kPerSegment);
  }
  for (const WidthKnot& knot : stroke.widths()) parameters.push_back(knot.u);
  std::sort(parameters.begin(), parameters.end());
  std::vector<InkPoint> points;
  double way_mm = 0.0;
  for (const double u : parameters) {
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

double width_at(const std::vector<InkPoint>& points, double way_mm) {
  if (way_mm >= points.back().way_mm) return points.back().width_mm;
  const auto next = std::lower_bound(points.begin(), points.end(), way_mm,
                                     [](const InkPoint& p, double way) { return p.way_mm < way; });
  if (next == points.begin()) return next->width_mm;
  const InkPoint& before = *std::prev(next);
  const double step = next->way_mm - before.way_mm;
  const double t = step > 0.0 ? (way_mm - before.way_mm) / step : 0.0;
  return before.width_mm + t * (next->width_mm - before.width_mm);
}

/// Returns how far `width_mm` is from the widths of `points` within kShiftMm of a position along
/// them.
double width_off(const std::vector<InkPoint>& points, double way_mm, double width_mm) {
  constexpr int kSteps = 10;
  double smallest = width_mm, largest = width_mm, nearest = 1e300;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double width = width_at(points, way_mm + kShiftMm * i / kSteps);
    smallest = std::min(smallest, width);
    largest = std::max(largest, width);
    nearest = std::min(nearest, std::fabs(width - width_mm));
  }
  return smallest < width_mm && width_mm < largest ? 0.0 : nearest;
}

}  // namespace

InkDifference ink_difference(std::span<const StrokePtr> a, std::span<const StrokePtr> b) {
  InkDifference difference;
  if (a.size() != b.size()) {
    difference.other =
        std::to_string(a.size()) + " strokes and " + std::to_string(b.size()) + " strokes";
    return difference;
  }
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Stroke &one = *a[k], &two = *b[k];
    if (one.closed() != two.closed()) {
      difference.other = "stroke " + std::to_string(k + 1) + " is closed in one of them";
    }
    if (!(one.color() == two.color()) || one.medium() != two.medium()) {
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
      const double width_mm = width_at(in_one, share * in_one.back().way_mm);
      difference.width_mm =
          std::max(difference.width_mm, width_off(in_two, share * in_two.back().way_mm, width_mm));
    }
  }
  return difference;
}

}  // namespace felt
