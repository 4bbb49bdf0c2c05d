#include "felt/motion/line_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "felt/base/constants.h"
#include "felt/geometry/polyline.h"

namespace felt {
namespace {

constexpr int kSteps = 16;  // of a segment
/// Tight bends are looked for between this many points, with arms of kArm points.
constexpr std::size_t kBendPoints = 97, kArm = 4;
constexpr double kMinTurnRad = 35.0 / kDegPerRad;
constexpr double kMinBendRad = 55.0 / kDegPerRad;
/// Features nearer to an end or to each other than this share of the length are one.
constexpr double kApartShare = 0.04;
constexpr std::size_t kMaxFeatures = 48;
/// The costs of an alignment: a shift by the whole length, a turn by half a turn, and a feature
/// without partner.
constexpr double kShiftCost = 6.0, kTurnCost = 2.0, kSkipCost = 0.75;

double turn_between(Vec in, Vec out) noexcept {
  return std::atan2(cross(in, out), dot(in, out));
}

void append_corners(const Stroke& stroke, const StepLengths& lengths,
                    std::vector<LineFeature>& features) {
  for (int i = 1; i < stroke.segment_count(); ++i) {
    if (stroke.joint(i) != JointKind::kCorner) continue;
    const double turn =
        turn_between(tangent(stroke.segment(i - 1), 1.0), tangent(stroke.segment(i), 0.0));
    if (std::fabs(turn) < kMinTurnRad) continue;
    features.push_back({lengths.length_at(i) / lengths.length_mm(), turn});
  }
}

/// Appends local maxima of the turn between two arms.
void append_bends(const Stroke& stroke, const StepLengths& lengths,
                  std::vector<LineFeature>& features) {
  std::array<Point, kBendPoints> points;
  for (std::size_t i = 0; i < kBendPoints; ++i) {
    const double share = static_cast<double>(i) / (kBendPoints - 1);
    points[i] = stroke.position(lengths.u_at(share * lengths.length_mm()));
  }
  std::array<double, kBendPoints> turns{};
  for (std::size_t i = kArm; i + kArm < kBendPoints; ++i) {
    turns[i] = turn_between(points[i] - points[i - kArm], points[i + kArm] - points[i]);
  }
  for (std::size_t i = kArm; i + kArm < kBendPoints; ++i) {
    if (std::fabs(turns[i]) < kMinBendRad) continue;
    bool is_peak = true;
    for (std::size_t k = i - kArm; k <= i + kArm; ++k) {
      const double there = std::fabs(turns[k]), here = std::fabs(turns[i]);
      if (there > here || (there == here && k < i)) is_peak = false;
    }
    if (is_peak) features.push_back({static_cast<double>(i) / (kBendPoints - 1), turns[i]});
  }
}

double cost_of_pair(const LineFeature& a, const LineFeature& b) noexcept {
  return kShiftCost * std::fabs(a.share - b.share) +
         kTurnCost * std::fabs(a.turn_rad - b.turn_rad) / std::numbers::pi;
}

}  // namespace

StepLengths::StepLengths(const Stroke& stroke) : lengths_{0.0} {
  lengths_.reserve(static_cast<std::size_t>(kSteps * stroke.segment_count()) + 1);
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic segment = stroke.segment(i);
    Point before = segment.p[0];
    for (int k = 1; k <= kSteps; ++k) {
      const Point p = evaluate(segment, static_cast<double>(k) / kSteps);
      // A step of length 0 still moves on, so that every length has one parameter.
      lengths_.push_back(lengths_.back() + std::max(distance(before, p), 1e-9));
      before = p;
    }
  }
}

double StepLengths::length_at(double u) const noexcept {
  const double step = std::clamp(u * kSteps, 0.0, static_cast<double>(lengths_.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(step), lengths_.size() - 2);
  const double t = step - static_cast<double>(i);
  return (1.0 - t) * lengths_[i] + t * lengths_[i + 1];
}

double StepLengths::u_at(double length_mm) const noexcept {
  if (!(length_mm > 0.0)) return 0.0;
  const auto next = std::lower_bound(lengths_.begin(), lengths_.end(), length_mm);
  if (next == lengths_.end()) return static_cast<double>(lengths_.size() - 1) / kSteps;
  const auto i = static_cast<std::size_t>(next - lengths_.begin());
  const double t = (length_mm - lengths_[i - 1]) / (lengths_[i] - lengths_[i - 1]);
  return (static_cast<double>(i - 1) + t) / kSteps;
}

std::vector<LineFeature> line_features(const Stroke& stroke, const StepLengths& lengths) {
  std::vector<LineFeature> all;
  append_corners(stroke, lengths, all);
  append_bends(stroke, lengths, all);
  // The sharpest first; a bend beside a sharper feature is the same feature.
  std::stable_sort(all.begin(), all.end(), [](const LineFeature& a, const LineFeature& b) {
    return std::fabs(a.turn_rad) > std::fabs(b.turn_rad);
  });
  std::vector<LineFeature> features;
  for (const LineFeature& f : all) {
    const bool is_apart = std::all_of(features.begin(), features.end(), [&](const LineFeature& g) {
      return std::fabs(f.share - g.share) >= kApartShare;
    });
    const bool is_inside = f.share >= kApartShare && f.share <= 1.0 - kApartShare;
    if (is_apart && is_inside && features.size() < kMaxFeatures) features.push_back(f);
  }
  std::sort(features.begin(), features.end(),
            [](const LineFeature& a, const LineFeature& b) { return a.share < b.share; });
  return features;
}

std::vector<std::pair<std::size_t, std::size_t>> align_features(const std::vector<LineFeature>& a,
                                                                const std::vector<LineFeature>& b) {
  const std::size_t wide = b.size() + 1;
  std::vector<double> costs((a.size() + 1) * wide);
  std::vector<std::uint8_t> steps(costs.size());  // 0: skip a, 1: skip b, 2: a pair
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t k = 0; k <= b.size(); ++k) {
      double& cost = costs[i * wide + k];
      cost = i + k == 0 ? 0.0 : kInf;
      const auto offer = [&](double price, std::uint8_t step) {
        if (price >= cost) return;
        cost = price;
        steps[i * wide + k] = step;
      };
      if (i > 0 && k > 0) {
        offer(costs[(i - 1) * wide + k - 1] + cost_of_pair(a[i - 1], b[k - 1]), 2);
      }
      if (i > 0) offer(costs[(i - 1) * wide + k] + kSkipCost, 0);
      if (k > 0) offer(costs[i * wide + k - 1] + kSkipCost, 1);
    }
  }
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = a.size(), k = b.size(); i + k > 0;) {
    const std::uint8_t step = steps[i * wide + k];
    if (step == 2) pairs.emplace_back(i - 1, k - 1);
    if (step != 1) --i;
    if (step != 0) --k;
  }
  std::reverse(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace felt
