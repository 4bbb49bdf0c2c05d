#include "desktop/solid/body_strokes.h"

#include <cmath>
#include <numbers>

namespace felt::desktop {
namespace {

constexpr double kMinStepPx = 0.34;

/// The point of the solid under a pixel, on the plane through its origin that faces the camera.
Vec3 under_pixel(const SolidCamera& camera, QPointF px) {
  return (px.x() - camera.origin_px.x) / camera.px_per_mm * camera.right +
         (camera.origin_px.y - px.y()) / camera.px_per_mm * camera.up;
}

Vec3 on_page_frame(const Vec3& p, Point origin) {
  return {p.x + origin.x, p.y - origin.y, p.z};
}

/// Leaves out points without a distance, and halves the number until an edit can hold them.
std::vector<QPointF> thinned(const std::vector<QPointF>& px) {
  std::vector<QPointF> points;
  for (const QPointF p : px) {
    const bool is_near = !points.empty() && std::hypot(p.x() - points.back().x(),
                                                       p.y() - points.back().y()) < kMinStepPx;
    if (!is_near) points.push_back(p);
  }
  while (points.size() > BodyEdit::kMaxPoints) {
    std::vector<QPointF> half;
    for (std::size_t i = 0; i < points.size(); i += 2) half.push_back(points[i]);
    points = std::move(half);
  }
  return points;
}

}  // namespace

std::vector<Vec3> stroke_over_solid(const SolidCamera& camera, const std::vector<QPointF>& px,
                                    Point origin) {
  std::vector<Vec3> stroke;
  for (const QPointF p : thinned(px)) {
    stroke.push_back(on_page_frame(under_pixel(camera, p), origin));
  }
  return stroke;
}

std::optional<std::vector<Vec3>> profile_over_solid(const SolidCamera& camera,
                                                    const std::vector<QPointF>& px,
                                                    const ExtrusionRing& ring, Point origin) {
  const Vec3 facing = camera.towards - dot(camera.towards, ring.normal) * ring.normal;
  if (norm(facing) < std::sin(kMinProfileDeg * std::numbers::pi / 180.0)) return std::nullopt;
  const Vec3 across = (1.0 / norm(facing)) * facing;
  std::vector<Vec3> profile;
  for (const QPointF p : thinned(px)) {
    const Vec3 at = under_pixel(camera, p);
    const double depth = dot(ring.middle - at, across) / dot(camera.towards, across);
    profile.push_back(on_page_frame(at + depth * camera.towards, origin));
  }
  return profile;
}

}  // namespace felt::desktop
