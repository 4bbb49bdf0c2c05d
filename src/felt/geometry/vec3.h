#pragma once

#include <cmath>

#include "felt/geometry/point.h"

namespace felt {

/// A position or a displacement above the page: x right, y down, z away from the page towards the
/// hand. In mm, or in mm/s for a velocity; the context says which.
struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend constexpr bool operator==(const Vec3&, const Vec3&) noexcept = default;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) noexcept {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator-(const Vec3& a) noexcept {
  return {-a.x, -a.y, -a.z};
}
constexpr Vec3 operator*(double s, const Vec3& a) noexcept {
  return {s * a.x, s * a.y, s * a.z};
}
constexpr Vec3 operator*(const Vec3& a, double s) noexcept {
  return s * a;
}
constexpr Vec3& operator+=(Vec3& a, const Vec3& b) noexcept {
  return a = a + b;
}
constexpr Vec3& operator-=(Vec3& a, const Vec3& b) noexcept {
  return a = a - b;
}

/// Returns the scalar product.
constexpr double dot(const Vec3& a, const Vec3& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Returns the squared length.
constexpr double norm_squared(const Vec3& a) noexcept {
  return dot(a, a);
}
/// Returns the length.
inline double norm(const Vec3& a) noexcept {
  return std::sqrt(norm_squared(a));
}
/// Returns the point of the page straight below `a`.
constexpr Point on_page(const Vec3& a) noexcept {
  return {a.x, a.y};
}
/// Returns the component in the plane of the page.
constexpr Vec in_plane(const Vec3& a) noexcept {
  return {a.x, a.y};
}
/// Interpolates linearly: a at t = 0, b at t = 1 (exact at both ends).
constexpr Vec3 lerp(const Vec3& a, const Vec3& b, double t) noexcept {
  return (1.0 - t) * a + t * b;
}
/// Returns true if all three coordinates are finite.
inline bool is_finite(const Vec3& a) noexcept {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace felt
