#include "felt/session/line_stroke.h"

#include <utility>
#include <vector>

#include "felt/geometry/cubic.h"

namespace felt {
namespace {

/// Longer segments than the shortest one, so that rounding makes none too short.
constexpr double kMinStepMm = 2.0 * kMinSegmentMm;

std::vector<Point> distinct_line(const AddLine& line) {
  std::vector<Point> points;
  for (const Point p : line.points) {
    if (points.empty() || distance(points.back(), p) >= kMinStepMm) points.push_back(p);
  }
  if (!line.is_closed) return points;
  while (points.size() > 1 && distance(points.back(), points.front()) < kMinStepMm) {
    points.pop_back();
  }
  points.push_back(points.front());
  return points;
}

}  // namespace

Result<Stroke> stroke_of_line(const AddLine& line, const std::string& medium, Rgba color) {
  if (line.points.size() < 2 || line.points.size() > AddLine::kMaxPoints) {
    return fail(ErrorCode::kInvalidArgument,
                "points: a line has 2 to " + std::to_string(AddLine::kMaxPoints) + " points");
  }
  if (!(line.width_mm >= kMinWidthMm && line.width_mm <= AddLine::kMaxWidthMm)) {
    return fail(ErrorCode::kInvalidArgument, "width_mm: must be 0.05 to 50");
  }
  for (const Point p : line.points) {
    if (!is_finite(p)) return fail(ErrorCode::kInvalidArgument, "points: must be finite");
  }
  const std::vector<Point> points = distinct_line(line);
  if (points.size() < (line.is_closed ? 3U : 2U)) {
    return fail(ErrorCode::kInvalidArgument, "points: the line is too short");
  }
  StrokeData data{.points = {points.front()},
                  .joints = {},
                  .closed = line.is_closed,
                  .widths = {},
                  .medium = medium,
                  .color = color};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Cubic c = straight(points[i - 1], points[i]);
    data.points.insert(data.points.end(), c.p.begin() + 1, c.p.end());
    if (i > 1 || line.is_closed) data.joints.push_back(JointKind::kCorner);
  }
  data.widths = {{0.0, line.width_mm}, {static_cast<double>(points.size() - 1), line.width_mm}};
  return Stroke::create(std::move(data));
}

}  // namespace felt
