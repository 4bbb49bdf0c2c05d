#include "felt/geometry/testing/nearest_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace felt {
namespace {

Point random_point(std::mt19937_64& random, double extent) {
  const double x = uniform(random, 0.0, extent);
  return {x, uniform(random, 0.0, extent)};
}

Cubic random_cubic(std::mt19937_64& random) {
  Cubic c;
  for (Point& p : c.p) p = random_point(random, 100.0);
  return c;
}

Cubic near_line(std::mt19937_64& random, double lo, double hi, double off) {
  Cubic c = random_cubic(random);
  const Vec along = c.p[3] - c.p[0];
  for (unsigned i = 1; i < 3; ++i) {
    c.p[i] = c.p[0] + uniform(random, lo, hi) * along + uniform(random, -off, off) * perp(along);
  }
  return c;
}

// p0, p3 and the cusp at t = 1/2: p1 and p2 follow from f'(1/2) = 0 up to one free vector.
Cubic cusp(std::mt19937_64& random) {
  Cubic c = random_cubic(random);
  // f'(1/2) = 3/4 (p3 + p2 - p1 - p0) = 0
  c.p[2] = c.p[1] + (c.p[0] - c.p[3]);
  if (random() % 4 != 0) c.p[2] += Vec{uniform(random, -1e-3, 1e-3), uniform(random, -1e-3, 1e-3)};
  return c;
}

Cubic loop(std::mt19937_64& random) {
  Cubic c = random_cubic(random);
  const Vec along = c.p[3] - c.p[0];
  const double high = uniform(random, 0.3, 2.0);
  c.p[1] = c.p[3] + uniform(random, 0.2, 2.0) * along + high * perp(along);
  c.p[2] = c.p[0] - uniform(random, 0.2, 2.0) * along + high * perp(along);
  return c;
}

Cubic doubled_ends(std::mt19937_64& random) {
  Cubic c = random_cubic(random);
  const auto which = random() % 3;
  if (which != 1) c.p[1] = c.p[0];
  if (which != 0) c.p[2] = c.p[3];
  return c;
}

Cubic arc(std::mt19937_64& random, Point centre) {
  const double angle = uniform(random, 5.0, 120.0) * std::numbers::pi / 180.0;
  const double start = uniform(random, 0.0, 2.0 * std::numbers::pi);
  const double radius = uniform(random, 1.0, 100.0);
  const double handle = 4.0 / 3.0 * std::tan(0.25 * angle);
  const Vec a{radius * std::cos(start), radius * std::sin(start)};
  const Vec b{radius * std::cos(start + angle), radius * std::sin(start + angle)};
  return Cubic{
      {centre + a, centre + a + handle * perp(a), centre + b - handle * perp(b), centre + b}};
}

Cubic tiny(std::mt19937_64& random) {
  Cubic c = random_cubic(random);
  for (Point& p : c.p) p = Point{1e4, 1e4} + 1e-8 * (p - Point{});
  return c;
}

Cubic make_cubic(CaseKind kind, std::mt19937_64& random) {
  switch (kind) {
    case CaseKind::kRandom:
      return random_cubic(random);
    case CaseKind::kNearLine:
      return near_line(random, 0.0, 1.0, 1e-3);
    case CaseKind::kOvershoot:
      return near_line(random, -3.0, 3.0, 0.0);
    case CaseKind::kPoint: {
      const Point p = random_point(random, 100.0);
      return Cubic{{p, p, p, p}};
    }
    case CaseKind::kCusp:
      return cusp(random);
    case CaseKind::kLoop:
      return loop(random);
    case CaseKind::kDoubledEnds:
      return doubled_ends(random);
    case CaseKind::kArc:
      return arc(random, random_point(random, 100.0));
    case CaseKind::kTiny:
      return tiny(random);
  }
  return {};
}

double golden_section(const Cubic& c, Point q, double lo, double hi) {
  constexpr double kGolden = 0.61803398874989484820;
  double a = hi - kGolden * (hi - lo), b = lo + kGolden * (hi - lo);
  double at_a = distance_squared(evaluate(c, a), q), at_b = distance_squared(evaluate(c, b), q);
  for (int i = 0; i < 60; ++i) {
    if (at_a < at_b) {
      hi = b, b = a, at_b = at_a, a = hi - kGolden * (hi - lo);
      at_a = distance_squared(evaluate(c, a), q);
    } else {
      lo = a, a = b, at_a = at_b, b = lo + kGolden * (hi - lo);
      at_b = distance_squared(evaluate(c, b), q);
    }
  }
  return std::min(at_a, at_b);
}

}  // namespace

double uniform(std::mt19937_64& random, double lo, double hi) {
  return lo + (hi - lo) * (static_cast<double>(random() >> 11U) * 0x1p-53);
}

NearestCase make_case(CaseKind kind, std::mt19937_64& random) {
  const Cubic c = make_cubic(kind, random);
  const double t = uniform(random, 0.0, 1.0);
  const Point on_curve = evaluate(c, t);
  const double size = kind == CaseKind::kTiny ? 1e-6 : 100.0;
  switch (random() % 4) {
    case 0: {
      const double bend = curvature(c, t);
      if (std::fabs(bend) > 1e-3 / size) return {c, on_curve + perp(tangent(c, t)) / bend};
      return {c, on_curve};
    }
    case 1: {
      const double off = size * std::pow(10.0, uniform(random, -16.0, -2.0));
      return {c, on_curve + Vec{uniform(random, -off, off), uniform(random, -off, off)}};
    }
    default: {
      const Vec off{uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0)};
      return {c, lerp(c.p[0], c.p[3], 0.5) + size * off};
    }
  }
}

double sampled_distance(const Cubic& curve, Point query, int samples) {
  // Computes relative to the query point, so that a tiny curve far from the origin is not lost in
  // rounding.
  Cubic c = curve;
  for (Point& control : c.p) control = Point{} + (control - query);
  const Point q;
  const auto n = static_cast<std::size_t>(samples);
  std::vector<double> d(n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    d[i] = distance_squared(evaluate(c, static_cast<double>(i) / static_cast<double>(n)), q);
  }
  double best = *std::min_element(d.begin(), d.end());
  std::array<std::size_t, 4> lowest{};  // interior local minima, lowest first
  std::size_t count = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    if ((i > 0 && d[i - 1] < d[i]) || (i < n && d[i + 1] < d[i])) continue;
    std::size_t place = std::min<std::size_t>(count, 3);
    if (count == 4 && !(d[i] < d[lowest[3]])) continue;
    for (; place > 0 && d[lowest[place - 1]] > d[i]; --place) lowest[place] = lowest[place - 1];
    lowest[place] = i;
    count = std::min<std::size_t>(count + 1, 4);
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double step = 1.0 / static_cast<double>(n), t = static_cast<double>(lowest[k]) * step;
    best = std::min(best, golden_section(c, q, std::max(t - step, 0.0), std::min(t + step, 1.0)));
  }
  return std::sqrt(best);
}

}  // namespace felt
