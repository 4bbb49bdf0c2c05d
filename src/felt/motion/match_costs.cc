#include "felt/motion/match_costs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace felt {
namespace {

constexpr double kShapeWeight = 0.6, kLengthWeight = 0.35, kTurningWeight = 0.1, kOrderWeight = 0.2;
/// The mean distance of the points of a straight line from its middle, per length: with this, the
/// difference of two shapes is relative to their size.
constexpr double kSizeOfLength = 0.25;
/// Shapes smaller than this share of the reach are dots, which all look alike.
constexpr double kDotShare = 0.1;

/// Returns the mean distance of paired points after the centres have been put onto each other.
double shape_difference(const StrokeShape& a, const StrokeShape& b,
                        const ShapePairing& pairing) noexcept {
  const Vec shift = a.centre - b.centre;
  double sum = 0.0;
  for (std::size_t i = 0; i < kShapePoints; ++i) {
    sum += distance(a.points[i], paired_point(b, pairing, i) + shift);
  }
  return sum / static_cast<double>(kShapePoints);
}

}  // namespace

MatchCost match_cost(const StrokeShape& a, const StrokeShape& b, const MatchScale& scale,
                     double rank_difference, double limit) noexcept {
  // The mean distance of points is at least the distance of their means.
  const double apart = distance(a.centre, b.centre) / scale.reach_mm;
  const double dot = kDotShare * scale.reach_mm;
  const double fixed =
      kLengthWeight * std::fabs(std::log((a.length_mm + dot) / (b.length_mm + dot))) +
      kOrderWeight * rank_difference;
  if (apart + fixed >= limit) return {apart + fixed, {}};
  MatchCost result{0.0, pair_shapes(a, b, (limit - fixed) * scale.reach_mm)};
  result.cost = result.pairing.distance_mm / scale.reach_mm + fixed;
  if (result.cost >= limit) return result;
  const double size = std::max(0.5 * kSizeOfLength * (a.length_mm + b.length_mm), dot);
  const double turning = result.pairing.reversed ? -b.turning_rad : b.turning_rad;
  const double turned = std::fabs(a.turning_rad - turning) / std::numbers::pi;
  result.cost += kShapeWeight * shape_difference(a, b, result.pairing) / size +
                 kTurningWeight * std::min(turned, 2.0);
  return result;
}

}  // namespace felt
