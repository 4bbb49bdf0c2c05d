#include "felt/tactile/touch_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/stroke/edit/corner_trips.h"

namespace felt {
namespace {

/// Returns the number of equal steps of the parameter after which points are at most kStepMm apart:
/// the derivative of a cubic is at most 3 times its longest leg.
int steps_of(const Cubic& c) noexcept {
  const double leg =
      std::max({distance(c.p[0], c.p[1]), distance(c.p[1], c.p[2]), distance(c.p[2], c.p[3])});
  return std::max(1, static_cast<int>(std::ceil(3.0 * leg / TouchLine::kStepMm)));
}

}  // namespace

double TouchLine::path_mm(double a_mm, double b_mm) const noexcept {
  const double straight = std::abs(a_mm - b_mm);
  return is_closed ? std::min(straight, length_mm - straight) : straight;
}

void TouchLines::add(StrokeId id, const Stroke& stroke) {
  TouchLine line{.stroke = id, .is_closed = stroke.closed(), .first = points.size()};
  const auto index = static_cast<std::uint32_t>(lines.size());
  double widths = 0.0;
  int trip_end = 0;  // the first segment after the last trip into a corner
  const auto push = [&](Point at, double width_mm, bool is_trip) {
    if (points.size() > line.first && !is_trip) {
      const double step = distance(points.back().at, at);
      line.length_mm += step;
      widths += step * 0.5 * (width_mm + 2.0 * points.back().half_mm);
    }
    points.push_back({at, 0.5 * width_mm, line.length_mm, index});
    line.bounds.extend(Rect{at.x, at.y, at.x, at.y}.inflated(0.5 * width_mm));
  };
  push(stroke.position(0.0), stroke.width_mm(0.0), false);
  for (int i = 0; i < stroke.segment_count(); ++i) {
    if (i >= trip_end && is_corner_trip(stroke, i)) trip_end = i + 2;
    const int steps = steps_of(stroke.segment(i));
    for (int k = 1; k <= steps; ++k) {
      const double u = i + static_cast<double>(k) / steps;
      push(stroke.position(u), stroke.width_mm(u), i < trip_end);
    }
  }
  line.count = points.size() - line.first;
  line.mean_width_mm = line.length_mm > 0.0 ? widths / line.length_mm : 2.0 * points.back().half_mm;
  lines.push_back(line);
}

TouchGrid::TouchGrid(std::span<const TouchPoint> points, double cell_mm) : cell_mm_(cell_mm) {
  entries_.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    entries_.push_back({cell_of(points[i].at), static_cast<std::uint32_t>(i)});
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return std::pair(a.cell, a.point) < std::pair(b.cell, b.point);
  });
}

TouchGrid::Cell TouchGrid::cell_of(Point at) const noexcept {
  return {static_cast<std::int64_t>(std::floor(at.y / cell_mm_)),
          static_cast<std::int64_t>(std::floor(at.x / cell_mm_))};
}

std::pair<std::size_t, std::size_t> TouchGrid::row(std::int64_t y, std::int64_t x0,
                                                   std::int64_t x1) const noexcept {
  const auto begin = std::lower_bound(entries_.begin(), entries_.end(), Cell{y, x0},
                                      [](const Entry& e, const Cell& c) { return e.cell < c; });
  const auto end = std::upper_bound(begin, entries_.end(), Cell{y, x1},
                                    [](const Cell& c, const Entry& e) { return c < e.cell; });
  return {static_cast<std::size_t>(begin - entries_.begin()),
          static_cast<std::size_t>(end - entries_.begin())};
}

}  // namespace felt
