#pragma once

// For tests and benchmarks, not installed: cubics that are hard for nearest-point algorithms, and a
// slow reference solution.

#include <cstdint>
#include <random>

#include "felt/geometry/cubic.h"

namespace felt {

/// Kinds of segments on which sampling or root finding is known to go wrong.
enum class CaseKind : std::uint8_t {
  kRandom,
  kNearLine,     ///< inner points very close to the chord
  kOvershoot,    ///< collinear, handles beyond the ends: the line is traced several times
  kPoint,        ///< four equal points
  kCusp,         ///< handles crossed so that the curve stops and turns back
  kLoop,         ///< crosses itself
  kDoubledEnds,  ///< a handle of length zero at one end or both
  kArc,          ///< circle arc of 5 to 120 degrees, queried at or near its centre
  kTiny,         ///< size 1e-6 at coordinates of 1e4
};
inline constexpr int kCaseKinds = 9;

/// A segment and a query point.
struct NearestCase {
  Cubic curve;
  Point query;
};

/// Returns a random case of the kind, of extent about 100 (except kTiny). The queries are a mix:
/// around the curve, within 1e-14 .. 1 of it, exactly on it, and at its centre of curvature, where
/// stationary points merge. The same generator state gives the same case with every compiler.
NearestCase make_case(CaseKind kind, std::mt19937_64& random);

/// Returns a uniform number in [lo, hi), the same with every standard library.
double uniform(std::mt19937_64& random, double lo, double hi);

/// Returns the smallest distance from the query point to the curve: takes `samples` samples, then
/// does a golden section search around each of the four lowest local minima among them.
double sampled_distance(const Cubic& curve, Point query, int samples);

}  // namespace felt
