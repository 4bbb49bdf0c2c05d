#include "felt/trial/statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/base/random.h"

namespace felt {
namespace {

constexpr std::size_t kResamples = 4'000;

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;  ///< with n - 1
};

Moments moments_of(std::span<const double> values) noexcept {
  const double mean = mean_of(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const auto count = static_cast<double>(values.size());
  return {mean, count > 1.0 ? std::sqrt(squares / (count - 1.0)) : 0.0};
}

/// Returns a quantile by linear interpolation (type 7 of Hyndman and Fan, doi:10.2307/2684934).
double sorted_quantile(std::span<const double> sorted, double share) noexcept {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

}  // namespace

double mean_of(std::span<const double> values) noexcept {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

std::optional<MeanInterval> mean_interval(std::span<const double> values, double confidence,
                                          std::uint64_t seed) {
  if (values.size() < kMinIntervalValues || !(confidence > 0.0 && confidence < 1.0)) return {};
  const Moments all = moments_of(values);
  if (!std::isfinite(all.mean) || !std::isfinite(all.deviation)) return {};
  // Equal values may differ from their rounded mean in the last digits.
  if (all.deviation <= 1e-12 * std::abs(all.mean))
    return MeanInterval{all.mean, all.mean, all.mean};

  Random random(seed);
  std::vector<double> resample(values.size()), ratios;
  ratios.reserve(kResamples);
  while (ratios.size() < kResamples) {
    for (double& value : resample) {
      value = values[static_cast<std::size_t>(random.bits() % values.size())];
    }
    const Moments of_resample = moments_of(resample);
    // A resample of one value only has no scatter, and so no ratio.
    if (of_resample.deviation <= 1e-12 * all.deviation) continue;
    ratios.push_back((of_resample.mean - all.mean) / of_resample.deviation);
  }
  std::sort(ratios.begin(), ratios.end());
  // The square root of n is in both standard errors and cancels.
  const double tail = 0.5 * (1.0 - confidence);
  return MeanInterval{all.mean, all.mean - sorted_quantile(ratios, 1.0 - tail) * all.deviation,
                      all.mean - sorted_quantile(ratios, tail) * all.deviation};
}

std::optional<double> effect_size_dz(std::span<const double> differences) noexcept {
  const Moments all = moments_of(differences);
  if (differences.size() < 2 || !(all.deviation > 1e-12 * std::abs(all.mean))) return {};
  return all.mean / all.deviation;
}

}  // namespace felt
