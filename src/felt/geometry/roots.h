#pragma once

#include <array>

namespace felt {

/// Up to three roots in [0, 1], in ascending order; iterate over it.
class UnitRoots {
 public:
  [[nodiscard]] const double* begin() const noexcept { return t_.data(); }
  [[nodiscard]] const double* end() const noexcept { return t_.data() + count_; }
  [[nodiscard]] int size() const noexcept { return count_; }
  [[nodiscard]] double operator[](int i) const noexcept { return t_[static_cast<unsigned>(i)]; }

  /// Adds t if it is in [0, 1] and differs from the stored roots; keeps the order.
  void insert(double t) noexcept;

 private:
  std::array<double, 3> t_{};
  int count_ = 0;
};

/// Real roots in [0, 1] of polynomials with coefficients in ascending powers, c0 + c1 t + ...
///
/// A multiple root is reported once. A leading coefficient of zero lowers the degree. The zero
/// polynomial and coefficients that are not finite have no roots. Rounding may move a root by a few
/// ulp of the coefficients divided by the slope there; if rounding errors of this size leave a
/// double root just off the axis, the root is still reported.
UnitRoots linear_roots(double c0, double c1) noexcept;

/// Uses the form without cancellation: q = -(c1 + sign(c1) sqrt(disc)) / 2, roots q / c2 and
/// c0 / q. Source: Press et al., Numerical Recipes, 5.6.
UnitRoots quadratic_roots(double c0, double c1, double c2) noexcept;

/// Splits [0, 1] at the extrema (roots of the derivative). Finds the root in each monotone piece by
/// Newton steps that stay inside a bracket; at most 64 steps per piece.
UnitRoots cubic_roots(double c0, double c1, double c2, double c3) noexcept;

}  // namespace felt
