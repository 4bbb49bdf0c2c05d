#pragma once

#include <cmath>

namespace felt {

/// A displacement in the sheet plane, in mm. x right, y down (README of this layer).
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

/// Scalar product.
constexpr double dot(Vec a, Vec b) noexcept {
  return a.x * b.x + a.y * b.y;
}

/// z of the cross product; positive when b lies clockwise of a as the user sees it (y is down).
constexpr double cross(Vec a, Vec b) noexcept {
  return a.x * b.y - a.y * b.x;
}

/// Squared length.
constexpr double norm_squared(Vec a) noexcept {
  return dot(a, a);
}

/// Length.
inline double norm(Vec a) noexcept {
  return std::sqrt(norm_squared(a));
}

/// a turned by a quarter from +x to +y.
constexpr Vec perp(Vec a) noexcept {
  return {-a.y, a.x};
}

/// Unit vector along a, or (0, 0) when a is shorter than 1e-150 or not finite.
inline Vec normalized(Vec a) noexcept {
  const double length = norm(a);
  return length > 1e-150 && std::isfinite(length) ? a / length : Vec{};
}

/// Unsigned angle between a and b in radians, 0..pi; 0 when either is zero.
inline double angle_between(Vec a, Vec b) noexcept {
  return std::atan2(std::fabs(cross(a, b)), dot(a, b));
}

}  // namespace felt
