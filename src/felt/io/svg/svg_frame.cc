#include "felt/io/svg/svg_frame.h"

#include <algorithm>
#include <array>

namespace felt {
namespace {

/// Returns the half planes inside the edges of a viewport on the page; none if a side has no
/// length.
std::vector<SvgHalfPlane> planes_around(const Rect& viewport, const Affine& to_mm) {
  const std::array<Point, 4> corners{
      apply(to_mm, Point{viewport.x0, viewport.y0}), apply(to_mm, Point{viewport.x1, viewport.y0}),
      apply(to_mm, Point{viewport.x1, viewport.y1}), apply(to_mm, Point{viewport.x0, viewport.y1})};
  // Frames without a rotation keep exact edges.
  const bool is_upright = to_mm.b == 0.0 && to_mm.c == 0.0;
  if (is_upright || (to_mm.a == 0.0 && to_mm.d == 0.0)) {
    Rect box;
    for (const Point p : corners) box.extend(p);
    return {
        {{-1.0, 0.0}, -box.x0}, {{1.0, 0.0}, box.x1}, {{0.0, -1.0}, -box.y0}, {{0.0, 1.0}, box.y1}};
  }
  const Point middle = lerp(corners[0], corners[2], 0.5);
  std::vector<SvgHalfPlane> planes;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i], b = corners[(i + 1) % corners.size()];
    if (!(distance(a, b) > 0.0)) return {};
    Vec normal = perp(normalized(b - a));
    if (dot(normal, middle - a) > 0.0) normal = -1.0 * normal;
    planes.push_back({normal, dot(normal, a - Point{})});
  }
  return planes;
}

std::array<Point, 4> corners_of(const Rect& box) {
  return {Point{box.x0, box.y0}, Point{box.x1, box.y0}, Point{box.x1, box.y1},
          Point{box.x0, box.y1}};
}

}  // namespace

bool SvgFrame::cut(const Rect& viewport, const Affine& to_mm) {
  const std::vector<SvgHalfPlane> added = planes_around(viewport, to_mm);
  std::vector<SvgHalfPlane> planes = planes_;
  for (const SvgHalfPlane& plane : added) {
    const auto same = std::find_if(planes.begin(), planes.end(),
                                   [&](const SvgHalfPlane& p) { return p.normal == plane.normal; });
    if (same == planes.end()) {
      planes.push_back(plane);
    } else {
      same->limit_mm = std::min(same->limit_mm, plane.limit_mm);
    }
  }
  if (added.empty() || planes.size() > kMaxPlanes) return false;
  planes_ = std::move(planes);
  return true;
}

bool SvgFrame::contains(const Rect& box, double margin_mm) const {
  const std::array<Point, 4> corners = corners_of(box);
  return std::all_of(planes_.begin(), planes_.end(), [&](const SvgHalfPlane& plane) {
    return std::all_of(corners.begin(), corners.end(),
                       [&](Point p) { return plane.outside_mm(p) <= margin_mm; });
  });
}

bool SvgFrame::misses(const Rect& box) const {
  const std::array<Point, 4> corners = corners_of(box);
  return std::any_of(planes_.begin(), planes_.end(), [&](const SvgHalfPlane& plane) {
    return std::all_of(corners.begin(), corners.end(),
                       [&](Point p) { return plane.outside_mm(p) > 0.0; });
  });
}

}  // namespace felt
