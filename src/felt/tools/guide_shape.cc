#include "felt/tools/guide_shape.h"

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"

namespace felt {
namespace {

Vec turned(Vec v, double angle_rad) noexcept {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// Returns the root of Eberly's function for an ellipse with the squared ratio of axes `r`.
double ellipse_root(double r, double z0, double z1, double g) noexcept {
  const double n0 = r * z0;
  double low = z1 - 1.0, high = g < 0.0 ? 0.0 : std::sqrt(n0 * n0 + z1 * z1) - 1.0;
  double s = 0.0;
  for (int i = 0; i < 100; ++i) {
    s = 0.5 * (low + high);
    if (s == low || s == high) break;
    const double a = n0 / (s + r), b = z1 / (s + 1.0);
    const double now = a * a + b * b - 1.0;
    if (now == 0.0) break;
    (now > 0.0 ? low : high) = s;
  }
  return s;
}

/// Returns the point of the ellipse with the semi-axes e0 >= e1 > 0 that is nearest to a point of
/// the first quadrant.
Vec nearest_in_quadrant(double e0, double e1, Vec p) noexcept {
  if (p.y > 0.0) {
    if (!(p.x > 0.0)) return {0.0, e1};
    const double z0 = p.x / e0, z1 = p.y / e1;
    const double g = z0 * z0 + z1 * z1 - 1.0;
    if (g == 0.0) return p;
    const double r = (e0 / e1) * (e0 / e1);
    const double s = ellipse_root(r, z0, z1, g);
    return {r * p.x / (s + r), p.y / (s + 1.0)};
  }
  const double wide = e0 * e0 - e1 * e1;
  if (e0 * p.x < wide) {
    const double x = e0 * p.x / wide;
    return {e0 * x, e1 * std::sqrt(std::max(0.0, 1.0 - x * x))};
  }
  return {e0, 0.0};
}

/// Returns the parameter of the nearest point.
double nearest_parameter(const GuideEllipse& e, Point p) noexcept {
  const Vec local = turned(p - e.centre, -e.angle_rad);
  const Vec first{std::fabs(local.x), std::fabs(local.y)};
  const bool is_wide = e.a_mm >= e.b_mm;
  Vec q = is_wide ? nearest_in_quadrant(e.a_mm, e.b_mm, first)
                  : nearest_in_quadrant(e.b_mm, e.a_mm, {first.y, first.x});
  if (!is_wide) q = {q.y, q.x};
  return std::atan2(std::copysign(q.y, local.y) / e.b_mm, std::copysign(q.x, local.x) / e.a_mm);
}

Point point_of(const GuideStraight& line, double at) noexcept {
  return line.at + at * line.along;
}
Point point_of(const GuideEllipse& e, double at) noexcept {
  return e.centre + turned({e.a_mm * std::cos(at), e.b_mm * std::sin(at)}, e.angle_rad);
}
Vec direction_of(const GuideStraight& line, double /*at*/) noexcept {
  return line.along;
}
Vec direction_of(const GuideEllipse& e, double at) noexcept {
  return normalized(turned({-e.a_mm * std::sin(at), e.b_mm * std::cos(at)}, e.angle_rad));
}
double position_of(const GuideStraight& line, Point p) noexcept {
  return dot(p - line.at, line.along);
}
double position_of(const GuideEllipse& e, Point p) noexcept {
  return nearest_parameter(e, p);
}

std::vector<Point> points_of(const GuideStraight& line, Point near) {
  const double at = position_of(line, near);
  const double from = std::max(line.from_mm, at - GuideStraight::kEndlessMm);
  const double to = std::min(line.to_mm, at + GuideStraight::kEndlessMm);
  return {point_of(line, from), point_of(line, std::max(from, to))};
}
std::vector<Point> points_of(const GuideEllipse& e, Point /*near*/) {
  constexpr double kStepMm = 0.4;
  const double count = std::clamp(std::ceil(ellipse_mm(e) / kStepMm), 32.0, 8000.0);
  std::vector<Point> points;
  for (double i = 0.0; i < count; ++i) points.push_back(point_of(e, kTau * i / count));
  return points;
}

}  // namespace

Vec direction_of(double angle_rad) noexcept {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

Point point_at(const GuideShape& shape, double at) noexcept {
  return std::visit([at](const auto& s) { return point_of(s, at); }, shape);
}

Vec direction_at(const GuideShape& shape, double at) noexcept {
  return std::visit([at](const auto& s) { return direction_of(s, at); }, shape);
}

ShapeNearest nearest_on(const GuideShape& shape, Point p) noexcept {
  ShapeNearest near;
  near.at = std::visit([p](const auto& s) { return position_of(s, p); }, shape);
  near.point = point_at(shape, near.at);
  near.along = direction_at(shape, near.at);
  const Vec off = p - near.point;
  near.distance_mm = std::copysign(norm(off), dot(off, perp(near.along)));
  return near;
}

double ellipse_mm(const GuideEllipse& e) noexcept {
  const double sum = e.a_mm + e.b_mm, difference = e.a_mm - e.b_mm;
  const double h = sum > 0.0 ? (difference / sum) * (difference / sum) : 0.0;
  return 0.5 * kTau * sum * (1.0 + 3.0 * h / (10.0 + std::sqrt(4.0 - 3.0 * h)));
}

std::vector<Point> guide_points(const GuideShape& shape, Point near) {
  return std::visit([near](const auto& s) { return points_of(s, near); }, shape);
}

}  // namespace felt
