#include "tests/drawing/gestures/random_guide.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace felt::gestures {
namespace {

using GuideKind = DrawingGuideKind;

constexpr double kWholeTurn = 2.0 * std::numbers::pi;

std::vector<StrokeId> stroke_ids(const Document& document) {
  std::vector<StrokeId> ids;
  for (const Layer& layer : document.layers()) {
    ids.insert(ids.end(), layer.strokes.begin(), layer.strokes.end());
  }
  return ids;
}

Point within_limits(Point p) {
  constexpr double kMax = DrawingGuide::kMaxCoordinateMm;
  return {std::clamp(p.x, -kMax, kMax), std::clamp(p.y, -kMax, kMax)};
}

/// Returns a point that a guide can have, often one of a stroke.
Point any_origin(Dice& dice, const Document& document) {
  const std::vector<StrokeId> ids = stroke_ids(document);
  Point at{dice.between(-20.0, 120.0), dice.between(-20.0, 120.0)};
  if (!ids.empty() && dice.chance(0.5)) {
    const StrokePtr stroke = document.find(dice.any(ids));
    at = stroke->position(dice.between(0.0, stroke->segment_count()));
  }
  return within_limits(at);
}

void add_teacher_path(Dice& dice, DrawingGuide& guide) {
  double time_ms = dice.between(0.0, 50.0);
  Point at = guide.origin;
  for (int k = dice.pick(2, 60); k > 0; --k) {
    guide.points.push_back(within_limits(at));
    guide.times_ms.push_back(time_ms);
    if (dice.chance(0.9)) at += dice.over_decades(0.01, 8.0) * dice.direction();
    if (dice.chance(0.9)) time_ms += dice.over_decades(0.1, 200.0);
  }
}

Vec ray(double angle_rad) {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

/// Returns a point at the ellipse of a guide, or at a circle around its origin.
Point on_round(const DrawingGuide& guide, double first_mm, double second_mm, double angle) {
  const Vec u = ray(guide.angle_rad);
  return guide.origin + first_mm * std::cos(angle) * u +
         second_mm * std::sin(angle) * Vec{-u.y, u.x};
}

}  // namespace

DrawingGuide random_guide(Dice& dice, const Document& document) {
  DrawingGuide guide;
  guide.kind = static_cast<GuideKind>(dice.pick(kDrawingGuideKinds));
  guide.origin = any_origin(dice, document);
  guide.angle_rad = dice.chance(0.3) ? 0.0 : dice.between(-7.0, 7.0);
  guide.size_mm = dice.over_decades(DrawingGuide::kMinSizeMm, dice.chance(0.1) ? 1e5 : 150.0);
  guide.second_mm = dice.over_decades(DrawingGuide::kMinSizeMm, 150.0);
  guide.step_rad = dice.between(DrawingGuide::kMinStepRad, DrawingGuide::kMaxStepRad);
  guide.axes = dice.pick(DrawingGuide::kMinAxes, DrawingGuide::kMaxAxes);
  guide.strength = dice.chance(0.5) ? 1.0 : dice.between(0.0, 1.0);
  const std::vector<StrokeId> ids = stroke_ids(document);
  if (guide.kind == GuideKind::kTrace && ids.empty()) guide.kind = GuideKind::kLine;
  if (guide.kind == GuideKind::kTrace) guide.stroke = dice.any(ids);
  if (guide.kind == GuideKind::kTeacher) add_teacher_path(dice, guide);
  if (guide.kind == GuideKind::kPerspective) {
    for (int k = dice.pick(1, 3); k > 0; --k) guide.points.push_back(any_origin(dice, document));
  }
  return guide;
}

std::vector<Point> path_along(Dice& dice, const DrawingGuide& guide, int count) {
  const double near = dice.chance(0.7) ? 0.3 : 2.0;
  const Vec beside = dice.between(0.0, near) * dice.direction();
  const double reach_mm = dice.over_decades(3.0, 80.0);
  const double radius_mm =
      guide.kind == GuideKind::kCompass ? dice.over_decades(2.0, 60.0) : guide.size_mm;
  const double second_mm = guide.kind == GuideKind::kCompass ? radius_mm : guide.second_mm;
  const double from = dice.between(0.0, kWholeTurn), turn = dice.between(-1.3, 1.3) * kWholeTurn;
  const bool is_round = guide.kind == GuideKind::kCompass || guide.kind == GuideKind::kEllipse ||
                        guide.kind == GuideKind::kEllipses;
  const Point start = guide.kind == GuideKind::kParallels
                          ? guide.origin + dice.between(0.0, 40.0) * dice.direction()
                          : guide.origin;
  std::vector<Point> path;
  for (int i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) / count;
    Point at = start + t * reach_mm * ray(guide.angle_rad);
    if (is_round) at = on_round(guide, radius_mm, second_mm, from + turn * t);
    if (!guide.points.empty()) {
      const auto k = static_cast<std::size_t>(t * static_cast<double>(guide.points.size() - 1));
      at = guide.kind == GuideKind::kTeacher ? guide.points[k]
                                             : lerp(guide.origin, guide.points.front(), t);
    }
    path.push_back(at + beside);
  }
  return path;
}

}  // namespace felt::gestures
