#include "felt/fill/curve_area.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace felt {
namespace {

constexpr int kMaxHalvings = 48;

/// Returns true if halves of a part with this hull are not smaller, because of rounding. Otherwise
/// both would be halved again and again around a point in them.
bool is_dot(const Rect& hull) noexcept {
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  const double tiny = kRounding * std::max({std::fabs(hull.x0), std::fabs(hull.x1),
                                            std::fabs(hull.y0), std::fabs(hull.y1)});
  return hull.x1 - hull.x0 <= tiny && hull.y1 - hull.y0 <= tiny;
}

int parity_of_part(const Cubic& c, Point p, int halvings) noexcept {
  const Rect hull = control_bounds(c);
  if (hull.y1 < p.y || hull.y0 > p.y || hull.x1 < p.x) return 0;
  const bool ends_differ = (c.p[0].y <= p.y) != (c.p[3].y <= p.y);
  if (hull.x0 > p.x || halvings == 0 || is_dot(hull)) return ends_differ ? 1 : 0;
  const auto [left, right] = split(c, 0.5);
  return parity_of_part(left, p, halvings - 1) ^ parity_of_part(right, p, halvings - 1);
}

}  // namespace

double area_under(const Cubic& c, Point origin) noexcept {
  const Vec a = c.p[0] - origin, b = c.p[1] - origin, d = c.p[2] - origin, e = c.p[3] - origin;
  return (6.0 * cross(a, b) + 3.0 * cross(a, d) + cross(a, e) + 3.0 * cross(b, d) +
          3.0 * cross(b, e) + 6.0 * cross(d, e)) /
         20.0;
}

double loop_area(std::span<const Cubic> loop) noexcept {
  double area = 0.0;
  for (const Cubic& c : loop) area += area_under(c, loop.front().p[0]);
  return area;
}

int ray_parity(const Cubic& c, Point p) noexcept {
  return parity_of_part(c, p, kMaxHalvings);
}

bool is_inside(std::span<const Point> loop, Point p) noexcept {
  int parity = 0;
  for (std::size_t i = 0; i + 3 < loop.size(); i += 3) {
    parity ^= ray_parity(Cubic{{loop[i], loop[i + 1], loop[i + 2], loop[i + 3]}}, p);
  }
  return parity != 0;
}

}  // namespace felt
