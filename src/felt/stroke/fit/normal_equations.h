#pragma once

#include <cstddef>

#include "felt/geometry/cubic.h"
#include "felt/stroke/fit/segment_fit_kernels.h"

/// Solves the normal equations of the segment fit for its control points: small systems of fixed
/// size, solved by Cholesky's method. Private to the stroke layer. Any thread may call these
/// functions. They do not allocate.
namespace felt::detail {

/// The two small terms of SegmentFit, which determine the curve to the extent that the samples do
/// not.
struct Priors {
  double energy;     ///< weight of |B4 - 3 B3 + 3 B2 - B1|^2
  double ridge;      ///< weight of the distance of each control point from its point on the chord
  Vec chord;         ///< from the origin to the last sample
  double length_mm;  ///< path length along the samples
};

/// Adds a sample that lies at an end of the curve, where one basis function is 1 and the others are
/// 0. `basis` counts from the first free control point.
void add_end_sample(NormalSums& sums, std::size_t basis, Vec sample, double weight) noexcept;

/// Solves for B1..B4. The sums are those of accumulate_free_start. This function and the two below
/// return false if the system is singular.
bool solve_free(const NormalSums& sums, const Priors& priors, Point origin, Cubic& curve) noexcept;

/// Solves for B2, B3, B4 with B1 = origin. The sums are those of accumulate_fixed_start.
bool solve_point(const NormalSums& sums, const Priors& priors, Point origin, Cubic& curve) noexcept;

/// Solves for the factor a, B3 and B4, with B1 = origin and B2 = B1 + a * tangent. The factor a
/// stays within the handle limits of SegmentFit. The sums are those of accumulate_fixed_start.
bool solve_tangent(const NormalSums& sums, const Priors& priors, Point origin, Vec tangent,
                   Cubic& curve) noexcept;

}  // namespace felt::detail
