#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "felt/fill/fill_map.h"

namespace felt::testing {

/// Makes a stroke of constant width from the 3n + 1 control points of its curve; all joints are
/// corners.
inline StrokePtr stroke_of(std::vector<Point> points, bool closed = false, double width_mm = 0.5) {
  StrokeData d;
  const std::size_t n = points.size() / 3;
  d.points = std::move(points);
  d.closed = closed;
  d.joints.assign(closed ? n : n - 1, JointKind::kCorner);
  d.widths = {{0.0, width_mm}, {static_cast<double>(n), width_mm}};
  return std::make_shared<const Stroke>(Stroke::create(std::move(d)).value());
}

/// Returns the control points of straight lines through the corners.
inline std::vector<Point> lines_through(const std::vector<Point>& corners) {
  std::vector<Point> points{corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Cubic c = straight(corners[i - 1], corners[i]);
    points.insert(points.end(), c.p.begin() + 1, c.p.end());
  }
  return points;
}

/// A fill map, and strokes with the ids 1, 2, ...
struct MapDrawing {
  FillMap map;
  std::uint64_t last = 0;

  StrokeId add(StrokePtr stroke) {
    const StrokeId id{++last};
    set(id, std::move(stroke));
    return id;
  }
  StrokeId add(StrokeData data) {
    return add(std::make_shared<const Stroke>(Stroke::create(std::move(data)).value()));
  }
  void set(StrokeId id, StrokePtr stroke) {
    map.update(std::vector<FillLine>{{id, std::move(stroke)}});
  }
  StrokeId line(Point a, Point b, double width_mm = 0.5) {
    return add(stroke_of(lines_through({a, b}), false, width_mm));
  }
  StrokeId box(double x0, double y0, double x1, double y1) {
    return add(stroke_of(lines_through({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}}), true));
  }
  StrokeId circle(Point c, double r) { return add(circle_stroke(c, r)); }
  static StrokePtr circle_stroke(Point c, double r) {
    const double k = 0.5522847498 * r;
    return stroke_of({{c.x + r, c.y},
                      {c.x + r, c.y + k},
                      {c.x + k, c.y + r},
                      {c.x, c.y + r},
                      {c.x - k, c.y + r},
                      {c.x - r, c.y + k},
                      {c.x - r, c.y},
                      {c.x - r, c.y - k},
                      {c.x - k, c.y - r},
                      {c.x, c.y - r},
                      {c.x + k, c.y - r},
                      {c.x + r, c.y - k},
                      {c.x + r, c.y}},
                     true);
  }
};

}  // namespace felt::testing
