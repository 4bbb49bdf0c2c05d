#include "felt/geometry/roots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/base/constants.h"

namespace felt {
namespace {

struct CubicPolynomial {
  double c0, c1, c2, c3;

  [[nodiscard]] double value(double t) const noexcept { return c0 + t * (c1 + t * (c2 + t * c3)); }
  [[nodiscard]] double slope(double t) const noexcept {
    return c1 + t * (2.0 * c2 + t * (3.0 * c3));
  }
};

// Returns the root in [lo, hi]. Requires that f is monotone there and that f(lo) and f(hi) have
// different signs. A Newton step that leaves the bracket, or every third step, is replaced by
// halving.
double bracketed_root(const CubicPolynomial& f, double lo, double hi) noexcept {
  const bool rising = f.value(hi) > 0.0;
  double t = 0.5 * (lo + hi);
  for (int i = 0; i < 64 && hi - lo > kEpsilon * hi; ++i) {
    const double v = f.value(t);
    if (v == 0.0) return t;
    ((v > 0.0) == rising ? hi : lo) = t;
    const double next = t - v / f.slope(t);
    const bool newton = next > lo && next < hi && i % 3 != 2;
    if (newton && std::fabs(next - t) <= kEpsilon * std::fabs(t)) return next;
    t = newton ? next : 0.5 * (lo + hi);
  }
  return t;
}

}  // namespace

void UnitRoots::insert(double t) noexcept {
  if (!(t >= 0.0 && t <= 1.0) || count_ == 3) return;
  double* const place = std::lower_bound(t_.data(), t_.data() + count_, t);
  if (place != end() && *place == t) return;
  std::copy_backward(place, t_.data() + count_, t_.data() + count_ + 1);
  *place = t;
  ++count_;
}

UnitRoots linear_roots(double c0, double c1) noexcept {
  UnitRoots roots;
  if (c1 != 0.0) roots.insert(-c0 / c1 + 0.0);  // + 0.0 turns -0 into 0
  return roots;
}

UnitRoots quadratic_roots(double c0, double c1, double c2) noexcept {
  const double scale = std::max({std::fabs(c0), std::fabs(c1), std::fabs(c2)});
  if (!(scale > 0.0 && std::isfinite(scale))) return {};
  c0 /= scale, c1 /= scale, c2 /= scale;  // so that no product overflows
  if (c2 == 0.0) return linear_roots(c0, c1);
  UnitRoots roots;
  double discriminant = c1 * c1 - 4.0 * c2 * c0;
  const double noise = 4.0 * kEpsilon * (c1 * c1 + std::fabs(4.0 * c2 * c0));
  if (discriminant < -noise) return roots;
  discriminant = std::max(discriminant, 0.0);
  const double q = -0.5 * (c1 + std::copysign(std::sqrt(discriminant), c1));
  roots.insert(q / c2 + 0.0);
  if (q != 0.0) roots.insert(c0 / q + 0.0);
  return roots;
}

UnitRoots cubic_roots(double c0, double c1, double c2, double c3) noexcept {
  const double scale = std::max({std::fabs(c0), std::fabs(c1), std::fabs(c2), std::fabs(c3)});
  if (!(scale > 0.0 && std::isfinite(scale))) return {};
  const CubicPolynomial f{c0 / scale, c1 / scale, c2 / scale, c3 / scale};
  if (f.c3 == 0.0) return quadratic_roots(f.c0, f.c1, f.c2);
  UnitRoots roots;
  const UnitRoots extrema = quadratic_roots(f.c1, 2.0 * f.c2, 3.0 * f.c3);
  double lo = 0.0;
  for (int i = 0; i <= extrema.size(); ++i) {
    const double hi = i < extrema.size() ? extrema[i] : 1.0;
    const double at_lo = f.value(lo), at_hi = f.value(hi);
    const double noise = 4.0 * kEpsilon;  // of the value, because the coefficients are at most 1
    if (std::fabs(at_lo) <= noise) {
      if (i == 0 || roots.size() == 0 || lo - roots[roots.size() - 1] > 1e-7) roots.insert(lo);
    } else if (std::fabs(at_hi) > noise && (at_lo < 0.0) != (at_hi < 0.0)) {
      roots.insert(bracketed_root(f, lo, hi));
    }
    lo = hi;
  }
  if (std::fabs(f.value(1.0)) <= 4.0 * kEpsilon) roots.insert(1.0);
  return roots;
}

}  // namespace felt
