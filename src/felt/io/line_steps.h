#pragma once

#include <algorithm>
#include <vector>

namespace felt {

/// Computes positions on a straight line of this length at which a fit must check it, so that the
/// fit meets its ends, which may be corners, and cannot leave it in between: at distance `first`
/// from each end, at twice that, and so on, never more than `most` apart. Replaces `steps` by
/// parameters 0 < t < 1, ascending. Requires first > 0 and first <= most.
inline void line_steps(double length, double first, double most, std::vector<double>& steps) {
  steps.clear();
  double gap = first, at = first;
  while (2.0 * at < length) {
    steps.push_back(at / length);
    gap = std::min(2.0 * gap, most);
    at += gap;
  }
  for (std::size_t i = steps.size(); i > 0; --i) {
    if (1.0 - steps[i - 1] > steps.back()) steps.push_back(1.0 - steps[i - 1]);
  }
}

}  // namespace felt
