#pragma once

#include <span>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// One point of a row to be filtered.
struct FilterPlace {
  Point point;
  double weight = 0.0;    ///< weight of the third differences; 0: this point stays
  bool is_fixed = false;  ///< does not move, and the row may have a corner here
};

/// A low-pass filter along a row of evenly spaced points. It preserves round shapes. The filtered
/// points Q_k minimise, for the points P_k of the row,
///
///   sum |Q_k - P_k|^2 + sum w_j |Q_j - 3 Q_{j+1} + 3 Q_{j+2} - Q_{j+3}|^2
///
/// The third difference is zero on parabolas. A wave of length L is scaled by 1/(1 + w (2 pi
/// h/L)^6), where h is the spacing. So waves longer than the cutoff hardly change (a Butterworth
/// filter of the sixth order). A moving average, or a filter with the second difference, would
/// shrink every circle. w_j is the smallest weight of its four points, so that a point with weight
/// 0 does not move and does not affect other points; no third difference reaches across a fixed
/// point. Fixed points and both ends stay bit for bit. Writes to `out`, which must have the size of
/// `row`. Takes linear time (one banded Cholesky factorisation).
class JerkFilter {
 public:
  void apply(std::span<const FilterPlace> row, std::span<Point> out);

 private:
  struct Row {
    double diagonal, next, second, third;  // bands of the symmetric matrix, then of its factor
    Point right;
  };
  void solve(std::span<const FilterPlace> row, std::span<const double> weights,
             std::span<Point> out);

  std::vector<double> weights_;
  std::vector<Row> rows_;
};

/// Returns the weight that halves a wave of this length, for points `spacing_mm` apart.
double jerk_weight(double wavelength_mm, double spacing_mm) noexcept;

}  // namespace felt
