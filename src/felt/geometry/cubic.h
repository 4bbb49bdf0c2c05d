#pragma once

#include <array>
#include <utility>

#include "felt/geometry/point.h"
#include "felt/geometry/rect.h"

namespace felt {

/// One cubic Bezier segment, control points B1..B4 of the paper [Paper eq. 1]:
///   f(t) = (1-t)^3 B1 + 3t(1-t)^2 B2 + 3t^2(1-t) B3 + t^3 B4
/// A value type. Any control points are allowed, including coincident ones. All functions on it
/// accept any input and are noexcept; their comments say what they return for degenerate input.
struct Cubic {
  std::array<Point, 4> p;

  friend constexpr bool operator==(const Cubic&, const Cubic&) noexcept = default;
};

/// Returns f(t), computed in Bernstein form [Paper eq. 1]. t outside [0, 1] extrapolates. Exact at
/// 0 and 1.
constexpr Point evaluate(const Cubic& c, double t) noexcept {
  const double s = 1.0 - t;
  const double b1 = s * s * s, b2 = 3.0 * t * s * s, b3 = 3.0 * t * t * s, b4 = t * t * t;
  return {b1 * c.p[0].x + b2 * c.p[1].x + b3 * c.p[2].x + b4 * c.p[3].x,
          b1 * c.p[0].y + b2 * c.p[1].y + b3 * c.p[2].y + b4 * c.p[3].y};
}

/// Returns f'(t) in mm per unit of t.
constexpr Vec derivative(const Cubic& c, double t) noexcept {
  const double s = 1.0 - t;
  return 3.0 *
         (s * s * (c.p[1] - c.p[0]) + 2.0 * s * t * (c.p[2] - c.p[1]) + t * t * (c.p[3] - c.p[2]));
}

/// Returns f''(t) in mm per squared unit of t.
constexpr Vec second_derivative(const Cubic& c, double t) noexcept {
  return 6.0 * ((1.0 - t) * ((c.p[2] - c.p[1]) - (c.p[1] - c.p[0])) +
                t * ((c.p[3] - c.p[2]) - (c.p[2] - c.p[1])));
}

/// Returns the parts [0, t] and [t, 1], computed by de Casteljau's algorithm. They share the split
/// point bit for bit, and their outer ends are the ends of c. t is not clamped: outside [0, 1] it
/// extrapolates.
constexpr std::pair<Cubic, Cubic> split(const Cubic& c, double t) noexcept {
  const Point a = lerp(c.p[0], c.p[1], t), b = lerp(c.p[1], c.p[2], t), d = lerp(c.p[2], c.p[3], t);
  const Point ab = lerp(a, b, t), bd = lerp(b, d, t);
  const Point m = lerp(ab, bd, t);
  return {Cubic{{c.p[0], a, ab, m}}, Cubic{{m, bd, d, c.p[3]}}};
}

/// Returns the straight segment from a to b with handles at thirds, so that its speed is constant.
constexpr Cubic straight(Point a, Point b) noexcept {
  return Cubic{{a, lerp(a, b, 1.0 / 3.0), lerp(a, b, 2.0 / 3.0), b}};
}

/// Returns the part [t0, t1] as a segment, reversed if t0 > t1. Two parts that end at the same
/// parameter have exactly the same end point there, and [0, 1] gives c itself. Source: blossoms
/// (Ramshaw).
Cubic sub_segment(const Cubic& c, double t0, double t1) noexcept;

/// Returns the same curve in the opposite direction: reversed(c)(t) = c(1 - t).
constexpr Cubic reversed(const Cubic& c) noexcept {
  return Cubic{{c.p[3], c.p[2], c.p[1], c.p[0]}};
}

/// Returns true if all eight coordinates are finite.
inline bool is_finite(const Cubic& c) noexcept {
  return is_finite(c.p[0]) && is_finite(c.p[1]) && is_finite(c.p[2]) && is_finite(c.p[3]);
}

/// Returns the smallest rectangle around f([0, 1]), from the roots of x' and y'; exact up to the
/// rounding of `evaluate`. Empty if a coordinate is not finite.
Rect bounds(const Cubic& c) noexcept;

/// Returns the rectangle around the four control points. It contains `bounds(c)` and is computed in
/// a tenth of the time.
constexpr Rect control_bounds(const Cubic& c) noexcept {
  Rect box;
  for (const Point& p : c.p) box.extend(p);
  return box;
}

/// Returns an upper bound in mm of the distance from any point of the curve to its chord, the
/// straight line *segment* p0 p3. The bound is 0 if and only if the curve lies on the chord.
/// With the Bernstein polynomials b1 and b2, dist f(t) <= b1(t) dist p1 + b2(t) dist p2 <= 3/4
/// max(dist p1, dist p2), because the distance to a convex set is a convex function. For curves
/// without inflection, the bound is at most 1.7 times too large.
double flatness(const Cubic& c) noexcept;

/// Returns the unit direction of travel at t in [0, 1]. If f' is zero there (a zero handle, a
/// cusp), returns the limit from inside the segment. At an end, this is the direction of the line
/// between the end and the next distinct control point; at a cusp, it is the direction in which the
/// curve leaves. Returns (0, 0) if the segment is a point.
Vec tangent(const Cubic& c, double t) noexcept;

/// Returns the signed curvature in 1/mm: cross(f', f'') / |f'|^3, positive if the curve turns from
/// +x to +y. Returns 0 if f' is zero, because no circle is tangent there.
double curvature(const Cubic& c, double t) noexcept;

/// Returns the length of the control polygon in mm, which is never less than the arc length.
inline double control_length(const Cubic& c) noexcept {
  return distance(c.p[0], c.p[1]) + distance(c.p[1], c.p[2]) + distance(c.p[2], c.p[3]);
}

/// The default accuracy of arc lengths, mm.
inline constexpr double kLengthAccuracyMm = 1e-9;

/// Returns the arc length in mm of the part between t0 and t1 in [0, 1] (in either order), within
/// `accuracy_mm` or 1e-14 of the length of the control polygon, whichever is larger. Uses adaptive
/// Gauss-Kronrod quadrature (7, 15) on at most 256 pieces, with an explicit stack; pieces near a
/// cusp are halved until they are negligible, because error estimates are unreliable there. Returns
/// NaN if a coordinate is not finite.
double arc_length(const Cubic& c, double t0, double t1,
                  double accuracy_mm = kLengthAccuracyMm) noexcept;

/// Returns the arc length in mm of the whole segment.
inline double arc_length(const Cubic& c, double accuracy_mm = kLengthAccuracyMm) noexcept {
  return arc_length(c, 0.0, 1.0, accuracy_mm);
}

/// Returns the t in [0, 1] at which the arc from 0 to t is `length_mm` long, within `accuracy_mm`.
/// Returns 0 if the length is 0 or less; returns 1 if it is the whole length or more, or NaN.
double parameter_at_length(const Cubic& c, double length_mm,
                           double accuracy_mm = kLengthAccuracyMm) noexcept;

}  // namespace felt
