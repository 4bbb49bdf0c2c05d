#include "felt/render/plot_trace.h"

#include <algorithm>
#include <cmath>

#include "felt/base/check.h"

namespace felt {
namespace {

void extend(PlotTrace::Stretch& stretch, const PlotTrace::Stretch& other) noexcept {
  if (other.empty()) return;
  if (stretch.empty()) {
    stretch = other;
  } else {
    stretch = {std::min(stretch.low, other.low), std::max(stretch.high, other.high)};
  }
}

}  // namespace

PlotTrace::PlotTrace(double start_s, double step_s, std::size_t capacity)
    : start_s_(start_s), step_s_(step_s), capacity_(capacity) {
  FELT_CHECK(capacity >= 2 && capacity % 2 == 0);
}

void PlotTrace::add(double value) {
  FELT_CHECK(capacity_ > 0);
  if (stretches_.empty() || in_last_ == per_stretch_) {
    if (stretches_.size() == capacity_) halve();
    stretches_.emplace_back();
    in_last_ = 0;
  }
  ++in_last_;
  if (std::isfinite(value)) extend(stretches_.back(), {value, value});
}

void PlotTrace::halve() {
  for (std::size_t i = 0; i < capacity_ / 2; ++i) {
    stretches_[i] = merged(2 * i, 2 * i + 2);
  }
  stretches_.resize(capacity_ / 2);
  per_stretch_ *= 2;
}

PlotTrace::Stretch PlotTrace::merged(std::size_t begin, std::size_t end) const noexcept {
  Stretch all;
  for (std::size_t i = begin; i < end; ++i) extend(all, stretches_[i]);
  return all;
}

PlotTrace::Stretch PlotTrace::range(double from_s, double to_s) const noexcept {
  Stretch all;
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    if (time_s(i + 1) > from_s && time_s(i) < to_s) extend(all, stretches_[i]);
  }
  return all;
}

}  // namespace felt
