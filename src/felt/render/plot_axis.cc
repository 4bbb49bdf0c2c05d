#include "felt/render/plot_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace felt {
namespace {

/// Returns the largest nice step that still gives `count` ticks over `width`.
double nice_step(double width, int count) {
  const double rough = width / std::max(count, 1);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

bool is_useful(double low, double high) noexcept {
  return std::isfinite(low) && std::isfinite(high) && high - low >= 1e-9 && high - low <= 1e9 &&
         std::abs(low) + std::abs(high) <= 1e9 * (high - low);
}

}  // namespace

std::string PlotTicks::label(double value) const {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
  if (std::abs(value) < 0.5 * step) value = 0.0;
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

PlotTicks plot_ticks(double low, double high, int count) {
  PlotTicks ticks;
  if (!is_useful(low, high)) return ticks;
  ticks.step = nice_step(high - low, count);
  if (std::floor(high / ticks.step + 1e-9) - std::ceil(low / ticks.step - 1e-9) < 1.0) {
    ticks.step = nice_step(high - low, 2 * count + 1);  // the range lies between two ticks
  }
  const auto first = static_cast<std::int64_t>(std::ceil(low / ticks.step - 1e-9));
  const auto last = static_cast<std::int64_t>(std::floor(high / ticks.step + 1e-9));
  for (std::int64_t i = first; i <= last; ++i) {
    ticks.values.push_back(static_cast<double>(i) * ticks.step);
  }
  return ticks;
}

}  // namespace felt
