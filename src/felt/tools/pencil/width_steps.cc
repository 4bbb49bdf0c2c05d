#include "felt/tools/pencil/width_steps.h"

#include <algorithm>
#include <cmath>

#include "felt/stroke/fit/width_map.h"

namespace felt {
namespace {

constexpr std::array kPenWidthsMm = {0.1, 0.2, 0.3, 0.5,  0.7,  1.0,  1.4,  2.0, 2.8,
                                     4.0, 5.6, 8.0, 11.0, 16.0, 22.0, 32.0, 45.0};

/// Returns the pressure at which the line has this width. Halves the interval, because the map is
/// monotonic and may be bent in any way.
double pressure_of_width(const WidthMapOptions& widths, double width_mm) noexcept {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (width_of_pressure(widths, middle) < width_mm ? low : high) = middle;
  }
  return high;
}

}  // namespace

WidthSteps::WidthSteps(const WidthMapOptions& widths) noexcept {
  const auto first = std::lower_bound(kPenWidthsMm.begin(), kPenWidthsMm.end(), widths.min_mm);
  const auto last = std::upper_bound(first, kPenWidthsMm.end(), widths.max_mm);
  const auto in_range = static_cast<std::size_t>(last - first);
  if (in_range < 2) return;
  count_ = std::min(in_range, kMax);
  for (std::size_t i = 0; i < count_; ++i) {
    widths_mm_[i] = *(first + static_cast<std::ptrdiff_t>(i * (in_range - 1) / (count_ - 1)));
    pressures_[i] = pressure_of_width(widths, widths_mm_[i]);
  }
}

std::optional<double> WidthSteps::held(std::optional<double> pressure) noexcept {
  if (count_ == 0 || !pressure || std::isnan(*pressure)) return pressure;
  const double at = std::clamp(*pressure, 0.0, 1.0) * static_cast<double>(count_);
  const bool stays = step_ && at > static_cast<double>(*step_) - kHysteresis &&
                     at < static_cast<double>(*step_ + 1) + kHysteresis;
  if (!stays) step_ = std::min(static_cast<std::size_t>(at), count_ - 1);
  return pressures_[*step_];
}

}  // namespace felt
