#include "felt/trial/student_t.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace felt {
namespace {

/// Returns the probability that the number is between -t and t. The distribution with a whole
/// number of degrees of freedom is a finite sum of powers of the cosine.
double share_within(double t, std::size_t freedom) noexcept {
  const double angle = std::atan(t / std::sqrt(static_cast<double>(freedom)));
  const double sine = std::sin(angle), cosine = std::cos(angle);
  const bool is_odd = freedom % 2 == 1;
  double term = is_odd ? cosine : 1.0, sum = freedom == 1 ? 0.0 : term;
  for (std::size_t i = is_odd ? 3 : 2; i + 2 <= freedom; i += 2) {
    term *= cosine * cosine * static_cast<double>(i - 1) / static_cast<double>(i);
    sum += term;
  }
  return is_odd ? 2.0 / std::numbers::pi * (angle + sine * sum) : sine * sum;
}

}  // namespace

double student_t_share(double t, std::size_t freedom) noexcept {
  if (std::isinf(t)) return t > 0.0 ? 1.0 : 0.0;
  // The sum of the series may be above 1 by a rounding error.
  const double within = std::min(share_within(std::abs(t), freedom), 1.0);
  return 0.5 + 0.5 * std::copysign(within, t);
}

double student_t_quantile(double share, std::size_t freedom) noexcept {
  double low = -1.0, high = 1.0;
  while (student_t_share(low, freedom) > share && low > -1e300) low *= 2.0;
  while (student_t_share(high, freedom) < share && high < 1e300) high *= 2.0;
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (student_t_share(middle, freedom) < share ? low : high) = middle;
  }
  return high;
}

MeanAndError mean_and_error(std::span<const double> values) noexcept {
  const double mean = mean_of(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const auto count = static_cast<double>(values.size());
  const double deviation = std::sqrt(squares / (count - 1.0));
  // Equal values may differ from their rounded mean in the last digits.
  const bool are_equal = deviation <= 1e-12 * std::abs(mean);
  return {mean, are_equal ? 0.0 : deviation / std::sqrt(count)};
}

std::optional<MeanInterval> student_interval(std::span<const double> values, double confidence) {
  if (values.size() < kMinIntervalValues || !(confidence > 0.0 && confidence < 1.0)) return {};
  const MeanAndError mean = mean_and_error(values);
  if (!std::isfinite(mean.mean) || !std::isfinite(mean.standard_error)) return {};
  const double reach =
      student_t_quantile(0.5 + 0.5 * confidence, values.size() - 1) * mean.standard_error;
  return MeanInterval{mean.mean, mean.mean - reach, mean.mean + reach};
}

}  // namespace felt
