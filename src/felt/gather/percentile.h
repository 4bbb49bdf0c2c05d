#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace felt {

/// Returns the value below which `share` (0..1) of the values lie, and reorders the values. 0 if
/// there are none.
inline double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto k = std::min(values.size() - 1,
                          static_cast<std::size_t>(share * static_cast<double>(values.size())));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k), values.end());
  return values[k];
}

}  // namespace felt
