#include "felt/recognise/shape_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace felt {
namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

/// Adds cubics along an ellipse. The handles have the length 4/3 tan(a/4) for an angle a: then the
/// middle of each segment is on the ellipse, and the radius is exact to 0.03 % for quarters
/// (Goldapp, DOI 10.1016/0167-8396(91)90007-X). Each joint uses the same tangent on both sides.
void add_ellipse(const ShapeGuess& shape, StrokeData& data) {
  const int count =
      std::max(1, static_cast<int>(std::ceil(std::abs(shape.sweep) / kQuarter - 1e-9)));
  const double step = shape.sweep / count, handle = 4.0 / 3.0 * std::tan(0.25 * step);
  const Vec u{std::cos(shape.angle), std::sin(shape.angle)}, v = perp(u);
  const auto arm = [&](double angle) {
    return shape.long_mm * std::cos(angle) * u + shape.short_mm * std::sin(angle) * v;
  };
  const auto tangent = [&](double angle) {
    return handle * (shape.short_mm * std::cos(angle) * v - shape.long_mm * std::sin(angle) * u);
  };
  // `from` is the direction of the start; the parameter of an ellipse differs from it.
  const double start =
      std::atan2(std::sin(shape.from) * shape.long_mm, std::cos(shape.from) * shape.short_mm);
  for (int i = 0; i < count; ++i) {
    const double a = start + i * step, b = start + (i + 1) * step;
    const Point from = shape.center + arm(a), to = shape.center + arm(b);
    if (i == 0) data.points.push_back(from);
    const bool closes = data.closed && i + 1 == count;
    const Point end = closes ? data.points.front() : to;
    const Vec last = closes ? tangent(start) : tangent(b);
    data.points.insert(data.points.end(), {data.points.back() + tangent(a), end - last, end});
  }
  const int joints = data.closed ? count : count - 1;
  data.joints.assign(static_cast<std::size_t>(joints), JointKind::kSmooth);
}

void add_side(StrokeData& data, Point to) {
  const Point from = data.points.back();
  data.points.insert(data.points.end(), {lerp(from, to, 1.0 / 3.0), lerp(from, to, 2.0 / 3.0), to});
}

}  // namespace

StrokeData shape_curve(const ShapeGuess& shape) {
  StrokeData data;
  switch (shape.form) {
    case ShapeForm::kCircle:
    case ShapeForm::kEllipse:
      data.closed = true;
      [[fallthrough]];
    case ShapeForm::kArc:
      add_ellipse(shape, data);
      return data;
    case ShapeForm::kTriangle:
    case ShapeForm::kRectangle:
    case ShapeForm::kPolygon:
      data.closed = true;
      break;
    case ShapeForm::kLine:
      break;
  }
  if (shape.corners.empty()) return data;
  data.points.push_back(shape.corners.front());
  for (std::size_t i = 1; i < shape.corners.size(); ++i) add_side(data, shape.corners[i]);
  if (data.closed) add_side(data, shape.corners.front());
  data.joints.assign(shape.corners.size() - (data.closed ? 0 : 2), JointKind::kCorner);
  return data;
}

}  // namespace felt
