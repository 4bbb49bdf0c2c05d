#pragma once

#include <algorithm>
#include <vector>

namespace felt {

/// Computes the positions on a straight line at which a curve fit must check its distance from the
/// line. They are dense near the ends, which may be corners: from each end towards the middle, the
/// first position is at distance `first`, and each further gap is at most twice the previous gap
/// and at most `max_gap`. So the fit meets the ends and stays near the line between them. Replaces
/// the content of `steps` with the positions as parameters 0 < t < 1, ascending. Requires first > 0
/// and first <= max_gap.
inline void line_steps(double length, double first, double max_gap, std::vector<double>& steps) {
  steps.clear();
  double gap = first, at = first;
  while (2.0 * at < length) {
    steps.push_back(at / length);
    gap = std::min(2.0 * gap, max_gap);
    at += gap;
  }
  for (std::size_t i = steps.size(); i > 0; --i) {
    if (1.0 - steps[i - 1] > steps.back()) steps.push_back(1.0 - steps[i - 1]);
  }
}

}  // namespace felt
