#pragma once

#include <string>
#include <vector>

namespace felt {

/// The ticks of an axis: multiples of 1, 2 or 5 times a power of ten.
struct PlotTicks {
  double step = 1.0;
  std::vector<double> values;  ///< from `low` to `high` inclusive, ascending

  /// Returns the text of a tick, with as many decimals as the step needs; never "-0".
  [[nodiscard]] std::string label(double value) const;
};

/// Returns about `count` ticks for a range, and at least 2. Returns no ticks if the range is empty
/// or not finite, narrower than 1e-9 or than a billionth of its distance from 0, or wider than 1e9.
PlotTicks plot_ticks(double low, double high, int count);

}  // namespace felt
