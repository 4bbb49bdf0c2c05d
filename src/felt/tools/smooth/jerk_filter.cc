#include "felt/tools/smooth/jerk_filter.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace felt {

double jerk_weight(double wavelength_mm, double spacing_mm) noexcept {
  const double x = wavelength_mm / (2.0 * std::numbers::pi * spacing_mm);
  return x * x * x * x * x * x;
}

void JerkFilter::apply(std::span<const FilterPlace> row, std::span<Point> out) {
  for (std::size_t k = 0; k < row.size(); ++k) out[k] = row[k].point;
  if (row.size() < 4) return;
  weights_.assign(row.size() - 3, 0.0);
  for (std::size_t j = 0; j + 3 < row.size(); ++j) {
    if (row[j + 1].is_fixed || row[j + 2].is_fixed) continue;
    weights_[j] =
        std::min({row[j].weight, row[j + 1].weight, row[j + 2].weight, row[j + 3].weight});
  }
  // Solves each stretch of non-zero weights separately.
  for (std::size_t j = 0; j < weights_.size();) {
    if (!(weights_[j] > 0.0)) {
      ++j;
      continue;
    }
    std::size_t end = j;
    while (end < weights_.size() && weights_[end] > 0.0) ++end;
    const std::size_t count = end - j + 3;
    solve(row.subspan(j, count), std::span<const double>(weights_).subspan(j, end - j),
          out.subspan(j, count));
    j = end;
  }
}

void JerkFilter::solve(std::span<const FilterPlace> row, std::span<const double> weights,
                       std::span<Point> out) {
  constexpr std::array<double, 4> kJerk = {1.0, -3.0, 3.0, -1.0};
  const std::size_t n = row.size();
  // Uses coordinates relative to a point of the row, so that rounding errors do not depend on the
  // position on the page.
  const Point origin = row[0].point;
  const auto is_fixed = [&](std::size_t k) { return row[k].is_fixed || k == 0 || k + 1 == n; };
  rows_.assign(n, {1.0, 0.0, 0.0, 0.0, {}});
  for (std::size_t k = 0; k < n; ++k) rows_[k].right = Point{} + (row[k].point - origin);
  for (std::size_t j = 0; j < weights.size(); ++j) {
    for (std::size_t a = 0; a < 4; ++a) {
      if (is_fixed(j + a)) continue;
      Row& r = rows_[j + a];
      for (std::size_t b = 0; b < 4; ++b) {
        const double value = weights[j] * kJerk[a] * kJerk[b];
        if (is_fixed(j + b)) {
          r.right -= value * (row[j + b].point - origin);
        } else if (b == a) {
          r.diagonal += value;
        } else if (b > a) {
          (b == a + 1 ? r.next : b == a + 2 ? r.second : r.third) += value;
        }
      }
    }
  }
  // Factorises L D L^T in place; `next`, `second` and `third` become columns of L.
  for (std::size_t k = 0; k < n; ++k) {
    Row& r = rows_[k];
    const std::array<double, 3> upper = {r.next, r.second, r.third};
    const std::array<double, 3> factor = {r.next / r.diagonal, r.second / r.diagonal,
                                          r.third / r.diagonal};
    for (std::size_t a = 0; a < 3 && k + 1 + a < n; ++a) {
      Row& below = rows_[k + 1 + a];
      below.diagonal -= factor[a] * upper[a];
      if (a < 2) below.next -= factor[a] * upper[a + 1];
      if (a < 1) below.second -= factor[a] * upper[a + 2];
      below.right -= factor[a] * (r.right - Point{});
    }
    r.next = factor[0];
    r.second = factor[1];
    r.third = factor[2];
  }
  for (std::size_t k = n; k-- > 0;) {
    Row& r = rows_[k];
    Vec x = (r.right - Point{}) / r.diagonal;
    if (k + 1 < n) x -= r.next * (rows_[k + 1].right - Point{});
    if (k + 2 < n) x -= r.second * (rows_[k + 2].right - Point{});
    if (k + 3 < n) x -= r.third * (rows_[k + 3].right - Point{});
    r.right = Point{} + x;
    out[k] = is_fixed(k) ? row[k].point : origin + x;
  }
}

}  // namespace felt
