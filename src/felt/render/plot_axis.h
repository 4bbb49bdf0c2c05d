#pragma once

#include <string>
#include <vector>

namespace felt {

/// The ticks of an axis: multiples of 1, 2 or 5 times a power of ten.
struct PlotTicks {
  double step = 1.0;
  std::vector<double> values;  ///< from `low` to `high` inclusive, ascending

  /// The text of a tick, with as many decimals as the step needs; never "-0".
  [[nodiscard]] std::string label(double value) const;
};

/// Ticks of a range such that there are about `count` of them, at least 2 in any range that is
/// wider than nothing. Requires low <= high, both finite, and 1e-9 <= high - low <= 1e9 for a
/// useful answer; otherwise there are no ticks.
PlotTicks plot_ticks(double low, double high, int count);

}  // namespace felt
