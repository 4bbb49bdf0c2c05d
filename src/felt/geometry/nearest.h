#pragma once

#include <optional>

#include "felt/geometry/cubic.h"

namespace felt {

/// Certified nearest point on a cubic segment: never a wrong branch, whatever the control points.
/// In a force loop a wrong branch is a jump of the force, so sampling followed by Newton, which is
/// wrong for up to 3 % of looping or overshooting cubics, will not do (R19).
///
/// How it is proven. With a(t) = f(t) - q, the squared distance |a(t)|^2 is a polynomial of degree
/// six. Its seven Bernstein coefficients on a piece of [0, 1] are
///     c_k = sum over i + j = k of C(3,i) C(3,j) / C(6,k)  a_i . a_j,
/// where a_i are the control points of the piece seen from q.
///  1. Their smallest is a lower bound of the distance on that piece. When it is not below the best
///     distance found so far, the piece is done.
///  2. The sign changes of the differences c_{k+1} - c_k bound the number of stationary points on
///     the piece (variation diminishing). None: an end of the piece is its nearest point. One: it
///     is the minimum when the distance falls at the start and rises at the end, and is found by a
///     Newton iteration that cannot leave its bracket; else again an end.
///  3. More: halve the piece by de Casteljau and look at the halves, left one first.
/// The halves are control points again, so c_k is computed afresh for every piece and rounding
/// shrinks with the piece; signs within rounding noise count as both, unless the noise is below
/// 1e-14 of the best distance. Pieces are kept on a fixed stack of 48 places, one a halving. By the
/// two-circle theorem (Obreshkoff) at most about six pieces of each size survive: the five
/// stationary points hold the others' sign changes below two. Typical are 1 to 4 pieces in all.
///
/// Accuracy: the distance is right within 1e-14 of the largest distance from q to a control point.
/// Every kind of segment is allowed: points, straight lines run twice, cusps, loops, zero handles,
/// arcs queried at their centre. Thread: any; no allocation.
struct Nearest {
  double t = 0.0;  ///< parameter of the point, 0..1
  /// mm^2; computed about the query point, hence exact to a few ulp of the distances even where
  /// the rounding of `point` is larger than the distance.
  double distance_squared = 0.0;
  Point point;  ///< evaluate(c, t)
};

/// The point of c nearest to q, ends included. Of several at the same distance (up to rounding)
/// the one with the lowest t. When a coordinate is not finite, or the distances are so large that
/// their squares overflow (1e150 mm): t = 0, the first control point, at infinite distance.
Nearest nearest(const Cubic& c, Point q) noexcept;

/// The same, or nothing when every point is farther than the square root of `max_distance_squared`
/// (the limit itself is near enough). Much cheaper when the answer is "nothing", which is what a
/// search through many segments asks with the best so far. Nothing for input that is not finite.
std::optional<Nearest> nearest_within(const Cubic& c, Point q,
                                      double max_distance_squared) noexcept;

/// The same with a limit on work, for callers that have a deadline: lowers `pieces_left` by the
/// number of pieces looked at and stops when none is left. While pieces_left > 0 afterwards, the
/// answer is proven; at 0 it is the best found so far, perhaps nothing.
std::optional<Nearest> nearest_within(const Cubic& c, Point q, double max_distance_squared,
                                      int& pieces_left) noexcept;

}  // namespace felt
