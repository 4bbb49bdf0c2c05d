#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "felt/base/random.h"

namespace felt::bench {

double ks_distance(std::vector<double> a, std::vector<double> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  double largest = 0.0;
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    const double x = std::min(a[i], b[j]);
    while (i < a.size() && a[i] <= x) ++i;
    while (j < b.size() && b[j] <= x) ++j;
    largest =
        std::max(largest, std::abs(double(i) / double(a.size()) - double(j) / double(b.size())));
  }
  return largest;
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  return values[at];
}

double correlation(std::span<const Point> values) {
  const auto n = static_cast<double>(values.size());
  double x = 0.0, y = 0.0;
  for (const Point p : values) {
    x += p.x / n;
    y += p.y / n;
  }
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (const Point p : values) {
    xx += (p.x - x) * (p.x - x);
    yy += (p.y - y) * (p.y - y);
    xy += (p.x - x) * (p.y - y);
  }
  return xx > 0.0 && yy > 0.0 ? xy / std::sqrt(xx * yy) : 0.0;
}

MeanOverPeople mean_over_people(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  Random random(1);
  std::vector<double> means;
  for (int k = 0; k < 10'000; ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += values[random.bits() % values.size()];
    means.push_back(sum / n);
  }
  return {std::accumulate(values.begin(), values.end(), 0.0) / n, quantile(means, 0.025),
          quantile(means, 0.975)};
}

}  // namespace felt::bench
