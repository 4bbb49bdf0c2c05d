#pragma once

#include <span>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// What a filter does at each of a row of places.
struct FilterPlace {
  Point point;
  double weight = 0.0;    ///< of the jerk around it; 0: the row keeps this place as it is
  bool is_fixed = false;  ///< stays where it is, and the row may turn here
};

/// A low-pass along a row of evenly spaced points that keeps round shapes: minimises
///
///   sum |Q_k - P_k|^2 + sum w_j |Q_j - 3 Q_{j+1} + 3 Q_{j+2} - Q_{j+3}|^2
///
/// The third difference is zero on parabolas; a wave of length L comes through times
/// 1/(1 + w (2 pi h/L)^6), nearly flat below its cutoff (a Butterworth filter of the sixth order),
/// where a mean, or the second difference, shrinks every circle. w_j is the least weight of its
/// four places, so that what has weight 0 neither moves nor is moved; no third difference reaches
/// across a fixed place. Fixed places, and both ends, stay bit for bit. Result in `out`, which has
/// the size of `row`. Linear; one banded Cholesky factorisation.
class JerkFilter {
 public:
  void apply(std::span<const FilterPlace> row, std::span<Point> out);

 private:
  struct Row {
    double diagonal, next, second, third;  // of the symmetric matrix, then of its factor
    Point right;
  };
  void solve(std::span<const FilterPlace> row, std::span<const double> weights,
             std::span<Point> out);

  std::vector<double> weights_;
  std::vector<Row> rows_;
};

/// Weight whose filter halves a wave of this length, with points `spacing_mm` apart.
double jerk_weight(double wavelength_mm, double spacing_mm) noexcept;

}  // namespace felt
