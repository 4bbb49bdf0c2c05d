#pragma once

#include <span>
#include <vector>

#include "felt/geometry/point.h"

namespace felt::bench {

/// Returns the distance of Kolmogorov and Smirnov: the largest difference between the two
/// distributions, 0..1. Requires that neither is empty.
double ks_distance(std::vector<double> a, std::vector<double> b);

/// Returns the value that a share of the numbers (0..1) does not exceed. Requires numbers.
double quantile(std::vector<double> values, double share);

/// Returns the correlation coefficient r of x and y.
double correlation(std::span<const Point> values);

/// The mean of numbers, one per person, and its 95 % interval over persons: the percentile
/// bootstrap with 10,000 resamples (Efron, Tibshirani, *An Introduction to the Bootstrap*, 1993).
struct MeanOverPeople {
  double mean = 0.0, low = 0.0, high = 0.0;
};
/// Requires numbers. The same numbers give the same result.
MeanOverPeople mean_over_people(std::span<const double> values);

}  // namespace felt::bench
