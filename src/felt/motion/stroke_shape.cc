#include "felt/motion/stroke_shape.h"

#include <algorithm>
#include <cmath>

#include "felt/geometry/polyline.h"

namespace felt {
namespace {

constexpr int kLineSteps = 8;  // of a segment

void finish_shape(StrokeShape& shape) noexcept {
  Vec sum{};
  for (const Point p : shape.points) sum += p - Point{};
  shape.centre = Point{} + sum / static_cast<double>(kShapePoints);
  Vec before{};
  for (std::size_t i = 1; i < kShapePoints; ++i) {
    const Vec step = shape.points[i] - shape.points[i - 1];
    if (norm(step) == 0.0) continue;
    if (norm(before) > 0.0) shape.turning_rad += std::atan2(cross(before, step), dot(before, step));
    before = step;
  }
}

/// Returns the mean distance if point i of a is paired with point start + i * step of b, modulo the
/// number of points, or something larger than `best` as soon as that is known.
double mean_distance(const StrokeShape& a, const StrokeShape& b, std::size_t start,
                     std::size_t step, double best) noexcept {
  double sum = 0.0;
  const double limit = best * static_cast<double>(kShapePoints);
  std::size_t k = start;
  for (std::size_t i = 0; i < kShapePoints && sum < limit; ++i) {
    sum += distance(a.points[i], b.points[k]);
    k += step;
    if (k >= kShapePoints) k -= kShapePoints;
  }
  return sum / static_cast<double>(kShapePoints);
}

}  // namespace

std::vector<Point> coarse_line(const Stroke& stroke) {
  std::vector<Point> line{stroke.data().points.front()};
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic segment = stroke.segment(i);
    for (int k = 1; k <= kLineSteps; ++k) {
      line.push_back(evaluate(segment, static_cast<double>(k) / kLineSteps));
    }
  }
  return line;
}

StrokeShape shape_of(std::span<const Point> line) {
  StrokeShape shape;
  shape.length_mm = std::max(polyline_length(line), kMinSegmentMm);
  resample(line, shape.points);
  finish_shape(shape);
  return shape;
}

StrokeShape shape_of(const Stroke& stroke) {
  const std::vector<Point> line = coarse_line(stroke);
  if (!stroke.closed()) return shape_of(line);
  StrokeShape shape;
  shape.closed = true;
  shape.length_mm = std::max(polyline_length(line), kMinSegmentMm);
  std::array<Point, kShapePoints + 1> around{};
  resample(line, around);
  std::copy_n(around.begin(), kShapePoints, shape.points.begin());
  finish_shape(shape);
  return shape;
}

ShapePairing pair_shapes(const StrokeShape& a, const StrokeShape& b, double limit_mm) noexcept {
  // A start on a closed shape is one of b; if only a is closed, shifting b cyclically is the same.
  const std::size_t shifts = a.closed || b.closed ? kShapePoints : 1;
  ShapePairing best{mean_distance(a, b, 0, 1, limit_mm), false, 0};
  for (std::size_t shift = 0; shift < shifts; ++shift) {
    const double same = mean_distance(a, b, shift, 1, best.distance_mm);
    if (same < best.distance_mm) best = {same, false, shift};
    const std::size_t last = (shift + kShapePoints - 1) % kShapePoints;
    const double other = mean_distance(a, b, last, kShapePoints - 1, best.distance_mm);
    if (other < best.distance_mm) best = {other, true, last};
  }
  return best;
}

Point paired_point(const StrokeShape& b, const ShapePairing& pairing, std::size_t i) noexcept {
  const std::size_t step = pairing.reversed ? kShapePoints - i : i;
  return b.points[(pairing.shift + step) % kShapePoints];
}

}  // namespace felt
