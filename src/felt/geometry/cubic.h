#pragma once

#include <array>
#include <utility>

#include "felt/geometry/point.h"

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
  return 3.0 * (s * s * (c.p[1] - c.p[0]) + 2.0 * s * t * (c.p[2] - c.p[1]) +
                t * t * (c.p[3] - c.p[2]));
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

}  // namespace felt
