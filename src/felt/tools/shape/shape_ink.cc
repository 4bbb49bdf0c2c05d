#include "felt/tools/shape/shape_ink.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "felt/stroke/fit/width_map.h"
#include "felt/tools/direction_steps.h"
#include "felt/tools/medium_line.h"

namespace felt {
namespace {

/// Length of the handles of a quarter of a circle of radius 1. The largest error of the radius is
/// 0.0196 %, the smallest that four segments can have [Spencer Mortensen,
/// https://spencermortensen.com/articles/bezier-circle/].
constexpr double kQuarterHandle = 0.551915024493510;
constexpr double kMouseShare = 0.5;

Vec regular_way(ShapeKind kind, Vec way) noexcept {
  if (kind == ShapeKind::kLine) return in_direction_steps(way);
  const double side = std::max(std::abs(way.x), std::abs(way.y));
  return {std::copysign(side, way.x), std::copysign(side, way.y)};
}

void add_straight_side(std::vector<Point>& points, Point to) {
  const Point from = points.back();
  points.insert(points.end(), {lerp(from, to, 1.0 / 3.0), lerp(from, to, 2.0 / 3.0), to});
}

std::vector<Point> rectangle_points(const ShapeCorners& c) {
  std::vector<Point> points{c.from};
  add_straight_side(points, {c.to.x, c.from.y});
  add_straight_side(points, c.to);
  add_straight_side(points, {c.from.x, c.to.y});
  add_straight_side(points, c.from);
  return points;
}

/// The tangents at the joints are exactly parallel to the axes, so the joints are exactly smooth.
std::vector<Point> ellipse_points(const ShapeCorners& c) {
  const Point m = lerp(c.from, c.to, 0.5);
  const double rx = 0.5 * std::abs(c.to.x - c.from.x), ry = 0.5 * std::abs(c.to.y - c.from.y);
  const double hx = kQuarterHandle * rx, hy = kQuarterHandle * ry;
  const double left = m.x - rx, right = m.x + rx, top = m.y - ry, bottom = m.y + ry;
  return {{right, m.y},       {right, m.y + hy}, {m.x + hx, bottom}, {m.x, bottom},
          {m.x - hx, bottom}, {left, m.y + hy},  {left, m.y},        {left, m.y - hy},
          {m.x - hx, top},    {m.x, top},        {m.x + hx, top},    {right, m.y - hy},
          {right, m.y}};
}

}  // namespace

ShapeCorners shape_corners(ShapeKind kind, Point touch, Point pen,
                           const ShapeRules& rules) noexcept {
  Vec way = pen - touch;
  if (rules.is_regular) way = regular_way(kind, way);
  return {rules.is_from_centre ? touch - way : touch, touch + way};
}

std::optional<Stroke> shape_stroke(ShapeKind kind, const ShapeCorners& corners,
                                   const Scene& scene) {
  const Vec size = corners.to - corners.from;
  const bool is_line = kind == ShapeKind::kLine;
  const double smallest = is_line ? norm(size) : std::min(std::abs(size.x), std::abs(size.y));
  if (!(smallest >= kMinShapeMm)) return std::nullopt;
  StrokeData data;
  if (is_line) {
    data.points = {corners.from};
    add_straight_side(data.points, corners.to);
  } else {
    const bool is_smooth = kind == ShapeKind::kEllipse;
    data.points = is_smooth ? ellipse_points(corners) : rectangle_points(corners);
    data.joints.assign(4, is_smooth ? JointKind::kSmooth : JointKind::kCorner);
    data.closed = true;
  }
  const WidthMapOptions widths = drawn_with(medium_of(scene, scene.medium), {}).width_map;
  const double width_mm = std::max(scene.ink_width_mm, kMinWidthMm);
  const double tone = widths.tone ? tone_of(widths, kMouseShare, 0.0) : tone_of_width(width_mm);
  data.widths = {{0.0, width_mm, tone}, {is_line ? 1.0 : 4.0, width_mm, tone}};
  data.medium = std::string(scene.medium);
  data.color = scene.color;
  Result<Stroke> stroke = Stroke::create(std::move(data));
  if (!stroke) return std::nullopt;
  return *std::move(stroke);
}

}  // namespace felt
