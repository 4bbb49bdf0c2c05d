#include "felt/geometry/cubic.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/geometry/polyline.h"
#include "felt/geometry/roots.h"

namespace felt {
namespace {

// The blossom of c at (r, s, t): de Casteljau with a different parameter at each step. Symmetric in
// exact arithmetic; callers keep the order so that shared points are equal bit for bit.
Point blossom(const Cubic& c, double r, double s, double t) noexcept {
  const Point a = lerp(c.p[0], c.p[1], r), b = lerp(c.p[1], c.p[2], r), d = lerp(c.p[2], c.p[3], r);
  return lerp(lerp(a, b, s), lerp(b, d, s), t);
}

}  // namespace

Cubic sub_segment(const Cubic& c, double t0, double t1) noexcept {
  return Cubic{{blossom(c, t0, t0, t0), blossom(c, t0, t0, t1), blossom(c, t0, t1, t1),
                blossom(c, t1, t1, t1)}};
}

Rect bounds(const Cubic& c) noexcept {
  Rect box;
  if (!is_finite(c)) return box;
  box.extend(c.p[0]);
  box.extend(c.p[3]);
  // The curve can leave the box of its ends only if an inner control point is outside.
  if (box.contains(c.p[1]) && box.contains(c.p[2])) return box;
  const Vec d0 = c.p[1] - c.p[0], d1 = c.p[2] - c.p[1], d2 = c.p[3] - c.p[2];
  const Vec linear = 2.0 * (d1 - d0), square = (d2 - d1) - (d1 - d0);
  for (const double t : quadratic_roots(d0.x, linear.x, square.x)) {
    const double x = evaluate(c, t).x;
    box.x0 = std::min(box.x0, x);
    box.x1 = std::max(box.x1, x);
  }
  for (const double t : quadratic_roots(d0.y, linear.y, square.y)) {
    const double y = evaluate(c, t).y;
    box.y0 = std::min(box.y0, y);
    box.y1 = std::max(box.y1, y);
  }
  return box;
}

double flatness(const Cubic& c) noexcept {
  const double d1 = nearest_on_line(c.p[0], c.p[3], c.p[1]).distance_squared;
  const double d2 = nearest_on_line(c.p[0], c.p[3], c.p[2]).distance_squared;
  return 0.75 * std::sqrt(std::max(d1, d2));
}

Vec tangent(const Cubic& c, double t) noexcept {
  const double side = t < 1.0 ? 1.0 : -1.0;  // the limit from inside
  const Vec first = t <= 0.0 ? c.p[1] - c.p[0] : t >= 1.0 ? c.p[3] - c.p[2] : derivative(c, t);
  // Inside the segment, f' is a sum, and its rounding noise must not be mistaken for a direction.
  // The end handles are differences of given numbers: any handle that is not zero has a direction.
  const double noise = t > 0.0 && t < 1.0 ? 1e-14 * control_length(c) : 0.0;
  if (norm(first) > noise) return normalized(first);
  const Vec second = side * (t <= 0.0   ? c.p[2] - c.p[1]
                             : t >= 1.0 ? c.p[1] - c.p[2]
                                        : second_derivative(c, t));
  if (norm(second) > noise) return normalized(second);
  return normalized(c.p[3] - c.p[0]);
}

double curvature(const Cubic& c, double t) noexcept {
  const Vec first = derivative(c, t);
  const double speed = norm(first);
  if (!(speed > 0.0)) return 0.0;
  const Vec direction = first / speed;
  return cross(direction, second_derivative(c, t)) / (speed * speed);
}

}  // namespace felt
