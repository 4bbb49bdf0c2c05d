#include "felt/motion/close_gap.h"

#include <cmath>

namespace felt {
namespace {

constexpr int kMaxRounds = 12;
constexpr double kClosedMm = 1e-11;

/// A symmetric 2 x 2 matrix.
struct Spread {
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

/// Returns the shortest x with m x = v, or as near as possible if all edges have one direction.
Vec solve(const Spread& m, Vec v) noexcept {
  const double trace = m.xx + m.yy, det = m.xx * m.yy - m.xy * m.xy;
  if (!(trace > 0.0)) return {};
  if (det > 1e-9 * trace * trace) {
    return {(m.yy * v.x - m.xy * v.y) / det, (m.xx * v.y - m.xy * v.x) / det};
  }
  const double angle = 0.5 * std::atan2(2.0 * m.xy, m.xx - m.yy);
  const Vec axis{std::cos(angle), std::sin(angle)};
  return (dot(axis, v) / trace) * axis;
}

}  // namespace

double close_gap(std::span<double> lengths, std::span<const Vec> directions, Vec gap) noexcept {
  // Each round shortens edges by at most a share, so that they never turn round.
  for (int round = 0; round < kMaxRounds && norm(gap) > kClosedMm; ++round) {
    Spread spread;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const Vec d = directions[i];
      spread.xx += lengths[i] * d.x * d.x;
      spread.xy += lengths[i] * d.x * d.y;
      spread.yy += lengths[i] * d.y * d.y;
    }
    const Vec pull = solve(spread, gap);
    // All edges change by the factor 1 + pull * direction, which is at least this:
    const double share = norm(pull) * (1.0 + 1e-12);
    const double part = share > 1.0 - kMinEdgeShare ? (1.0 - kMinEdgeShare) / share : 1.0;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const double change = part * lengths[i] * dot(pull, directions[i]);
      lengths[i] += change;
      gap -= change * directions[i];
    }
    if (round >= 2 && part < 0.05) break;
  }
  return norm(gap);
}

}  // namespace felt
