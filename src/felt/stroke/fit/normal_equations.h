#pragma once

#include <cstddef>

#include "felt/geometry/cubic.h"
#include "felt/stroke/fit/segment_fit_kernels.h"

/// From the sums of the segment fit to its control points: small fixed systems, solved by
/// Cholesky's method. Private to the stroke layer. Thread: any; no allocation.
namespace felt::detail {

/// The two small terms that decide what the samples leave open (SegmentFit).
struct Priors {
  double energy;     ///< weight of |B4 - 3 B3 + 3 B2 - B1|^2
  double ridge;      ///< weight of the distance of each control point from its place on the chord
  Vec chord;         ///< last sample relative to the origin
  double length_mm;  ///< along the samples
};

/// Adds a sample that sits at an end of the curve, where one basis function is 1 and the others
/// are 0. `basis` counts from the first free control point.
void add_end_sample(NormalSums& sums, std::size_t basis, Vec sample, double weight) noexcept;

/// B1..B4 free; the sums are those of accumulate_free_start. False when the system is singular.
bool solve_free(const NormalSums& sums, const Priors& priors, Point origin, Cubic& curve) noexcept;

/// B1 = origin; B2, B3, B4 free. The sums are those of accumulate_fixed_start.
bool solve_point(const NormalSums& sums, const Priors& priors, Point origin, Cubic& curve) noexcept;

/// B1 = origin, B2 = B1 + a tangent; a, B3, B4 free, a within the handle limits of SegmentFit.
bool solve_tangent(const NormalSums& sums, const Priors& priors, Point origin, Vec tangent,
                   Cubic& curve) noexcept;

}  // namespace felt::detail
