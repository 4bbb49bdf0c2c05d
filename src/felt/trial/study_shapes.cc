#include "felt/trial/study_shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "felt/base/check.h"

namespace felt {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Returns count + 1 points of a curve with a parameter from 0 to 1.
std::vector<Point> sampled(int count, const std::function<Point(double)>& at) {
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i) points.push_back(at(static_cast<double>(i) / count));
  return points;
}

/// Returns the point at `radius` and `turns` from the top, clockwise (y points down).
Point on_circle(double radius, double turns) {
  return {radius * std::sin(kTurn * turns), -radius * std::cos(kTurn * turns)};
}

/// Returns a shape of any size and position.
std::vector<Point> raw_path(StudyShapeKind kind) {
  switch (kind) {
    case StudyShapeKind::kLine:
    case StudyShapeKind::kFile:
      break;
    case StudyShapeKind::kCircle:
      return sampled(360, [](double t) { return on_circle(1.0, t); });
    case StudyShapeKind::kSpiral:
      return sampled(1080, [](double t) { return on_circle(12.0 + 25.0 * t, 3.0 * t); });
    case StudyShapeKind::kWave:
      return sampled(720, [](double t) {
        return Point{132.0 * t, -8.0 * std::sin(2.0 * kTurn * t)};
      });
    case StudyShapeKind::kStar:
      return sampled(10, [](double t) {
        const bool is_tip = std::lround(10.0 * t) % 2 == 0;
        return on_circle(is_tip ? 25.0 : 10.0, t);
      });
  }
  return {{0.0, 0.0}, {1.0, 0.0}};
}

}  // namespace

std::vector<Point> shape_path(StudyShapeKind kind, double size_mm) {
  FELT_CHECK(kind != StudyShapeKind::kFile && size_mm > 0.0);
  std::vector<Point> points = raw_path(kind);
  const auto [left, right] = std::minmax_element(
      points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  const auto [top, bottom] = std::minmax_element(
      points.begin(), points.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
  const double scale = size_mm / std::max(right->x - left->x, bottom->y - top->y);
  const Point centre{0.5 * (left->x + right->x), 0.5 * (top->y + bottom->y)};
  for (Point& p : points) p = {scale * (p.x - centre.x), scale * (p.y - centre.y)};
  return points;
}

}  // namespace felt
