#include "felt/tools/guide/guide_handles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/base/constants.h"
#include "felt/geometry/nearest.h"
#include "felt/tools/direction_steps.h"

namespace felt {
namespace {

using HandleKind = DrawingGuideKind;
constexpr double kDirectionHandleMm = 40.0;  // of guides without a size; chosen
constexpr double kCellsToHandle = 8.0;       // a handle at one cell of a grid would be too near
constexpr double kFar = std::numeric_limits<double>::infinity();

Vec along(const DrawingGuide& guide) noexcept {
  return {std::cos(guide.angle_rad), std::sin(guide.angle_rad)};
}
Vec aside(const DrawingGuide& guide) noexcept {
  const Vec d = along(guide);
  return {-d.y, d.x};
}

double clamped_size(double mm) noexcept {
  return std::clamp(mm, DrawingGuide::kMinSizeMm, DrawingGuide::kMaxSizeMm);
}
Point clamped(Point p) noexcept {
  constexpr double kMax = DrawingGuide::kMaxCoordinateMm;
  return {std::clamp(p.x, -kMax, kMax), std::clamp(p.y, -kMax, kMax)};
}

/// Returns the direction of a drag; `fallback` if the drag is too short.
double angle_of(Vec way, GuideTurn turn, double fallback) noexcept {
  if (turn == GuideTurn::kInSteps) way = in_direction_steps(way);
  return norm(way) > 0.01 ? std::atan2(way.y, way.x) : fallback;
}

/// Returns the distance of the handle that turns the guide from its origin; 0 if it has none.
double handle_mm(const DrawingGuide& guide) noexcept {
  switch (guide.kind) {
    case HandleKind::kRuler:
    case HandleKind::kSetSquare:
    case HandleKind::kProtractor:
    case HandleKind::kEllipse:
    case HandleKind::kEllipses:
      return guide.size_mm;
    case HandleKind::kGrid:
    case HandleKind::kIsometricGrid:
      return kCellsToHandle * guide.size_mm;
    case HandleKind::kLine:
    case HandleKind::kParallels:
    case HandleKind::kSymmetry:
      return kDirectionHandleMm;
    default:
      return 0.0;
  }
}

bool has_second(HandleKind kind) noexcept {
  return kind == HandleKind::kSetSquare || kind == HandleKind::kEllipse ||
         kind == HandleKind::kEllipses;
}

/// Sets the size that a handle at this distance from the origin means.
void set_size(DrawingGuide& guide, double mm) noexcept {
  if (guide.kind == HandleKind::kGrid || guide.kind == HandleKind::kIsometricGrid)
    mm /= kCellsToHandle;
  guide.size_mm = clamped_size(mm);
}

bool has_size(HandleKind kind) noexcept {
  return kind != HandleKind::kLine && kind != HandleKind::kParallels &&
         kind != HandleKind::kSymmetry && kind != HandleKind::kCompass;
}

double to_segment(Point p, Point a, Point b) noexcept {
  const Vec way = b - a;
  const double square = dot(way, way);
  const double t = square > 0.0 ? std::clamp(dot(p - a, way) / square, 0.0, 1.0) : 0.0;
  return distance(p, lerp(a, b, t));
}

double to_line(Point p, Point through, Vec d) noexcept {
  return std::abs(dot(p - through, Vec{-d.y, d.x}));
}

double to_axes(const DrawingGuide& guide, Point p) noexcept {
  double nearest_mm = kFar;
  for (int i = 0; i < guide.axes; ++i) {
    const double angle_rad = guide.angle_rad + 0.5 * kTau * i / guide.axes;
    nearest_mm =
        std::min(nearest_mm, to_line(p, guide.origin, {std::cos(angle_rad), std::sin(angle_rad)}));
  }
  return nearest_mm;
}

double to_ellipse(const DrawingGuide& guide, Point p) {
  constexpr int kSteps = 180;
  double nearest_mm = kFar;
  Point last{};
  for (int i = 0; i <= kSteps; ++i) {
    const double t = kTau * i / kSteps;
    const Point at = guide.origin + (guide.size_mm * std::cos(t)) * along(guide) +
                     (guide.second_mm * std::sin(t)) * aside(guide);
    if (i > 0) nearest_mm = std::min(nearest_mm, to_segment(p, last, at));
    last = at;
  }
  return nearest_mm;
}

double to_path(const std::vector<Point>& path, Point p) {
  double nearest_mm = kFar;
  for (std::size_t i = 1; i < path.size(); ++i) {
    nearest_mm = std::min(nearest_mm, to_segment(p, path[i - 1], path[i]));
  }
  return nearest_mm;
}

double to_stroke(const Stroke& stroke, Point p) {
  double nearest_squared = kFar;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const auto near = nearest_within(stroke.segment(i), p, nearest_squared);
    if (near) nearest_squared = std::min(nearest_squared, near->distance_squared);
  }
  return std::sqrt(nearest_squared);
}

}  // namespace

std::vector<Point> guide_handles(const DrawingGuide& guide) {
  if (guide.kind == HandleKind::kPerspective) return guide.points;
  if (guide.kind == HandleKind::kTrace || guide.kind == HandleKind::kTeacher) return {};
  std::vector<Point> handles{guide.origin};
  if (const double mm = handle_mm(guide); mm > 0.0) {
    handles.push_back(guide.origin + mm * along(guide));
  }
  if (has_second(guide.kind)) handles.push_back(guide.origin + guide.second_mm * aside(guide));
  return handles;
}

DrawingGuide with_guide_handle(const DrawingGuide& guide, std::size_t handle, Point to,
                               GuideTurn turn) {
  DrawingGuide changed = guide;
  if (guide.kind == HandleKind::kPerspective) {
    changed.points[handle] = clamped(to);
    return changed;
  }
  if (handle == 0) {
    changed.origin = clamped(to);
    return changed;
  }
  const Vec way = to - guide.origin;
  if (handle == 1) {
    changed.angle_rad = angle_of(way, turn, guide.angle_rad);
    if (has_size(guide.kind)) set_size(changed, std::max(dot(way, along(changed)), 0.0));
  } else {
    changed.second_mm = clamped_size(std::abs(dot(way, aside(guide))));
  }
  return changed;
}

DrawingGuide moved_guide(const DrawingGuide& guide, Vec by_mm) {
  DrawingGuide moved = guide;
  if (guide.kind == HandleKind::kTrace) return moved;
  moved.origin = clamped(guide.origin + by_mm);
  for (Point& p : moved.points) p = clamped(p + by_mm);
  return moved;
}

DrawingGuide placed_guide(const DrawingGuide& plain, Point from, Point to, int vanishing_points,
                          GuideTurn turn) {
  DrawingGuide guide = plain;
  guide.origin = clamped(from);
  const Vec way = to - from;
  const bool is_drag = norm(way) >= kMinGuideDragMm;
  if (guide.kind == HandleKind::kPerspective) {
    constexpr double kApartMm = 150.0;  // of the points without a drag; chosen: an A5 page
    const Vec d = is_drag ? way : Vec{kApartMm, 0.0};
    guide.points = {clamped(from)};
    if (vanishing_points > 1) guide.points.push_back(clamped(from + d));
    if (vanishing_points > 2) {
      guide.points.push_back(clamped(from + 0.5 * d + Vec{-d.y, d.x}));
    }
    return guide;
  }
  if (guide.kind == HandleKind::kGrid || guide.kind == HandleKind::kIsometricGrid)
    guide.size_mm = 5.0;
  if (guide.kind == HandleKind::kSymmetry && !is_drag) guide.angle_rad = -0.25 * kTau;
  if (!is_drag) return guide;
  guide.angle_rad = angle_of(way, turn, guide.angle_rad);
  if (!has_size(guide.kind)) return guide;
  set_size(guide, std::max(dot(way, along(guide)), 0.0));
  guide.second_mm = clamped_size(0.6 * guide.size_mm);
  return guide;
}

double distance_to_guide(const DrawingGuide& guide, const Document& document, Point p) {
  const Point end = guide.origin + guide.size_mm * along(guide);
  const Point second = guide.origin + guide.second_mm * aside(guide);
  switch (guide.kind) {
    case HandleKind::kRuler:
      return to_segment(p, guide.origin, end);
    case HandleKind::kLine:
    case HandleKind::kParallels:
      return to_line(p, guide.origin, along(guide));
    case HandleKind::kSetSquare:
      return std::min({to_segment(p, guide.origin, end), to_segment(p, guide.origin, second),
                       to_segment(p, end, second)});
    case HandleKind::kProtractor:
      return std::abs(distance(p, guide.origin) - guide.size_mm);
    case HandleKind::kEllipse:
    case HandleKind::kEllipses:
      return to_ellipse(guide, p);
    case HandleKind::kSymmetry:
      return to_axes(guide, p);
    case HandleKind::kTrace: {
      const StrokePtr stroke = document.find(guide.stroke);
      return stroke ? to_stroke(*stroke, p) : kFar;
    }
    case HandleKind::kTeacher:
      return to_path(guide.points, p);
    case HandleKind::kCompass:
    case HandleKind::kPerspective:
    case HandleKind::kGrid:
    case HandleKind::kIsometricGrid:
      return kFar;
  }
  return kFar;
}

}  // namespace felt
