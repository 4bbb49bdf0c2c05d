#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace felt {

/// The mean of values, one for each participant, with an interval for the mean of all people. For
/// the difference between two conditions, the values are the differences within each participant.
struct MeanInterval {
  double mean = 0.0, low = 0.0, high = 0.0;
  friend bool operator==(const MeanInterval&, const MeanInterval&) = default;
};

/// Fewer values give no interval, because the bootstrap then has too few different resamples.
inline constexpr std::size_t kMinIntervalValues = 5;

/// Returns the mean of the values and its interval with a confidence of 0 to 1: the studentised
/// bootstrap (bootstrap-t) with 4,000 resamples. Unlike the percentile bootstrap, it also covers
/// the mean with about the stated confidence if there are only 12 values and their distribution is
/// skewed. The same values, confidence and seed give the same interval. Returns nullopt for fewer
/// than kMinIntervalValues values, or if a value or the confidence is invalid. If all values are
/// equal, the interval is empty.
///
/// Sources: Efron, Tibshirani, "An Introduction to the Bootstrap", 1993, chapter 12; Hesterberg,
/// "What teachers should know about the bootstrap", 2015, DOI 10.1080/00031305.2015.1089789.
std::optional<MeanInterval> mean_interval(std::span<const double> values, double confidence,
                                          std::uint64_t seed = 1);

/// Returns the mean; 0 without values.
double mean_of(std::span<const double> values) noexcept;

/// Returns the effect size d_z: the mean of the differences divided by their standard deviation (n
/// - 1). Returns nullopt for fewer than two differences, or if they are all equal. Source: Cohen,
/// "Statistical Power Analysis for the Behavioral Sciences", 1988, 2.3.5.
std::optional<double> effect_size_dz(std::span<const double> differences) noexcept;

}  // namespace felt
