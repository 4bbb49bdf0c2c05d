#pragma once

#include <array>
#include <utility>

#include "felt/geometry/point.h"
#include "felt/geometry/rect.h"

namespace felt {

/// One cubic Bezier segment, control points B1..B4 of the paper [Paper eq. 1]:
///   f(t) = (1-t)^3 B1 + 3t(1-t)^2 B2 + 3t^2(1-t) B3 + t^3 B4
/// A value; any control points are allowed, coincident ones included. All functions on it are
/// total and noexcept: degenerate input has the documented answer.
struct Cubic {
  std::array<Point, 4> p;

  friend constexpr bool operator==(const Cubic&, const Cubic&) noexcept = default;
};

/// f(t) in Bernstein form [Paper eq. 1]; t outside [0, 1] extrapolates. Exact at 0 and 1.
constexpr Point evaluate(const Cubic& c, double t) noexcept {
  const double s = 1.0 - t;
  const double b1 = s * s * s, b2 = 3.0 * t * s * s, b3 = 3.0 * t * t * s, b4 = t * t * t;
  return {b1 * c.p[0].x + b2 * c.p[1].x + b3 * c.p[2].x + b4 * c.p[3].x,
          b1 * c.p[0].y + b2 * c.p[1].y + b3 * c.p[2].y + b4 * c.p[3].y};
}

/// f'(t), mm per unit of t; zero where the segment stands still.
constexpr Vec derivative(const Cubic& c, double t) noexcept {
  const double s = 1.0 - t;
  return 3.0 *
         (s * s * (c.p[1] - c.p[0]) + 2.0 * s * t * (c.p[2] - c.p[1]) + t * t * (c.p[3] - c.p[2]));
}

/// f''(t).
constexpr Vec second_derivative(const Cubic& c, double t) noexcept {
  return 6.0 * ((1.0 - t) * ((c.p[2] - c.p[1]) - (c.p[1] - c.p[0])) +
                t * ((c.p[3] - c.p[2]) - (c.p[2] - c.p[1])));
}

/// The parts [0, t] and [t, 1] by de Casteljau; they share the split point bit for bit, and their
/// outer ends are those of c. t is taken as given, so t outside [0, 1] extrapolates.
constexpr std::pair<Cubic, Cubic> split(const Cubic& c, double t) noexcept {
  const Point a = lerp(c.p[0], c.p[1], t), b = lerp(c.p[1], c.p[2], t), d = lerp(c.p[2], c.p[3], t);
  const Point ab = lerp(a, b, t), bd = lerp(b, d, t);
  const Point m = lerp(ab, bd, t);
  return {Cubic{{c.p[0], a, ab, m}}, Cubic{{m, bd, d, c.p[3]}}};
}

/// The straight segment from a to b with handles at thirds, so that speed is constant.
constexpr Cubic straight(Point a, Point b) noexcept {
  return Cubic{{a, lerp(a, b, 1.0 / 3.0), lerp(a, b, 2.0 / 3.0), b}};
}

/// The part [t0, t1] as a segment of its own; t0 > t1 gives it backwards. Parts that meet at a
/// parameter share that point bit for bit, and [0, 1] gives c itself. Source: blossoms (Ramshaw).
Cubic sub_segment(const Cubic& c, double t0, double t1) noexcept;

/// The same curve walked from its end: reversed(c)(t) = c(1 - t).
constexpr Cubic reversed(const Cubic& c) noexcept {
  return Cubic{{c.p[3], c.p[2], c.p[1], c.p[0]}};
}

/// True when all eight coordinates are finite.
inline bool is_finite(const Cubic& c) noexcept {
  return is_finite(c.p[0]) && is_finite(c.p[1]) && is_finite(c.p[2]) && is_finite(c.p[3]);
}

/// Smallest rectangle around f([0, 1]), from the roots of x' and y'; exact up to the rounding of
/// `evaluate`. A segment with a coordinate that is not finite has an empty one.
Rect bounds(const Cubic& c) noexcept;

/// Rectangle around the four control points: contains `bounds`, costs a tenth.
constexpr Rect control_bounds(const Cubic& c) noexcept {
  Rect box;
  for (const Point& p : c.p) box.extend(p);
  return box;
}

/// Upper bound in mm of the distance from any point of the curve to its chord, the straight line
/// *segment* p0 p3; 0 exactly when the curve lies on it. Distance to a convex set is convex, so
/// dist f(t) <= b1(t) dist p1 + b2(t) dist p2 <= 3/4 max(dist p1, dist p2); at most 1.7 times too
/// large for curves without inflection.
double flatness(const Cubic& c) noexcept;

/// Unit direction of travel at t in [0, 1]. Where f' is zero (a zero handle, a cusp) it is the
/// limit from inside the segment: at the ends the direction to the next distinct control point,
/// at a cusp the direction in which the curve leaves. (0, 0) when the segment is a point.
Vec tangent(const Cubic& c, double t) noexcept;

/// Signed curvature in 1/mm: cross(f', f'') / |f'|^3, positive when the curve turns from +x to +y.
/// 0 where f' is zero, since no circle is tangent there.
double curvature(const Cubic& c, double t) noexcept;

/// Length of the control polygon in mm: never less than the arc length.
inline double control_length(const Cubic& c) noexcept {
  return distance(c.p[0], c.p[1]) + distance(c.p[1], c.p[2]) + distance(c.p[2], c.p[3]);
}

/// Error in mm allowed to arc lengths when the caller does not say.
inline constexpr double kLengthAccuracyMm = 1e-9;

/// Arc length in mm of the part between t0 and t1 in [0, 1] (in either order), within `accuracy_mm`
/// or 1e-14 of the control polygon, whichever is larger. Adaptive Gauss-Kronrod (7, 15) on an
/// explicit stack, at most 256 pieces; pieces near a cusp are cut until they are negligible, since
/// error estimates mean nothing there. NaN when a coordinate is not finite.
double arc_length(const Cubic& c, double t0, double t1,
                  double accuracy_mm = kLengthAccuracyMm) noexcept;

/// Arc length in mm of the whole segment.
inline double arc_length(const Cubic& c, double accuracy_mm = kLengthAccuracyMm) noexcept {
  return arc_length(c, 0.0, 1.0, accuracy_mm);
}

/// The t in [0, 1] at which the arc from 0 is `length_mm` long, so that the length found there is
/// right within `accuracy_mm`. 0 for lengths up to 0, 1 from the whole length on and for NaN.
double parameter_at_length(const Cubic& c, double length_mm,
                           double accuracy_mm = kLengthAccuracyMm) noexcept;

}  // namespace felt
