#include "felt/stroke/width_map.h"

#include <algorithm>
#include <cmath>

#include "felt/stroke/stroke.h"

namespace felt {
namespace {

constexpr double kFastestTickMs = 0.2;

double finite_or(double value, double fallback) {
  return std::isfinite(value) ? value : fallback;
}

WidthMapOptions sane(WidthMapOptions o) {
  const WidthMapOptions d;
  o.min_mm = std::max(finite_or(o.min_mm, d.min_mm), kMinWidthMm);
  o.max_mm = std::max(finite_or(o.max_mm, d.max_mm), o.min_mm);
  if (!(o.gamma > 0.0) || !std::isfinite(o.gamma)) o.gamma = d.gamma;
  o.absent_pressure = std::clamp(finite_or(o.absent_pressure, d.absent_pressure), 0.0, 1.0);
  o.time_constant_ms = std::max(finite_or(o.time_constant_ms, d.time_constant_ms), 0.0);
  o.interval_ms = std::max(finite_or(o.interval_ms, d.interval_ms), kFastestTickMs);
  return o;
}

}  // namespace

double width_of_pressure(const WidthMapOptions& options, double p) noexcept {
  if (std::isnan(p)) p = options.absent_pressure;
  if (p <= 0.0) return options.min_mm;
  if (p >= 1.0) return options.max_mm;
  const double share = options.gamma == 1.0 ? p : std::pow(p, options.gamma);
  return std::min(options.min_mm + (options.max_mm - options.min_mm) * share, options.max_mm);
}

WidthMap::WidthMap(const WidthMapOptions& options) noexcept : options_(sane(options)) {
  begin();
}

void WidthMap::begin() noexcept {
  filtered_.reset();
  last_time_ns_.reset();
  pressure_ = options_.absent_pressure;
}

double WidthMap::push(const InkSample& sample) noexcept {
  if (sample.pressure && !std::isnan(*sample.pressure)) {
    pressure_ = std::clamp(*sample.pressure, 0.0, 1.0);
  }
  const double dt_ms = elapsed_ms(sample);
  if (!filtered_) {
    filtered_ = pressure_;
  } else {
    *filtered_ += (pressure_ - *filtered_) * (dt_ms / (options_.time_constant_ms + dt_ms));
  }
  return width_of_pressure(options_, *filtered_);
}

double WidthMap::elapsed_ms(const InkSample& sample) noexcept {
  double dt_ms = options_.interval_ms;
  if (sample.time_ns && last_time_ns_) {
    // In double: the difference of two hostile times does not fit into 64 bits.
    const double dt_ns = static_cast<double>(*sample.time_ns) - static_cast<double>(*last_time_ns_);
    dt_ms = dt_ns > 0.0 ? dt_ns * 1e-6 : kFastestTickMs;
  }
  last_time_ns_ = sample.time_ns;
  return dt_ms;
}

}  // namespace felt
