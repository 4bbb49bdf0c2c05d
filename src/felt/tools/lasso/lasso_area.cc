#include "felt/tools/lasso/lasso_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "felt/geometry/polyline.h"

namespace felt {
namespace {

constexpr std::size_t kMaxStrips = 256;
constexpr double kChordMm = 0.5;
constexpr double kMaxChords = 64.0;

/// Returns the tolerance within which a point counts as on an edge. It allows for rounding and is
/// the same as in geometry/polyline.h.
double edge_width(Point a, Point b) noexcept {
  return 4.0 * std::numeric_limits<double>::epsilon() *
         std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y)});
}

bool is_on(Point a, Point b, Point p) noexcept {
  const double width = edge_width(a, b);
  if (p.x < std::min(a.x, b.x) - width || p.x > std::max(a.x, b.x) + width ||
      p.y < std::min(a.y, b.y) - width || p.y > std::max(a.y, b.y) + width) {
    return false;
  }
  return nearest_on_line(a, b, p).distance_squared <= width * width;
}

/// Returns true if a ray from p along +x crosses the edge. The edge is half-open in y.
bool ray_crosses(Point a, Point b, Point p) noexcept {
  if (a.y <= p.y && b.y > p.y) return cross(b - a, p - a) > 0.0;
  if (b.y <= p.y && a.y > p.y) return cross(b - a, p - a) < 0.0;
  return false;
}

/// Returns true if two line segments share a point, even if they only touch.
bool meet(Point a, Point b, Point c, Point d) noexcept {
  const double ac = cross(b - a, c - a), ad = cross(b - a, d - a);
  const double ca = cross(d - c, a - c), cb = cross(d - c, b - c);
  if (ac == 0.0 && ad == 0.0) {  // collinear
    return std::max(std::min(a.x, b.x), std::min(c.x, d.x)) <=
               std::min(std::max(a.x, b.x), std::max(c.x, d.x)) &&
           std::max(std::min(a.y, b.y), std::min(c.y, d.y)) <=
               std::min(std::max(a.y, b.y), std::max(c.y, d.y));
  }
  const auto apart = [](double x, double y) {
    return (x > 0.0 && y > 0.0) || (x < 0.0 && y < 0.0);
  };
  return !apart(ac, ad) && !apart(ca, cb);
}

}  // namespace

LassoArea::LassoArea(std::vector<Point> outline) : outline_(std::move(outline)) {
  if (outline_.size() < 3) outline_.clear();
  double width = 0.0;
  for (const Point p : outline_) {
    bounds_.extend(p);
    width = std::max(width, edge_width(p, p));
  }
  bounds_ = bounds_.inflated(width);
  const std::size_t strips = std::clamp<std::size_t>(outline_.size(), 1, kMaxStrips);
  strip_mm_ = bounds_.height() / static_cast<double>(strips);

  // Sorts the edges into strips by a counting sort: count, add up, then fill. An edge is in every
  // strip that it crosses.
  const auto for_each_place = [&](const auto& visit) {
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      const Edge e = edge(i);
      const std::size_t last = strip_of(std::max(e.a.y, e.b.y) + width);
      for (std::size_t s = strip_of(std::min(e.a.y, e.b.y) - width); s <= last; ++s) visit(s, i);
    }
  };
  begins_.assign(strips + 1, 0);
  for_each_place([&](std::size_t s, std::size_t) { ++begins_[s + 1]; });
  for (std::size_t s = 0; s < strips; ++s) begins_[s + 1] += begins_[s];
  edges_.resize(begins_.back());
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  for_each_place(
      [&](std::size_t s, std::size_t i) { edges_[next[s]++] = static_cast<std::uint32_t>(i); });
}

std::size_t LassoArea::strip_of(double y) const noexcept {
  const std::size_t last = begins_.empty()
                               ? std::clamp<std::size_t>(outline_.size(), 1, kMaxStrips) - 1
                               : begins_.size() - 2;
  const double strip = strip_mm_ > 0.0 ? (y - bounds_.y0) / strip_mm_ : 0.0;
  return static_cast<std::size_t>(std::clamp(strip, 0.0, static_cast<double>(last)));
}

LassoArea::Edge LassoArea::edge(std::size_t i) const noexcept {
  return {outline_[i], outline_[i + 1 < outline_.size() ? i + 1 : 0]};
}

std::span<const std::uint32_t> LassoArea::edges_in(std::size_t strip) const noexcept {
  return std::span(edges_).subspan(begins_[strip], begins_[strip + 1] - begins_[strip]);
}

bool LassoArea::contains(Point p) const noexcept {
  if (!bounds_.contains(p)) return false;  // also true if p is not finite
  bool inside = false;
  for (const std::uint32_t i : edges_in(strip_of(p.y))) {
    const Edge e = edge(i);
    if (is_on(e.a, e.b, p)) return true;
    if (ray_crosses(e.a, e.b, p)) inside = !inside;
  }
  return inside;
}

bool LassoArea::crosses(Point a, Point b) const noexcept {
  const std::size_t last = strip_of(std::max(a.y, b.y));
  for (std::size_t s = strip_of(std::min(a.y, b.y)); s <= last; ++s) {
    for (const std::uint32_t i : edges_in(s)) {
      const Edge e = edge(i);
      if (meet(a, b, e.a, e.b)) return true;
    }
  }
  return false;
}

bool LassoArea::touches(const Cubic& curve) const noexcept {
  if (!control_bounds(curve).intersects(bounds_)) return false;
  if (contains(curve.p[0]) || contains(curve.p[3])) return true;
  const double chords = std::clamp(control_length(curve) / kChordMm, 4.0, kMaxChords);
  Point last = curve.p[0];
  for (int k = 1; k <= static_cast<int>(chords); ++k) {
    const Point next = evaluate(curve, k / std::floor(chords));
    Rect box;
    box.extend(last);
    box.extend(next);
    if (box.intersects(bounds_) && (contains(next) || crosses(last, next))) return true;
    last = next;
  }
  return false;
}

bool LassoArea::touches(const Stroke& stroke) const noexcept {
  for (int i = 0; i < stroke.segment_count(); ++i) {
    if (touches(stroke.segment(i))) return true;
  }
  return false;
}

double LassoArea::share_inside(const Stroke& stroke) const noexcept {
  double length_mm = 0.0, inside_mm = 0.0;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic curve = stroke.segment(i);
    const bool is_near = control_bounds(curve).intersects(bounds_);
    const double fine = std::clamp(control_length(curve) / kChordMm, 4.0, kMaxChords);
    const int chords = is_near ? static_cast<int>(fine) : 4;
    Point last = curve.p[0];
    for (int k = 1; k <= chords; ++k) {
      const Point next = evaluate(curve, static_cast<double>(k) / chords);
      const double chord_mm = distance(last, next);
      length_mm += chord_mm;
      if (is_near && contains(lerp(last, next, 0.5))) inside_mm += chord_mm;
      last = next;
    }
  }
  if (length_mm > 0.0) return inside_mm / length_mm;
  return stroke.segment_count() > 0 && contains(stroke.segment(0).p[0]) ? 1.0 : 0.0;
}

double swept_area_mm2(std::span<const Point> path) noexcept {
  double twice = 0.0;
  for (std::size_t i = 2; i < path.size(); ++i) {
    twice += std::fabs(cross(path[i - 1] - path[0], path[i] - path[0]));
  }
  return 0.5 * twice;
}

}  // namespace felt
