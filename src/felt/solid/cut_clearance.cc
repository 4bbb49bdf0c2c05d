#include "felt/solid/cut_clearance.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "felt/geometry/polyline.h"
#include "felt/geometry/rect.h"

namespace felt {
namespace cut_clearances {

constexpr double kClearSteps = 0.25;

/// The stroke of a region, with boxes around runs of its segments.
class StrokeSearch {
 public:
  StrokeSearch(const CutRegion& region, double reach_mm)
      : points_(std::span(region.ring).first(region.stroke_points)), reach_mm_(reach_mm) {
    for (std::size_t i = 0; i + 1 < points_.size(); i += kRun) {
      Rect box;
      for (std::size_t k = i; k <= std::min(i + kRun, points_.size() - 1); ++k) {
        box.extend(points_[k]);
      }
      boxes_.push_back(box.inflated(reach_mm));
      whole_.extend(boxes_.back());
    }
  }

  /// A segment of the stroke near a point, and the distance from it: positive at its left.
  struct Near {
    std::size_t segment = 0;
    double signed_mm = 0.0;
  };
  /// Returns the nearest segment within the reach, or nullopt.
  [[nodiscard]] std::optional<Near> nearest(Point p) const;
  [[nodiscard]] Vec left_of(std::size_t segment) const {
    return perp(normalized(points_[segment + 1] - points_[segment]));
  }

 private:
  static constexpr std::size_t kRun = 16;
  std::span<const Point> points_;
  double reach_mm_;
  std::vector<Rect> boxes_;
  Rect whole_;
};

std::optional<StrokeSearch::Near> StrokeSearch::nearest(Point p) const {
  std::optional<Near> found;
  if (!whole_.contains(p)) return found;
  double best = reach_mm_ * reach_mm_;
  for (std::size_t run = 0; run < boxes_.size(); ++run) {
    if (!boxes_[run].contains(p)) continue;
    const std::size_t end = std::min(kRun * (run + 1), points_.size() - 1);
    for (std::size_t i = kRun * run; i < end; ++i) {
      const Point a = points_[i], b = points_[i + 1];
      const double squared = nearest_on_line(a, b, p).distance_squared;
      if (squared > best) continue;
      best = squared;
      found = {i, std::copysign(std::sqrt(squared), cross(b - a, p - a))};
    }
  }
  return found;
}

/// Tells on which side of a region points are. Points near its stroke are on neither.
class Sides {
 public:
  Sides(const CutRegion& region, double tolerance_mm)
      : ring_(region.ring), stroke_(region, tolerance_mm) {
    for (const Point p : ring_) box_.extend(p);
  }
  [[nodiscard]] bool is_on_stroke(Point p) const { return stroke_.nearest(p).has_value(); }
  [[nodiscard]] bool is_inside(Point p) const {
    return box_.contains(p) && contains(ring_, p, FillRule::kEvenOdd);
  }

 private:
  std::span<const Point> ring_;
  StrokeSearch stroke_;
  Rect box_;
};

/// Returns true if an edge of the body, both ends of which are on the other side or on the stroke,
/// passes through the inside of the region, or through its outside. Such a part of the body is
/// narrower than a triangle.
bool passes_through(const CutRegion& region, const Sides& sides, bool inside, Point a, Point b) {
  std::vector<double> at;
  const Vec along = b - a;
  for (std::size_t i = 0; i + 1 < region.stroke_points; ++i) {
    const Point c = region.ring[i], d = region.ring[i + 1];
    const double down = cross(along, c - a), up = cross(along, d - a);
    if ((down > 0.0) == (up > 0.0)) continue;
    const Point p = lerp(c, d, down / (down - up));
    const double t = dot(p - a, along) / norm_squared(along);
    if (t > 0.0 && t < 1.0) at.push_back(t);
  }
  std::sort(at.begin(), at.end());
  for (std::size_t i = 1; i < at.size(); ++i) {
    const Point p = lerp(a, b, 0.5 * (at[i - 1] + at[i]));
    if (sides.is_inside(p) == inside && !sides.is_on_stroke(p)) return true;
  }
  return false;
}

}  // namespace cut_clearances

CutEffect cut_effect(const SolidBody& body, const ViewFrame& frame, const CutRegion& region,
                     double tolerance_mm) {
  using namespace cut_clearances;
  const Sides sides(region, tolerance_mm);
  bool goes = false, stays = false;
  for (const Vec3& point : body.points) {
    const Point p = frame.to_picture(point);
    if (goes && stays) break;
    if (sides.is_on_stroke(p)) continue;
    (sides.is_inside(p) ? goes : stays) = true;
  }
  if (goes && stays) return CutEffect::kRemovesPart;
  Rect box;
  for (std::size_t i = 0; i < region.stroke_points; ++i) box.extend(region.ring[i]);
  for (const SolidBody::Triangle& t : body.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] > t[(k + 1) % 3]) continue;  // each edge belongs to two triangles
      const Point a = frame.to_picture(body.points[t[k]]);
      const Point b = frame.to_picture(body.points[t[(k + 1) % 3]]);
      Rect of_edge;
      of_edge.extend(a), of_edge.extend(b);
      if (of_edge.intersects(box) && passes_through(region, sides, !goes, a, b)) {
        return CutEffect::kRemovesPart;
      }
    }
  }
  return goes ? CutEffect::kRemovesAll : CutEffect::kRemovesNothing;
}

void move_off_points(const SolidBody& body, const ViewFrame& frame, double step_mm,
                     CutRegion& region) {
  using namespace cut_clearances;
  const double clear_mm = kClearSteps * step_mm;
  const CutRegion old = region;
  const StrokeSearch stroke(old, (kMaxClearanceSteps + 1) * step_mm);
  std::vector<std::optional<StrokeSearch::Near>> near;
  std::vector<double> distances;
  bool is_clear = true;
  for (const Vec3& point : body.points) {
    near.push_back(stroke.nearest(frame.to_picture(point)));
    if (!near.back()) continue;
    distances.push_back(near.back()->signed_mm);
    is_clear = is_clear && std::fabs(near.back()->signed_mm) > clear_mm;
  }
  if (is_clear) return;
  double facing_left = 0.0;  // area of the faces on the stroke
  for (const auto& [a, b, c] : body.triangles) {
    const auto is_on = [&](std::uint32_t i) {
      return near[i] && std::fabs(near[i]->signed_mm) <= 2.0 * step_mm;
    };
    if (!is_on(a) || !is_on(b) || !is_on(c)) continue;
    const Vec3 n = cross(body.points[b] - body.points[a], body.points[c] - body.points[a]);
    const Vec left = stroke.left_of(near[a]->segment);
    facing_left += dot(left, Vec{dot(frame.right, n), dot(frame.up, n)});
  }
  const double sign = facing_left < 0.0 ? -1.0 : 1.0;
  std::pair<std::size_t, int> best{distances.size() + 1, 1};  // points in the way, steps
  for (int steps = 1; steps <= kMaxClearanceSteps && best.first > 0; ++steps) {
    const auto in_way = std::count_if(distances.begin(), distances.end(), [&](double d) {
      return std::fabs(d - sign * steps * step_mm) <= clear_mm;
    });
    best = std::min(best, {static_cast<std::size_t>(in_way), steps});
  }
  const double by_mm = sign * best.second * step_mm;
  for (std::size_t i = 0; i < old.stroke_points; ++i) {
    const Vec in = i > 0 ? stroke.left_of(i - 1) : Vec{};
    const Vec out = i + 1 < old.stroke_points ? stroke.left_of(i) : Vec{};
    region.ring[i] = old.ring[i] + by_mm * normalized(in + out);
  }
}

std::size_t points_on_stroke(const SolidBody& body, const ViewFrame& frame, const CutRegion& region,
                             double reach_mm) {
  const cut_clearances::StrokeSearch stroke(region, reach_mm);
  return static_cast<std::size_t>(std::count_if(
      body.points.begin(), body.points.end(),
      [&](const Vec3& p) { return stroke.nearest(frame.to_picture(p)).has_value(); }));
}

}  // namespace felt
