#include "felt/stroke/fit/kept_samples.h"

#include <algorithm>
#include <cmath>

namespace felt {

KeptSamples::KeptSamples(double tolerance_mm, double spacing_mm)
    : tolerance_mm_((1.0 - kReserve) * tolerance_mm), spacing_squared_(spacing_mm * spacing_mm) {}

bool KeptSamples::add(Point p) {
  newest_ = p;
  Sample sample;
  sample.point = p;
  set_slack(sample, 0.0);
  if (!samples_.empty()) {
    Sample& last = samples_.back();
    const double squared = distance_squared(last.point, p);
    if (squared <= spacing_squared_) {
      merge(p, squared);
      return false;
    }
    sample.path_mm = last.path_mm + std::sqrt(squared);
    share_open(sample);
  }
  settled_slack_ = sample.slack;
  open_count_ = 0;
  samples_.push_back(sample);
  return true;
}

void KeptSamples::set_slack(Sample& sample, double slack) const noexcept {
  const double limit = tolerance_mm_ - slack;
  sample.slack = slack;
  sample.inverse_limit = 1.0 / (limit * limit);
}

void KeptSamples::merge(Point p, double squared) noexcept {
  Sample& last = samples_.back();
  ++last.count;
  if (squared > last.slack * last.slack) set_slack(last, std::sqrt(squared));
  if (open_count_ == kMaxOpen) {
    settled_slack_ = last.slack;
    open_count_ = 0;
  }
  open_[open_count_++] = p;
}

// Divides the open samples between the newest kept sample, which gets the first of them, and the
// next one, so that the larger of their slacks is as small as possible.
void KeptSamples::share_open(Sample& next) noexcept {
  Sample& last = samples_.back();
  double before = last.slack;
  double after = 0.0;
  std::size_t first = open_count_;  // the open samples from this index on belong to `next`
  while (first > 0) {
    const double slack = std::max(after, distance(open_[first - 1], next.point));
    if (slack >= before) break;
    after = slack;
    --first;
    before = settled_slack_;
    for (std::size_t i = 0; i < first; ++i) {
      before = std::max(before, distance(open_[i], last.point));
    }
  }
  const auto moved = static_cast<std::uint32_t>(open_count_ - first);
  if (moved == 0) return;
  last.count -= moved;
  next.count += moved;
  set_slack(last, before);
  set_slack(next, after);
}

}  // namespace felt
