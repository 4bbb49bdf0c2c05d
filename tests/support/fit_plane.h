#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

/// Plane geometry of the fit checker. It does not use felt/geometry, because a mistake there would
/// then be in the checker too and stay hidden. No code in this namespace includes a felt header.
namespace fit_check {

/// A point or a displacement, in mm.
struct Point {
  double x = 0.0;
  double y = 0.0;

  friend bool operator==(const Point&, const Point&) = default;
};

inline Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y};
}
inline Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
inline Point operator*(double s, Point a) {
  return {s * a.x, s * a.y};
}
inline double dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y;
}
inline double cross(Point a, Point b) {
  return a.x * b.y - a.y * b.x;
}
inline double length(Point a) {
  return std::sqrt(dot(a, a));
}
inline bool is_finite(Point a) {
  return std::isfinite(a.x) && std::isfinite(a.y);
}

/// Returns the unsigned angle between two directions, 0..180 degrees; 0 if either is zero.
inline double turn_deg(Point a, Point b) {
  return std::atan2(std::fabs(cross(a, b)), dot(a, b)) * 180.0 / std::numbers::pi;
}

/// The control points of one cubic Bezier segment.
using Segment = std::array<Point, 4>;

/// Returns the point of the segment at t, computed with de Casteljau's algorithm.
inline Point at(const Segment& b, double t) {
  const double s = 1.0 - t;
  const Point b01 = s * b[0] + t * b[1], b12 = s * b[1] + t * b[2], b23 = s * b[2] + t * b[3];
  const Point left = s * b01 + t * b12, right = s * b12 + t * b23;
  return s * left + t * right;
}

/// Returns the position of the point nearest to p on the straight line from a (0) to b (1), or 0 if
/// a = b.
inline double nearest_on_line(Point a, Point b, Point p) {
  const Point d = b - a;
  const double dd = dot(d, d);
  return dd > 0.0 ? std::clamp(dot(p - a, d) / dd, 0.0, 1.0) : 0.0;
}

/// Returns the distance from p to the straight line from a to b.
inline double distance_to_line(Point a, Point b, Point p) {
  return length(a + nearest_on_line(a, b, p) * (b - a) - p);
}

}  // namespace fit_check
