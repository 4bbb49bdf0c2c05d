#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "felt/base/check.h"
#include "felt/base/random.h"
#include "felt/document/document.h"
#include "felt/document/edit_builder.h"
#include "felt/fill/testing/map_drawing.h"

namespace felt::testing {

/// A document with strokes for tests of solids.
struct SolidDrawing {
  Document document;

  StrokeId add(StrokePtr stroke) {
    EditBuilder edit(document);
    const StrokeId id = document.new_id();
    edit.add(document.layers().back().id, std::move(stroke));
    FELT_CHECK(document.apply(std::move(edit).build("Draw")).has_value());
    return id;
  }
  StrokeId polygon(std::vector<Point> corners) {
    corners.push_back(corners.front());
    return add(stroke_of(lines_through(corners), true));
  }
  StrokeId polyline(const std::vector<Point>& corners) {
    return add(stroke_of(lines_through(corners)));
  }
  StrokeId circle(Point c, double r) { return add(MapDrawing::circle_stroke(c, r)); }
};

/// Returns the control points of a closed, smooth curve through the points (Catmull, Rom 1974).
inline std::vector<Point> smooth_ring(const std::vector<Point>& at) {
  const std::size_t n = at.size();
  std::vector<Point> points{at[0]};
  for (std::size_t i = 0; i < n; ++i) {
    const Vec out = at[(i + 1) % n] - at[(i + n - 1) % n], in = at[(i + 2) % n] - at[i];
    const Point b = at[(i + 1) % n];
    points.insert(points.end(), {at[i] + out / 6.0, b - in / 6.0, b});
  }
  return points;
}

/// Returns points around a centre, at equal angles, at random distances of at least `low` times the
/// size: a curve through them rarely crosses itself.
inline std::vector<Point> lumps(Random& random, Point centre, double size_mm, int count,
                                double low) {
  std::vector<Point> at;
  for (int k = 0; k < count; ++k) {
    const double a = 2 * std::numbers::pi * k / count;
    const double r = size_mm * random.between(low, 1.0);
    at.push_back({centre.x + r * std::cos(a), centre.y + r * std::sin(a)});
  }
  return at;
}

}  // namespace felt::testing
