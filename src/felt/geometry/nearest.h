#pragma once

#include <optional>

#include "felt/geometry/cubic.h"

namespace felt {

/// The proven nearest point on a cubic segment, for any control points. Sampling followed by
/// Newton's method is not good enough: for up to 3 % of looping or overshooting cubics it finds a
/// point on the wrong branch, which makes the force in a haptic loop jump (R19).
///
/// Algorithm: with the curve f, the query point q and a(t) = f(t) - q, the squared distance
/// |a(t)|^2 is a polynomial of degree six. Its seven Bernstein coefficients on a piece of [0, 1]
/// are
///     c_k = sum over i + j = k of C(3,i) C(3,j) / C(6,k)  a_i . a_j,
/// where a_i are the control points of the piece relative to q.
///  1. The smallest c_k is a lower bound of the squared distance on that piece. If it is not below
///     the best squared distance found so far, the piece is discarded.
///  2. The number of sign changes of the differences c_{k+1} - c_k bounds the number of stationary
///     points on the piece (variation diminishing). If the bound is 0, an end of the piece is its
///     nearest point. If it is 1 and the distance falls at the start and rises at the end, the
///     stationary point is the minimum; a Newton iteration that cannot leave its bracket finds it.
///     If it is 1 but the distance does not fall and then rise in this way, an end is the nearest
///     point.
///  3. If the bound is larger, the piece is halved by de Casteljau; the left half comes first.
/// Every half has its own control points, so c_k is computed again for every piece and the rounding
/// error shrinks with the piece. If rounding could have changed the sign of a difference, the
/// difference counts as both signs, unless the rounding noise is below 3e-14 of the best squared
/// distance. The right halves wait on a fixed stack of 48 pieces, one for each halving. By the
/// two-circle theorem (Obreshkoff) at most about six pieces of each size are not discarded, because
/// there are only five stationary points. Usually the whole query needs 1 to 4 pieces.
///
/// Accuracy: the distance is right within 1e-14 of the largest distance from q to a control point.
/// Every kind of segment is allowed: points, straight lines traced twice, cusps, loops, zero
/// handles, arcs queried at their centre. Safe to call from any thread; does not allocate.
struct Nearest {
  double t = 0.0;  ///< parameter of the point, 0..1
  /// In mm^2. Computed relative to the query point, so it is exact to a few ulp of the distances
  /// even if the rounding error of `point` is larger than the distance.
  double distance_squared = 0.0;
  Point point;  ///< evaluate(c, t)
};

/// Returns the point of c nearest to q, including the ends. If several points have the same
/// distance (up to rounding), returns the one with the lowest t. If a coordinate is not finite, or
/// the squared distances overflow (1e150 mm), it returns t = 0, the first control point, at
/// infinite distance.
Nearest nearest(const Cubic& c, Point q) noexcept;

/// Returns the nearest point, or nullopt if every point is farther than the square root of
/// `max_distance_squared`, or if the input is not finite. A point exactly at that limit is
/// returned. A call that returns nullopt is much faster than nearest(). So a search through many
/// segments should pass the best distance found so far.
std::optional<Nearest> nearest_within(const Cubic& c, Point q,
                                      double max_distance_squared) noexcept;

/// Same as above, but with a limit on the work, for callers with a deadline. Lowers `pieces_left`
/// by the number of pieces examined, and stops the search when `pieces_left` reaches 0. If
/// pieces_left > 0 afterwards, the answer is proven. If pieces_left is 0, the answer is the best
/// point found so far, or nullopt.
std::optional<Nearest> nearest_within(const Cubic& c, Point q, double max_distance_squared,
                                      int& pieces_left) noexcept;

}  // namespace felt
