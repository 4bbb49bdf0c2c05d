#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "felt/trial/statistics.h"

namespace felt {

/// Returns the probability that a number with Student's t distribution is at most `t`, with an
/// absolute error below 1e-12. Returns 0 and 1 for infinite numbers. Requires 1 to 100,000 degrees
/// of freedom; takes time in proportion to them. Source: Abramowitz, Stegun, "Handbook of
/// Mathematical Functions", 1964, equations 26.7.3 and 26.7.4.
double student_t_share(double t, std::size_t freedom) noexcept;

/// Returns the number `t` for which student_t_share is `share`: 2.365 for 0.975 and 7 degrees of
/// freedom. Requires a share above 0 and below 1.
double student_t_quantile(double share, std::size_t freedom) noexcept;

struct MeanAndError {
  double mean = 0.0;
  double standard_error = 0.0;  ///< standard deviation (n - 1) divided by the root of n
};
/// Returns the mean of at least two values and its standard error, which is exactly 0 if the values
/// are equal up to rounding.
MeanAndError mean_and_error(std::span<const double> values) noexcept;

/// Returns the mean of the values and its interval with a confidence of 0 to 1, from Student's t
/// distribution: exact for normally distributed values, however few there are. For the logarithms
/// of ratios; mean_interval() is for differences, which are skewed. Returns nullopt for fewer than
/// kMinIntervalValues values, or if a value or the confidence is invalid. If all values are equal,
/// the interval is empty. Source: Student, "The probable error of a mean", Biometrika 6, 1908, DOI
/// 10.1093/biomet/6.1.1.
std::optional<MeanInterval> student_interval(std::span<const double> values, double confidence);

}  // namespace felt
