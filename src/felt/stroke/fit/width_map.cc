#include "felt/stroke/fit/width_map.h"

#include <algorithm>
#include <cmath>

#include "felt/geometry/tilt.h"
#include "felt/stroke/stroke.h"

namespace felt {
namespace {

constexpr double kFastestTickMs = 0.2;

double finite_or(double value, double fallback) {
  return std::isfinite(value) ? value : fallback;
}

double sane_gamma(double gamma) {
  return gamma > 0.0 && std::isfinite(gamma) ? gamma : 1.0;
}

double sane_share(double value, double fallback) {
  return std::clamp(finite_or(value, fallback), 0.0, 1.0);
}

/// Returns p^gamma, exactly 0 and 1 at the ends.
double bent(double p, double gamma) {
  if (!(p > 0.0)) return 0.0;
  if (p >= 1.0) return 1.0;
  return gamma == 1.0 ? p : std::pow(p, gamma);
}

/// Returns 1 for an upright pen, `full` for a fully tilted one.
double by_tilt(double full, double l) {
  return 1.0 + (full - 1.0) * std::clamp(finite_or(l, 0.0), 0.0, 1.0);
}

WidthMapOptions sane(WidthMapOptions o) {
  const WidthMapOptions d;
  o.min_mm = std::max(finite_or(o.min_mm, d.min_mm), kMinWidthMm);
  o.max_mm = std::max(finite_or(o.max_mm, d.max_mm), o.min_mm);
  o.gamma = sane_gamma(o.gamma);
  o.absent_pressure = std::clamp(finite_or(o.absent_pressure, d.absent_pressure), 0.0, 1.0);
  o.time_constant_ms = std::max(finite_or(o.time_constant_ms, d.time_constant_ms), 0.0);
  o.interval_ms = std::max(finite_or(o.interval_ms, d.interval_ms), kFastestTickMs);
  o.tilt_width = std::max(finite_or(o.tilt_width, d.tilt_width), 1.0);
  o.absent_tilt_deg = finite_or(o.absent_tilt_deg, d.absent_tilt_deg);
  if (o.tone) {
    o.tone->light = sane_share(o.tone->light, 0.0);
    o.tone->heavy = sane_share(o.tone->heavy, 1.0);
    o.tone->gamma = sane_gamma(o.tone->gamma);
    o.tone->tilt = sane_share(o.tone->tilt, 1.0);
  }
  return o;
}

}  // namespace

double width_of_pressure(const WidthMapOptions& options, double p) noexcept {
  if (std::isnan(p)) p = options.absent_pressure;
  if (p >= 1.0) return options.max_mm;
  return std::min(options.min_mm + (options.max_mm - options.min_mm) * bent(p, options.gamma),
                  options.max_mm);
}

double width_of(const WidthMapOptions& options, double p, double l) noexcept {
  return width_of_pressure(options, p) * by_tilt(options.tilt_width, l);
}

double tone_of(const WidthMapOptions& options, double p, double l) noexcept {
  if (!options.tone) return tone_of_width(width_of(options, p, l));
  if (std::isnan(p)) p = options.absent_pressure;
  const ToneMapOptions& t = *options.tone;
  const double upright = std::lerp(t.light, t.heavy, bent(p, t.gamma));
  return std::clamp(upright * by_tilt(t.tilt, l), 0.0, 1.0);
}

WidthMap::WidthMap(const WidthMapOptions& options) noexcept : options_(sane(options)) {
  begin();
}

void WidthMap::begin() noexcept {
  is_first_ = true;
  last_time_ns_.reset();
  pressure_ = options_.absent_pressure;
  tilt_ = tilt_share(options_.absent_tilt_deg);
}

InkWidth WidthMap::push(const InkSample& sample) noexcept {
  if (sample.pressure && !std::isnan(*sample.pressure)) {
    pressure_ = std::clamp(*sample.pressure, 0.0, 1.0);
  }
  if (sample.tilt_deg && !std::isnan(*sample.tilt_deg)) tilt_ = tilt_share(*sample.tilt_deg);
  const double dt_ms = elapsed_ms(sample);
  if (is_first_) {
    filtered_pressure_ = pressure_;
    filtered_tilt_ = tilt_;
  } else {
    const double share = dt_ms / (options_.time_constant_ms + dt_ms);
    filtered_pressure_ += (pressure_ - filtered_pressure_) * share;
    filtered_tilt_ += (tilt_ - filtered_tilt_) * share;
  }
  is_first_ = false;
  const double width_mm = width_of(options_, filtered_pressure_, filtered_tilt_);
  return {width_mm, options_.tone ? tone_of(options_, filtered_pressure_, filtered_tilt_)
                                  : tone_of_width(width_mm)};
}

double WidthMap::elapsed_ms(const InkSample& sample) noexcept {
  double dt_ms = options_.interval_ms;
  if (sample.time_ns && last_time_ns_) {
    // In double, because the difference of two arbitrary times may not fit into 64 bits.
    const double dt_ns = static_cast<double>(*sample.time_ns) - static_cast<double>(*last_time_ns_);
    dt_ms = dt_ns > 0.0 ? dt_ns * 1e-6 : kFastestTickMs;
  }
  last_time_ns_ = sample.time_ns;
  return dt_ms;
}

}  // namespace felt
