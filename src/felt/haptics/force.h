#pragma once

#include <cmath>

#include "felt/geometry/vec3.h"

namespace felt {

/// A force on the pen, in N, along the axes of the surface; +z pushes the pen away from the
/// surface.
struct Force {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend constexpr bool operator==(const Force&, const Force&) noexcept = default;
};

constexpr Force operator+(const Force& a, const Force& b) noexcept {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Force operator-(const Force& a, const Force& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Force operator-(const Force& a) noexcept {
  return {-a.x, -a.y, -a.z};
}
constexpr Force operator*(double s, const Force& a) noexcept {
  return {s * a.x, s * a.y, s * a.z};
}
constexpr Force operator*(const Force& a, double s) noexcept {
  return s * a;
}
constexpr Force& operator+=(Force& a, const Force& b) noexcept {
  return a = a + b;
}

/// Returns the scalar product, N^2.
constexpr double dot(const Force& a, const Force& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Returns the magnitude in N.
inline double norm(const Force& a) noexcept {
  return std::sqrt(dot(a, a));
}
/// Returns true if all three components are finite.
inline bool is_finite(const Force& a) noexcept {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
/// Returns the work in mJ of a force over a displacement in mm (N mm = mJ), or its power in mW at a
/// velocity in mm/s.
constexpr double work_mj(const Force& f, const Vec3& d) noexcept {
  return f.x * d.x + f.y * d.y + f.z * d.z;
}

}  // namespace felt
