#pragma once

#include <algorithm>
#include <vector>

namespace felt {

/// Where to look at a straight line of a length so that a fit sees its ends, which may be corners,
/// and cannot leave it in between: at `first` from each end, at twice that, and so on, never more
/// than `most` apart. Replaces `steps` by parameters 0 < t < 1, ascending. Requires first > 0 and
/// first <= most.
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
