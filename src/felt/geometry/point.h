#pragma once

#include <cmath>

#include "felt/geometry/vec.h"

namespace felt {

/// A place on the sheet, in mm from its top left corner; x right, y down.
struct Point {
  double x = 0.0;
  double y = 0.0;

  friend constexpr bool operator==(Point, Point) noexcept = default;
};

/// The largest magnitude of a coordinate that is accepted anywhere: 1,000 km. Doubles still
/// resolve 1e-7 mm there.
inline constexpr double kMaxCoordinateMm = 1e9;

/// Returns true if both coordinates are numbers of at most kMaxCoordinateMm.
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

/// Linear interpolation: a at t = 0, b at t = 1 (exact at both ends).
constexpr Point lerp(Point a, Point b, double t) noexcept {
  return {(1.0 - t) * a.x + t * b.x, (1.0 - t) * a.y + t * b.y};
}

/// Distance in mm.
inline double distance(Point a, Point b) noexcept {
  return norm(b - a);
}

/// Squared distance in mm^2.
constexpr double distance_squared(Point a, Point b) noexcept {
  return norm_squared(b - a);
}

/// True when both coordinates are finite.
inline bool is_finite(Point p) noexcept {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

}  // namespace felt
