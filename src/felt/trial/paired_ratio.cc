#include "felt/trial/paired_ratio.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "felt/trial/student_t.h"

namespace felt {
namespace {

/// Returns how many standard errors a mean is above `level`; infinite without any scatter.
double t_against(const MeanAndError& mean, double level) noexcept {
  const double difference = mean.mean - level;
  if (mean.standard_error > 0.0) return difference / mean.standard_error;
  if (difference == 0.0) return 0.0;
  return std::copysign(std::numeric_limits<double>::infinity(), difference);
}

MeanInterval as_ratio(const MeanInterval& logs) noexcept {
  return {std::exp(logs.mean), std::exp(logs.low), std::exp(logs.high)};
}

}  // namespace

std::optional<RatioTests> test_ratios(std::span<const double> log_ratios, double margin) {
  if (!(margin >= 0.0) || !std::isfinite(margin)) return {};
  const auto wide = student_interval(log_ratios, kRatioConfidence);
  const auto narrow = student_interval(log_ratios, 2.0 * kRatioConfidence - 1.0);
  if (!wide || !narrow) return {};
  const MeanAndError mean = mean_and_error(log_ratios);
  const std::size_t freedom = log_ratios.size() - 1;
  RatioTests tests;
  tests.people = log_ratios.size();
  tests.ratio = as_ratio(*wide);
  tests.narrow_ratio = as_ratio(*narrow);
  tests.deviation = mean.standard_error * std::sqrt(static_cast<double>(tests.people));
  tests.p_different = 2.0 * student_t_share(-std::abs(t_against(mean, 0.0)), freedom);
  if (margin > 0.0) {
    const double worse = std::log1p(margin);
    tests.p_not_worse = student_t_share(t_against(mean, worse), freedom);
    tests.p_not_better = student_t_share(-t_against(mean, -worse), freedom);
  }
  return tests;
}

std::vector<double> holm_corrected(std::span<const double> probabilities) {
  std::vector<std::size_t> order(probabilities.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return probabilities[a] < probabilities[b];
  });
  std::vector<double> corrected(probabilities.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    // The smallest one is multiplied by the number of hypotheses, the next one by one less.
    const auto factor = static_cast<double>(order.size() - i);
    largest = std::max(largest, std::min(1.0, factor * probabilities[order[i]]));
    corrected[order[i]] = largest;
  }
  return corrected;
}

}  // namespace felt
