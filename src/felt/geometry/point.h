#pragma once

#include <cmath>

namespace felt {

/// A displacement in the page plane, in mm. x right, y down (README of this layer).
struct Vec {
  double x = 0.0;
  double y = 0.0;

  friend constexpr bool operator==(Vec, Vec) noexcept = default;
};

constexpr Vec operator+(Vec a, Vec b) noexcept {
  return {a.x + b.x, a.y + b.y};
}
constexpr Vec operator-(Vec a, Vec b) noexcept {
  return {a.x - b.x, a.y - b.y};
}
constexpr Vec operator-(Vec a) noexcept {
  return {-a.x, -a.y};
}
constexpr Vec operator*(double s, Vec a) noexcept {
  return {s * a.x, s * a.y};
}
constexpr Vec operator*(Vec a, double s) noexcept {
  return {s * a.x, s * a.y};
}
constexpr Vec operator/(Vec a, double s) noexcept {
  return {a.x / s, a.y / s};
}
constexpr Vec& operator+=(Vec& a, Vec b) noexcept {
  return a = a + b;
}
constexpr Vec& operator-=(Vec& a, Vec b) noexcept {
  return a = a - b;
}

/// Returns the scalar product.
constexpr double dot(Vec a, Vec b) noexcept {
  return a.x * b.x + a.y * b.y;
}

/// Returns z of the cross product; positive if b is clockwise of a as the user sees it (y is down).
constexpr double cross(Vec a, Vec b) noexcept {
  return a.x * b.y - a.y * b.x;
}

/// Returns the squared length.
constexpr double norm_squared(Vec a) noexcept {
  return dot(a, a);
}

/// Returns the length.
inline double norm(Vec a) noexcept {
  return std::sqrt(norm_squared(a));
}

/// Returns `a` rotated by a quarter turn from +x to +y.
constexpr Vec perp(Vec a) noexcept {
  return {-a.y, a.x};
}

/// Returns the unit vector along `a`, or (0, 0) if `a` is shorter than 1e-150 or not finite.
inline Vec normalized(Vec a) noexcept {
  const double length = norm(a);
  return length > 1e-150 && std::isfinite(length) ? a / length : Vec{};
}

/// Returns the unsigned angle between a and b in radians, 0..pi; 0 if either is zero.
inline double angle_between(Vec a, Vec b) noexcept {
  return std::atan2(std::fabs(cross(a, b)), dot(a, b));
}

/// A position on the page, in mm from its top left corner; x right, y down.
struct Point {
  double x = 0.0;
  double y = 0.0;

  friend constexpr bool operator==(Point, Point) noexcept = default;
};

/// The largest absolute value of a coordinate that is accepted anywhere: 1,000 km. Doubles still
/// resolve 1.2e-7 mm there.
inline constexpr double kMaxCoordinateMm = 1e9;

/// Returns true if both coordinates are numbers with an absolute value of at most kMaxCoordinateMm.
inline bool is_in_range(Point p) noexcept {
  return std::fabs(p.x) <= kMaxCoordinateMm && std::fabs(p.y) <= kMaxCoordinateMm;
}

constexpr Vec operator-(Point a, Point b) noexcept {
  return {a.x - b.x, a.y - b.y};
}
constexpr Point operator+(Point p, Vec v) noexcept {
  return {p.x + v.x, p.y + v.y};
}
constexpr Point operator-(Point p, Vec v) noexcept {
  return {p.x - v.x, p.y - v.y};
}
constexpr Point& operator+=(Point& p, Vec v) noexcept {
  return p = p + v;
}
constexpr Point& operator-=(Point& p, Vec v) noexcept {
  return p = p - v;
}

/// Interpolates linearly: a at t = 0, b at t = 1 (exact at both ends).
constexpr Point lerp(Point a, Point b, double t) noexcept {
  return {(1.0 - t) * a.x + t * b.x, (1.0 - t) * a.y + t * b.y};
}

/// Returns the distance in mm.
inline double distance(Point a, Point b) noexcept {
  return norm(b - a);
}

/// Returns the squared distance in mm^2.
constexpr double distance_squared(Point a, Point b) noexcept {
  return norm_squared(b - a);
}

/// Returns true if both coordinates are finite.
inline bool is_finite(Point p) noexcept {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

}  // namespace felt
