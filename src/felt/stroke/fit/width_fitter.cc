#include "felt/stroke/fit/width_fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace felt {
namespace {

// Part of the tolerance reserved for rounding in the interpolation between knots.
constexpr double kRounding = 1e-12;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

void WidthFitter::Values::add(double value) noexcept {
  smallest = std::min(smallest, value);
  largest = std::max(largest, value);
  sum += value;
  last = value;
}

WidthFitter::Range WidthFitter::Channel::allowed() const noexcept {
  const double low = here.largest - tolerance, high = here.smallest + tolerance;
  if (low > high) {
    const double middle = 0.5 * (here.smallest + here.largest);
    return {middle, middle};
  }
  // Clamps to the limits of the stroke model too, so that every knot is within them (I4, I7).
  return {std::max(low, min), std::min(high, max)};
}

WidthFitter::Range WidthFitter::Channel::slopes_through(double du) const noexcept {
  const Range range = allowed();
  return {(range.low - from) / du, (range.high - from) / du};
}

bool WidthFitter::Channel::can_reach(double du) const noexcept {
  const Range through = slopes_through(du);
  return std::max(through.low, slopes.low) <= std::min(through.high, slopes.high);
}

double WidthFitter::Channel::first(double count) const noexcept {
  const Range range = allowed();
  return std::clamp(here.sum / count, range.low, range.high);
}

double WidthFitter::Channel::end_at_best(double du, double sum_uu) const noexcept {
  return std::clamp(from + std::clamp(sum_uw / sum_uu, slopes.low, slopes.high) * du, min, max);
}

double WidthFitter::Channel::end_at_last(double du) const noexcept {
  const double slope = std::clamp((here.last - from) / du, slopes.low, slopes.high);
  return std::clamp(from + slope * du, min, max);
}

void WidthFitter::Channel::start(double value) noexcept {
  from = value;
  slopes = {-kInfinity, kInfinity};
  sum_uw = 0.0;
}

void WidthFitter::Channel::take(double du, double count) noexcept {
  const Range through = slopes_through(du);
  slopes = {std::max(through.low, slopes.low), std::min(through.high, slopes.high)};
  sum_uw += du * (here.sum - count * from);
}

WidthFitter::WidthFitter(const WidthFitOptions& options)
    : width_{.min = std::max(options.min_mm, kMinWidthMm),
             .max = std::max(options.max_mm, std::max(options.min_mm, kMinWidthMm)),
             .tolerance = std::max(options.tolerance_mm - kRounding, 0.0)},
      tone_{
          .min = 0.0, .max = 1.0, .tolerance = std::max(options.tone_tolerance - kRounding, 0.0)} {
  knots_.reserve(256);
}

void WidthFitter::begin() noexcept {
  knots_.clear();
  place_u_ = count_ = 0.0;
  has_tone_ = false;
}

void WidthFitter::push(double u, double width_mm) {
  collect(u, width_mm, tone_of_width(width_mm));
}

void WidthFitter::push(double u, double width_mm, double tone) {
  if (!std::isfinite(tone)) return;
  has_tone_ = true;
  collect(u, width_mm, tone);
}

void WidthFitter::collect(double u, double width_mm, double tone) {
  if (!std::isfinite(u) || !std::isfinite(width_mm)) return;
  const double w = std::clamp(width_mm, width_.min, width_.max);
  const double share = std::clamp(tone, 0.0, 1.0);
  u = std::max(u, place_u_);
  if (count_ > 0.0 && u - place_u_ >= kSameWidthPlace) {
    take_place();
    count_ = 0.0;
  }
  if (count_ == 0.0) {
    place_u_ = u;
    width_.here.start(w);
    tone_.here.start(share);
  }
  width_.here.add(w);
  tone_.here.add(share);
  count_ += 1.0;
}

void WidthFitter::finish(double u_end) {
  if (count_ == 0.0) {
    knots_.assign({{0.0, width_.min}, {u_end, width_.min}});
    return;
  }
  if (u_end - place_u_ < kSameWidthPlace) place_u_ = u_end;
  forget_from(u_end);
  take_place();
  const double span = reach_ - knots_.back().u;
  if (span > 0.0) {
    start_segment(knot(reach_, width_.end_at_last(span), tone_.end_at_last(span)));
  }
  // Width and tone are constant after the last sample.
  if (WidthKnot end = knots_.back(); end.u < u_end) {
    end.u = u_end;
    knots_.push_back(end);
  }
}

WidthKnot WidthFitter::open_end() const noexcept {
  const double span = reach_ - knots_.back().u;
  if (span <= 0.0) return knots_.back();
  return knot(reach_, width_.end_at_best(span, sum_uu_), tone_.end_at_best(span, sum_uu_));
}

// Adds the samples collected at one position. If no slope of the open segment reaches them, that
// segment ends at the previous position, and the next segment starts there.
void WidthFitter::take_place() {
  if (knots_.empty()) start_segment(knot(0.0, width_.first(count_), tone_.first(count_)));
  double du = place_u_ - knots_.back().u;
  if (du < kSameWidthPlace) return;  // the segment starts at this position

  if (!width_.can_reach(du) || (has_tone_ && !tone_.can_reach(du))) {
    start_segment(open_end());
    du = place_u_ - knots_.back().u;
  }
  width_.take(du, count_);
  if (has_tone_) tone_.take(du, count_);
  sum_uu_ += count_ * du * du;
  reach_ = place_u_;
}

// If samples at or beyond `u` were added, removes all knots at or beyond `u`, and restarts the
// segment before these knots without its samples.
void WidthFitter::forget_from(double u) {
  if (knots_.empty() || reach_ < u) return;
  while (knots_.size() > 1 && knots_.back().u >= u) knots_.pop_back();
  const WidthKnot start = knots_.back();
  knots_.pop_back();
  start_segment(start);
}

void WidthFitter::start_segment(WidthKnot knot) {
  knots_.push_back(knot);
  width_.start(knot.width_mm);
  tone_.start(knot.tone);
  sum_uu_ = 0.0;
  reach_ = knot.u;
}

WidthKnot WidthFitter::knot(double u, double width_mm, double tone) const noexcept {
  return {u, width_mm, has_tone_ ? tone : tone_of_width(width_mm)};
}

}  // namespace felt
