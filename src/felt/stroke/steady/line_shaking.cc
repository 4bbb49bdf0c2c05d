#include "felt/stroke/steady/line_shaking.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "felt/stroke/steady/shake_smoother.h"

namespace felt {
namespace {

/// Differences to the frequency of the hand, and jerks. Chosen like the numbers of ShakeSmoother.
constexpr std::array<ShakeSmoother::Start, 5> kStarts = {
    {{0.0, 8000.0}, {-1.0, 8000.0}, {1.0, 8000.0}, {0.0, 2000.0}, {0.0, 32000.0}}};
constexpr int kPasses = 8, kQuickPasses = 4;
constexpr double kMaxCareS = 60.0;
/// How far the shaking of a line usually is from that of the hand: standard deviation of the
/// logarithm of their ratio.
constexpr double kSpread = 0.3;

struct TimedVec {
  double s = 0.0;
  Vec at;
};

/// Returns one mean for all samples of half a node, so that a fast pen is as noisy as a slow one.
std::vector<TimedVec> grouped(std::span<const Vec> positions, std::span<const double> steps_s) {
  std::vector<TimedVec> groups;
  TimedVec sum;
  double s = 0.0, first_s = 0.0, count = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (i > 0) s += steps_s[i];
    if (count > 0.0 && s - first_s >= 0.5 * ShakeSmoother::kStepS) {
      groups.push_back({sum.s / count, sum.at / count});
      sum = {};
      count = 0.0;
    }
    if (count == 0.0) first_s = s;
    sum.s += s;
    sum.at += positions[i];
    count += 1.0;
  }
  groups.push_back({sum.s / count, sum.at / count});
  return groups;
}

/// Walks along the cubic spline through points whose slopes are those of parabolas through three
/// points (Catmull-Rom, for any times).
class SplineWalk {
 public:
  explicit SplineWalk(std::span<const TimedVec> points) : points_(points) {}

  /// Returns the point at a time. Requires: times do not decrease.
  Vec at(double s) {
    if (points_.size() == 1) return points_[0].at;
    while (i_ + 2 < points_.size() && points_[i_ + 1].s <= s) ++i_;
    const TimedVec &a = points_[i_], &b = points_[i_ + 1];
    const double step = b.s - a.s, u = std::clamp((s - a.s) / step, -0.5, 1.5), v = u - 1.0;
    return (1.0 + 2.0 * u) * v * v * a.at + u * u * (1.0 - 2.0 * v) * b.at +
           step * u * v * (v * slope(i_) + u * slope(i_ + 1));
  }

 private:
  [[nodiscard]] Vec slope(std::size_t i) const {
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, points_.size() - 1);
    const TimedVec &a = points_[before], &b = points_[i], &c = points_[after];
    const double h0 = b.s - a.s, h1 = c.s - b.s;
    if (h0 == 0.0) return (c.at - b.at) / h1;
    if (h1 == 0.0) return (b.at - a.at) / h0;
    return (h1 / h0 * (b.at - a.at) + h0 / h1 * (c.at - b.at)) / (h0 + h1);
  }

  std::span<const TimedVec> points_;
  std::size_t i_ = 0;
};

double rms(std::span<const Vec> values) {
  double sum = 0.0;
  for (const Vec& v : values) sum += norm_squared(v);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Returns the mean of what several starts find at the nodes.
LineShaking mean_of_starts(std::span<const Vec> nodes, double step_s, const AxisShake& shake) {
  const double seconds = step_s * static_cast<double>(nodes.size());
  const std::size_t starts = seconds > kMaxCareS ? 1 : kStarts.size();
  ShakeSmoother smoother(nodes, step_s, shake.hz, shake.swing_mm);
  LineShaking mean{std::vector<Vec>(nodes.size()), 0.0};
  double weights = 0.0;
  for (std::size_t m = 0; m < starts; ++m) {
    const ShakeSmoother::Start start{shake.hz + kStarts[m].hz, kStarts[m].jerk_mm_per_s3};
    const auto found = smoother.shaking(start, starts == 1 ? kQuickPasses : kPasses);
    const double size = rms(found);
    if (!std::isfinite(size)) continue;
    const double off = std::log(std::max(size, 1e-3) / norm(shake.swing_mm)) / kSpread;
    const double weight = std::exp(-0.5 * off * off) + 1e-9;
    for (std::size_t k = 0; k < found.size(); ++k) mean.shaking_mm[k] += weight * found[k];
    mean.jerk_mm_per_s3 += weight * std::log(smoother.jerk_mm_per_s3());
    weights += weight;
  }
  if (weights == 0.0) return mean;
  for (Vec& v : mean.shaking_mm) v = v / weights;
  mean.jerk_mm_per_s3 = std::exp(mean.jerk_mm_per_s3 / weights);
  return mean;
}

}  // namespace

LineShaking find_line_shaking(std::span<const Vec> positions_mm, std::span<const double> steps_s,
                              const AxisShake& shake) {
  if (positions_mm.empty()) return {};
  double seconds = 0.0;
  for (std::size_t i = 1; i < positions_mm.size(); ++i) seconds += steps_s[i];
  const double steps = std::max(1.0, std::round(seconds / ShakeSmoother::kStepS));
  const double step_s = seconds > 0.0 ? seconds / steps : ShakeSmoother::kStepS;
  const std::vector<TimedVec> groups = grouped(positions_mm, steps_s);
  SplineWalk pen(groups);
  std::vector<Vec> nodes;
  for (double k = 0.0; k <= steps; k += 1.0) nodes.push_back(pen.at(k * step_s));
  LineShaking result = mean_of_starts(nodes, step_s, shake);
  std::vector<TimedVec> found;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    found.push_back({static_cast<double>(k) * step_s, result.shaking_mm[k]});
  }
  SplineWalk shaking(found);
  result.shaking_mm.clear();
  double s = 0.0;
  for (std::size_t i = 0; i < positions_mm.size(); ++i) {
    if (i > 0) s += steps_s[i];
    result.shaking_mm.push_back(shaking.at(s));
  }
  return result;
}

}  // namespace felt
