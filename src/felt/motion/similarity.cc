#include "felt/motion/similarity.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/base/constants.h"

namespace felt {
namespace {

constexpr int kRobustRounds = 12;
constexpr double kTukey = 4.685, kDeviationOfMad = 1.4826;
/// Fits below this deviation are exact: weights would only amplify rounding.
constexpr double kMinDeviationMm = 0.05;

Vec turned_by(Vec v, double angle_rad, double scale) noexcept {
  const double c = scale * std::cos(angle_rad), s = scale * std::sin(angle_rad);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

}  // namespace

Vec moved(const Similarity& motion, Vec v, double t) noexcept {
  return turned_by(v, t * motion.angle_rad, std::pow(motion.scale, t));
}

Point moved(const Similarity& motion, Point p, double t) noexcept {
  return lerp(motion.from, motion.to, t) + moved(motion, p - motion.from, t);
}

Point moved_back(const Similarity& motion, Point p) noexcept {
  return motion.from + turned_by(p - motion.to, -motion.angle_rad, 1.0 / motion.scale);
}

Point carried(const Similarity& motion, Point a, Point b, double t) noexcept {
  return moved(motion, lerp(a, moved_back(motion, b), t), t);
}

std::optional<Similarity> fit_similarity(std::span<const PointPair> pairs) noexcept {
  double weight = 0.0;
  Vec from{}, to{};
  for (const PointPair& p : pairs) {
    weight += p.weight;
    from += p.weight * (p.from - Point{});
    to += p.weight * (p.to - Point{});
  }
  if (!(weight > 0.0)) return std::nullopt;
  Similarity fit{Point{} + from / weight, Point{} + to / weight};
  double along = 0.0, across = 0.0, size = 0.0;
  for (const PointPair& p : pairs) {
    const Vec a = p.from - fit.from, b = p.to - fit.to;
    along += p.weight * dot(a, b);
    across += p.weight * cross(a, b);
    size += p.weight * norm_squared(a);
  }
  const double scale = std::hypot(along, across) / size;
  if (!(size > 1e-12 && scale > 1e-6 && std::isfinite(scale))) return std::nullopt;
  fit.angle_rad = std::atan2(across, along);
  fit.scale = scale;
  return fit;
}

Similarity fit_robust_similarity(std::span<PointPair> pairs, const Similarity& start) noexcept {
  Similarity fit = start;
  std::vector<double> errors(pairs.size()), sorted, weights;
  for (const PointPair& p : pairs) weights.push_back(p.weight);
  for (int round = 0; round < kRobustRounds && !pairs.empty(); ++round) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      errors[i] = distance(moved(fit, pairs[i].from), pairs[i].to);
    }
    sorted = errors;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double limit = kTukey * std::max(kDeviationOfMad * *middle, kMinDeviationMm);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double share = 1.0 - errors[i] * errors[i] / (limit * limit);
      pairs[i].weight = share > 0.0 ? weights[i] * share * share : 0.0;
    }
    const auto better = fit_similarity(pairs);
    if (!better) return fit;
    const bool is_settled = std::fabs(better->angle_rad - fit.angle_rad) < 1e-9 &&
                            std::fabs(better->scale - fit.scale) < 1e-9 &&
                            distance(better->to, moved(fit, better->from)) < 1e-9;
    fit = *better;
    if (is_settled) break;
  }
  return fit;
}

}  // namespace felt
