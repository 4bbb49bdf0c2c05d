#pragma once

#include <cmath>
#include <optional>

#include "felt/geometry/cubic.h"

namespace felt {

/// An affine map of the page, in the order of SVG's matrix(a b c d e f):
///   x' = a x + c y + e,   y' = b x + d y + f      (e and f in mm)
/// A cubic maps exactly by mapping its control points.
struct Affine {
  double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;

  friend constexpr bool operator==(const Affine&, const Affine&) noexcept = default;
};

/// Returns the image of a point.
constexpr Point apply(const Affine& m, Point p) noexcept {
  return {m.a * p.x + m.c * p.y + m.e, m.b * p.x + m.d * p.y + m.f};
}

/// Returns the image of a displacement. Only the linear part of the map is used.
constexpr Vec apply(const Affine& m, Vec v) noexcept {
  return {m.a * v.x + m.c * v.y, m.b * v.x + m.d * v.y};
}

/// Returns the image of a segment.
constexpr Cubic apply(const Affine& m, const Cubic& c) noexcept {
  return Cubic{{apply(m, c.p[0]), apply(m, c.p[1]), apply(m, c.p[2]), apply(m, c.p[3])}};
}

/// Returns the map that applies `first` and then `second`:
/// apply(then(first, second), p) == apply(second, apply(first, p)).
constexpr Affine then(const Affine& first, const Affine& second) noexcept {
  const Vec x = apply(second, Vec{first.a, first.b}), y = apply(second, Vec{first.c, first.d});
  const Point origin = apply(second, Point{first.e, first.f});
  return {x.x, x.y, y.x, y.y, origin.x, origin.y};
}

/// Returns the translation by v.
constexpr Affine translation(Vec v) noexcept {
  return {1.0, 0.0, 0.0, 1.0, v.x, v.y};
}

/// Returns the map with the linear part (a b c d) that leaves `centre` fixed.
constexpr Affine about(Point centre, double a, double b, double c, double d) noexcept {
  return {a,
          b,
          c,
          d,
          centre.x - (a * centre.x + c * centre.y),
          centre.y - (b * centre.x + d * centre.y)};
}

/// Returns the rotation about `centre` by `angle_rad`; a positive angle turns +x to +y.
inline Affine rotation(double angle_rad, Point centre = {}) noexcept {
  const double cosine = std::cos(angle_rad), sine = std::sin(angle_rad);
  return about(centre, cosine, sine, -sine, cosine);
}

/// Returns the map that scales each axis by its own factor about `centre`; a negative factor
/// mirrors.
constexpr Affine scaling(double factor_x, double factor_y, Point centre = {}) noexcept {
  return about(centre, factor_x, 0.0, 0.0, factor_y);
}

/// Returns the map that scales both axes by the same factor about `centre`.
constexpr Affine scaling(double factor, Point centre = {}) noexcept {
  return scaling(factor, factor, centre);
}

/// Returns the factor by which areas grow; negative if the map mirrors.
constexpr double determinant(const Affine& m) noexcept {
  return m.a * m.d - m.b * m.c;
}

/// Returns the inverse map, or nullopt if m is not finite, or singular up to rounding:
/// |det| <= 1e-14 (|a d| + |b c|).
constexpr std::optional<Affine> inverse(const Affine& m) noexcept {
  const double ad = m.a * m.d, bc = m.b * m.c, det = ad - bc;
  const double size = (ad < 0.0 ? -ad : ad) + (bc < 0.0 ? -bc : bc);
  if (!((det < 0.0 ? -det : det) > 1e-14 * size)) return std::nullopt;
  const Affine linear{m.d / det, -m.b / det, -m.c / det, m.a / det, 0.0, 0.0};
  const Vec back = apply(linear, Vec{m.e, m.f});
  const Affine result{linear.a, linear.b, linear.c, linear.d, -back.x, -back.y};
  const double sum = result.a + result.b + result.c + result.d + result.e + result.f;
  if (!(sum - sum == 0.0)) return std::nullopt;
  return result;
}

}  // namespace felt
