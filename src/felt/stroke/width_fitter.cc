#include "felt/stroke/width_fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace felt {
namespace {

// Interpolating between knots rounds; this much of the tolerance pays for it.
constexpr double kRoundingMm = 1e-12;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

WidthFitter::WidthFitter(const WidthFitOptions& options) : options_(options) {
  options_.min_mm = std::max(options_.min_mm, kMinWidthMm);
  options_.max_mm = std::max(options_.max_mm, options_.min_mm);
  tolerance_mm_ = std::max(options_.tolerance_mm - kRoundingMm, 0.0);
  knots_.reserve(256);
}

void WidthFitter::begin() noexcept {
  knots_.clear();
  place_ = {};
}

void WidthFitter::push(double u, double width_mm) {
  if (!std::isfinite(u) || !std::isfinite(width_mm)) return;
  const double w = std::clamp(width_mm, options_.min_mm, options_.max_mm);
  u = std::max(u, place_.u);
  if (place_.count > 0.0 && u - place_.u >= kSameWidthPlace) {
    take_place();
    place_ = {};
  }
  if (place_.count == 0.0) place_ = {.u = u, .least = w, .most = w};
  place_.least = std::min(place_.least, w);
  place_.most = std::max(place_.most, w);
  place_.sum += w;
  place_.count += 1.0;
  place_.last = w;
}

void WidthFitter::finish(double u_end) {
  if (place_.count == 0.0) {
    knots_.assign({{0.0, options_.min_mm}, {u_end, options_.min_mm}});
    return;
  }
  if (u_end - place_.u < kSameWidthPlace) place_.u = u_end;
  forget_from(u_end);
  take_place();
  const double span = reach_ - knots_.back().u;
  if (span > 0.0) {
    const double to_last = (place_.last - knots_.back().width_mm) / span;
    close_segment(std::clamp(to_last, slopes_.low, slopes_.high));
  }
  // Past the last sample the width is held.
  if (knots_.back().u < u_end) knots_.push_back({u_end, knots_.back().width_mm});
}

WidthFitter::Range WidthFitter::allowed(const Place& place) const noexcept {
  const double low = place.most - tolerance_mm_, high = place.least + tolerance_mm_;
  if (low > high) {
    const double middle = 0.5 * (place.least + place.most);
    return {middle, middle};
  }
  // The model's limits as well, so that every knot keeps to them (I4).
  return {std::max(low, options_.min_mm), std::min(high, options_.max_mm)};
}

WidthFitter::Range WidthFitter::slopes_through(const Place& place) const noexcept {
  const auto [u1, w1] = knots_.back();
  const Range range = allowed(place);
  return {(range.low - w1) / (place.u - u1), (range.high - w1) / (place.u - u1)};
}

void WidthFitter::take_place() {
  if (knots_.empty()) {
    const Range range = allowed(place_);
    start_segment({0.0, std::clamp(place_.sum / place_.count, range.low, range.high)});
  }
  if (place_.u - knots_.back().u < kSameWidthPlace) return;  // the start already meets it

  Range slopes = slopes_through(place_);
  if (std::max(slopes.low, slopes_.low) > std::min(slopes.high, slopes_.high)) {
    close_segment(std::clamp(sum_uw_ / sum_uu_, slopes_.low, slopes_.high));
    slopes = slopes_through(place_);
  }
  slopes_ = {std::max(slopes.low, slopes_.low), std::min(slopes.high, slopes_.high)};
  const double du = place_.u - knots_.back().u;
  sum_uu_ += place_.count * du * du;
  sum_uw_ += du * (place_.sum - place_.count * knots_.back().width_mm);
  reach_ = place_.u;
}

void WidthFitter::forget_from(double u) {
  if (knots_.empty() || reach_ < u) return;
  while (knots_.size() > 1 && knots_.back().u >= u) knots_.pop_back();
  const WidthKnot start = knots_.back();
  knots_.pop_back();
  start_segment(start);
}

void WidthFitter::start_segment(WidthKnot knot) {
  knots_.push_back(knot);
  slopes_ = {-kInfinity, kInfinity};
  sum_uu_ = sum_uw_ = 0.0;
  reach_ = knot.u;
}

void WidthFitter::close_segment(double slope) {
  const WidthKnot start = knots_.back();
  const double end_mm = start.width_mm + slope * (reach_ - start.u);
  start_segment({reach_, std::clamp(end_mm, options_.min_mm, options_.max_mm)});
}

}  // namespace felt
