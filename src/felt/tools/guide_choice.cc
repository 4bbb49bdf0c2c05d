#include "felt/tools/guide_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/base/constants.h"
#include "felt/geometry/nearest.h"
#include "felt/geometry/polyline.h"
#include "felt/haptics/bricks/guide.h"

namespace felt {
namespace {

using Kind = DrawingGuideKind;

constexpr double kMinRadiusMm = 2.0;  // of circles and of the semi-axes of ellipses
constexpr double kMaxRadiusMm = 3000.0;
constexpr double kMinLengthMm = 1.0;
constexpr double kMinStepMm = 0.5;  // between nodes
constexpr double kMinRayStepRad = 1e-3;
constexpr double kNearVanishingMm = 5.0;
constexpr double kApart = 0.45;  // share of the distance between neighbours that a radius may have
constexpr double kTraceStepMm = 0.25;
constexpr std::size_t kMaxTracePoints = 20'000;

bool is_sound(const DrawingGuide& g) noexcept {
  return is_in_range(g.origin) && std::isfinite(g.angle_rad) && std::isfinite(g.size_mm) &&
         std::isfinite(g.second_mm) && std::isfinite(g.step_rad) && std::isfinite(g.strength);
}

std::optional<GuideShape> leg(Point at, Vec along, double length_mm) {
  if (!(length_mm >= kMinLengthMm)) return {};
  return GuideStraight{at, along, 0.0, length_mm};
}

std::optional<GuideShape> ellipse(const DrawingGuide& g, double a_mm, double b_mm) {
  const bool fits = std::min(a_mm, b_mm) >= kMinRadiusMm && std::max(a_mm, b_mm) <= kMaxRadiusMm;
  if (!fits) return {};
  return GuideEllipse{g.origin, g.angle_rad, a_mm, b_mm};
}

/// Returns the ellipse of the family through a point.
std::optional<GuideShape> ellipse_through(const DrawingGuide& g, Point p) {
  if (!(g.size_mm > 0.0 && g.second_mm > 0.0)) return {};
  const Vec off = p - g.origin, u = direction_of(g.angle_rad);
  const double scale = std::hypot(dot(off, u) / g.size_mm, dot(off, perp(u)) / g.second_mm);
  return ellipse(g, scale * g.size_mm, scale * g.second_mm);
}

/// Returns the distance from a shape, also from the ends of a line.
double distance_from(const GuideShape& shape, Point p) noexcept {
  if (const auto* line = std::get_if<GuideStraight>(&shape)) {
    const double at = std::clamp(nearest_on(shape, p).at, line->from_mm, line->to_mm);
    return distance(p, point_at(shape, at));
  }
  return std::fabs(nearest_on(shape, p).distance_mm);
}

bool has_own_shape(Kind kind) noexcept {
  return kind == Kind::kRuler || kind == Kind::kLine || kind == Kind::kSetSquare ||
         kind == Kind::kEllipse || kind == Kind::kTrace || kind == Kind::kTeacher;
}

/// Returns the distance from a stroke, or infinity if it is not less than `limit_mm`.
double distance_below(const Stroke& stroke, Point p, double limit_mm) {
  double nearest_squared = limit_mm * limit_mm;
  bool is_near = false;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic curve = stroke.segment(i);
    if (distance_squared(control_bounds(curve), p) >= nearest_squared) continue;
    const auto near = nearest_within(curve, p, nearest_squared);
    if (!near || !(near->distance_squared < nearest_squared)) continue;
    nearest_squared = near->distance_squared;
    is_near = true;
  }
  return is_near ? std::sqrt(nearest_squared) : kInf;
}

/// Returns the distance of a guide with a shape of its own; infinity without a valid shape. May
/// also return infinity if the distance is not less than `limit_mm`.
double own_distance(const DrawingGuidePtr& guide, const Document& document, Point p,
                    double limit_mm, GuideBounds& bounds) {
  if (const auto shape = guide_shape(*guide, p)) return distance_from(*shape, p);
  if (distance_squared(bounds.of(guide, document), p) >= limit_mm * limit_mm) return kInf;
  bounds.count_search();
  if (guide->kind == Kind::kTrace) {
    const StrokePtr stroke = document.find(guide->stroke);
    return stroke ? distance_below(*stroke, p, limit_mm) : kInf;
  }
  const std::vector<Point>& path = guide->points;
  const bool fits = path.size() >= 2 && std::all_of(path.begin(), path.end(), is_in_range);
  return fits ? std::sqrt(nearest_on_polyline(path, p).distance_squared) : kInf;
}

/// Returns true if a guide without a shape of its own can hold a pen that touches here.
bool acts_at(const DrawingGuide& g, Point p) {
  switch (g.kind) {
    case Kind::kProtractor:
      return g.size_mm > 0.0 && g.step_rad > 0.0 && distance(p, g.origin) <= g.size_mm;
    case Kind::kPerspective:
      return !perspective_lines(g, p).empty();
    case Kind::kGrid:
    case Kind::kIsometricGrid:
      return g.size_mm >= kMinStepMm;
    default:
      return guide_shape(g, p).has_value();
  }
}

}  // namespace

Rect GuideBounds::of(const DrawingGuidePtr& guide, const Document& document) {
  const bool is_trace = guide->kind == Kind::kTrace;
  if (!is_trace && guide->kind != Kind::kTeacher) return {};
  const StrokePtr stroke = is_trace ? document.find(guide->stroke) : nullptr;
  if (is_trace && !stroke) return {};
  std::shared_ptr<const void> key = guide;
  if (is_trace) key = stroke;
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  Rect bounds;
  for (const Point p : is_trace ? stroke->data().points : guide->points) bounds.extend(p);
  if (known_.size() >= 2 * kMaxDrawingGuides) known_.clear();  // most are of the past
  known_.emplace(std::move(key), bounds);
  return bounds;
}

std::optional<std::size_t> choose_guide(std::span<const DrawingGuidePtr> guides,
                                        const Document& document, Point touch,
                                        GuideBounds& bounds) {
  std::optional<std::size_t> own, everywhere;
  std::vector<std::pair<double, std::size_t>> candidates;  // at least so far away, and index
  for (std::size_t i = 0; i < guides.size(); ++i) {
    if (!guides[i] || !is_sound(*guides[i]) || guides[i]->kind == Kind::kSymmetry) continue;
    if (has_own_shape(guides[i]->kind)) {
      candidates.emplace_back(distance_squared(bounds.of(guides[i], document), touch), i);
    } else if (acts_at(*guides[i], touch)) {
      everywhere = i;
    }
  }
  // The nearest bounds first, so that few paths are searched.
  std::sort(candidates.begin(), candidates.end());
  double nearest_mm = kInf;
  for (const auto& [least_squared, i] : candidates) {
    const double away_mm = own_distance(guides[i], document, touch, nearest_mm, bounds);
    const bool is_first = away_mm == nearest_mm && own && i < *own;
    if (away_mm < nearest_mm || is_first) {
      nearest_mm = away_mm;
      own = i;
    }
  }
  return nearest_mm <= kGuideCaptureMm || !everywhere ? own : everywhere;
}

std::optional<GuideShape> guide_shape(const DrawingGuide& g, Point touch) {
  if (!is_sound(g)) return {};
  const Vec u = direction_of(g.angle_rad);
  switch (g.kind) {
    case Kind::kRuler:
      return leg(g.origin, u, g.size_mm);
    case Kind::kLine:
      return GuideStraight{g.origin, u};
    case Kind::kParallels:
      return GuideStraight{touch, u};
    case Kind::kSetSquare: {
      const auto first = leg(g.origin, u, g.size_mm), second = leg(g.origin, perp(u), g.second_mm);
      if (!first || !second) return first ? first : second;
      return distance_from(*second, touch) < distance_from(*first, touch) ? second : first;
    }
    case Kind::kCompass: {
      const double radius = distance(touch, g.origin);
      return ellipse(g, radius, radius);
    }
    case Kind::kEllipse:
      return ellipse(g, g.size_mm, g.second_mm);
    case Kind::kEllipses:
      return ellipse_through(g, touch);
    default:
      return {};
  }
}

std::vector<Point> stroke_path(const Stroke& stroke) {
  double length_mm = 0.0;
  for (int i = 0; i < stroke.segment_count(); ++i) length_mm += control_length(stroke.segment(i));
  const double step = std::max(kTraceStepMm, 2.0 * length_mm / double(kMaxTracePoints));
  std::vector<Point> path{stroke.segment(0).p[0]};
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic curve = stroke.segment(i);
    const int count =
        static_cast<int>(std::clamp(std::ceil(control_length(curve) / step), 1.0, 1000.0));
    for (int k = 1; k <= count; ++k) path.push_back(evaluate(curve, double(k) / count));
    if (path.size() > kMaxTracePoints - 1000) break;
  }
  return path;
}

bool is_closed_path(const Stroke& stroke, std::span<const Point> path) {
  constexpr double kSameMm = 1.0;
  return stroke.closed() && distance(path.front(), path.back()) < kSameMm;
}

std::vector<Point> guide_path(const DrawingGuide& g, const Document& document) {
  if (g.kind == Kind::kTeacher) {
    const bool fits = std::all_of(g.points.begin(), g.points.end(), is_in_range);
    return fits ? g.points : std::vector<Point>();
  }
  const StrokePtr stroke = g.kind == Kind::kTrace ? document.find(g.stroke) : nullptr;
  return stroke ? stroke_path(*stroke) : std::vector<Point>();
}

std::vector<GuideStraight> perspective_lines(const DrawingGuide& g, Point touch) {
  std::vector<GuideStraight> lines;
  if (g.kind != Kind::kPerspective) return lines;
  const std::size_t count = std::min<std::size_t>(g.points.size(), 3);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec to = g.points[i] - touch;
    if (is_in_range(g.points[i]) && norm(to) > kNearVanishingMm)
      lines.push_back({touch, normalized(to)});
  }
  if (count == 1) lines.push_back({touch, {1.0, 0.0}});
  if (count == 1 || count == 2) lines.push_back({touch, {0.0, 1.0}});
  return lines;
}

std::optional<GuideStraight> line_along(std::span<const GuideStraight> lines, Vec movement) {
  std::optional<GuideStraight> best;
  double best_mm = 0.0;
  for (const GuideStraight& line : lines) {
    const double along_mm = std::fabs(dot(line.along, movement));
    if (along_mm > best_mm) {
      best_mm = along_mm;
      best = line;
    }
  }
  return best;
}

int ray_count(const DrawingGuide& g) noexcept {
  return std::max(1, static_cast<int>(kTau / std::max(g.step_rad, kMinRayStepRad) + 1e-9));
}

GuideRay nearest_ray(const DrawingGuide& g, Point pen) noexcept {
  const Vec off = pen - g.origin;
  const double step = std::max(g.step_rad, kMinRayStepRad);
  double turn = std::remainder(std::atan2(off.y, off.x) - g.angle_rad, kTau);
  if (turn < 0.0) turn += kTau;
  const int last = ray_count(g) - 1;
  GuideRay ray;
  ray.number = std::min(static_cast<int>(std::lround(turn / step)), last);
  // If the step does not divide the full turn, the gap before the first ray is wider than a step.
  if (ray.number == last && kTau - turn < turn - last * step) ray.number = 0;
  const Vec along = direction_of(g.angle_rad + ray.number * step);
  ray.line = {g.origin, along, 0.0, std::max(g.size_mm, 0.0)};
  const double out_mm = std::max(0.0, dot(off, along));
  const double apart_mm = 2.0 * std::sin(0.5 * std::min(step, 0.5 * kTau)) * out_mm;
  ray.radius_mm = std::min(GuideLaw::kTickMm, kApart * apart_mm);
  return ray;
}

GuideNode nearest_node(const DrawingGuide& g, Point pen) noexcept {
  const double step = std::max(g.size_mm, kMinStepMm);
  const double corner = g.kind == Kind::kGrid ? 0.25 * kTau : kTau / 6.0;
  const Vec u = direction_of(g.angle_rad), v = direction_of(g.angle_rad + corner);
  const Vec off = (pen - g.origin) / step;
  // Coordinates along u and v: off = i u + j v.
  const double area = cross(u, v);
  const double i = std::floor(cross(off, v) / area), j = std::floor(cross(u, off) / area);
  GuideNode node{.radius_mm = std::min(GuideLaw::kTickMm, kApart * step)};
  double nearest = kInf;
  for (const double di : {0.0, 1.0}) {
    for (const double dj : {0.0, 1.0}) {
      const Point at = g.origin + step * ((i + di) * u + (j + dj) * v);
      if (distance_squared(at, pen) >= nearest) continue;
      nearest = distance_squared(at, pen);
      node.at = at;
    }
  }
  return node;
}

}  // namespace felt
