#pragma once

#include <cstddef>

#include "felt/geometry/cubic.h"

/// The two inner loops of the segment fit, four samples at a time. They use explicit SIMD lanes, so
/// that every machine adds in the same order and computes the same bits. On x86-64, a second
/// version for wider registers is chosen at load time if the processor has them; it does not use
/// fused multiply-add either (options.cmake). Private to the stroke layer. Any thread may call
/// them. They do not allocate.
namespace felt::detail {

/// A cubic in power form relative to an origin: f(t) = ((a3 t + a2) t + a1) t + a0.
struct PowerCubic {
  Vec a0, a1, a2, a3;
};

/// A run: consecutive samples to which one cubic is fitted. The kernels may read up to three
/// elements beyond `count` from each array.
struct RunView {
  const double* x;
  const double* y;
  const double* inverse_limit;
  const double* weight;
  std::size_t count;
  Point origin;
};

/// Moves every parameter one Newton step towards the foot point of its sample, clamped to [0, 1],
/// and sets `ratio` to the squared distance at the new parameter times the `inverse_limit` of the
/// sample.
///   t <- t - (e.f') / (f'.f' + e.f''), e = f(t) - P [Plass & Stone 1983; Schneider 1990]
/// If the denominator is not safely positive, f'.f' (Gauss-Newton) is used instead. Requires that t
/// and ratio have space for `count` + 3 values.
void project(const PowerCubic& curve, const RunView& run, double* t, double* ratio) noexcept;

/// Sums over samples for the normal equations of the control points. b_j are the basis functions, M
/// is the metric of a sample (see below), and q is the position of the sample relative to
/// RunView::origin. The index pairs (j, k) are stored as in a lower triangle: (0,0) (1,0) (1,1)
/// (2,0) ...
struct NormalSums {
  double xx[10];  ///< sum b_j b_k m11
  double xy[10];  ///< sum b_j b_k m12
  double yy[10];  ///< sum b_j b_k m22
  double rx[4];   ///< sum b_j (M q).x
  double ry[4];   ///< sum b_j (M q).y
};

/// Compute the sums. The basis functions are the Bernstein functions of the free control points:
/// B1..B4 if the start is free; B2..B4 if it is fixed (B1 must then be at RunView::origin). The
/// metric of each sample is
///   M = (1 - w) n n' + w I,   n = unit normal of the curve at t,
/// that is, the squared distance along the normal plus w times the squared distance along the
/// tangent (tangent distance minimisation with a damping term: Wang, Pottmann, Liu 2006, "Fitting
/// B-spline curves to point clouds by curvature-based squared distance minimization", section 3).
/// With w = 1, this is ordinary least squares. The term of each sample is multiplied by its weight.
/// Only samples with an index in [begin, end) are included.
void accumulate_fixed_start(const PowerCubic& curve, const RunView& run, const double* t,
                            std::size_t begin, std::size_t end, double w,
                            NormalSums& sums) noexcept;
void accumulate_free_start(const PowerCubic& curve, const RunView& run, const double* t,
                           std::size_t begin, std::size_t end, double w, NormalSums& sums) noexcept;

}  // namespace felt::detail
