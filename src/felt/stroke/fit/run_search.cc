#include "felt/stroke/fit/run_search.h"

#include <algorithm>
#include <cmath>

#include "felt/stroke/stroke.h"

namespace felt {
namespace {

// Number of gate updates in one step. They take about as long as a small exact fit.
constexpr std::size_t kGateStep = 32;
// The gate tests only runs of at least this many samples, because a cubic fits any smaller number.
constexpr std::size_t kGateMin = 4;

std::size_t longer(std::size_t count) {
  return count + std::max<std::size_t>(1, count / 4);
}

}  // namespace

void RunSearch::begin(const SampleWindow& window, const RunStart& start,
                      std::size_t first) noexcept {
  start_ = start;
  first_ = first;
  if (start.kind == RunStart::Kind::kFree) start_.point = window.point(first);
  if (start.kind == RunStart::Kind::kTangent) {
    moments_.begin(start_.point, start_.tangent);
  } else {
    moments_.begin(start_.point);
  }
  lead_mm_ = distance(start_.point, window.point(first));
  tightest_ = 0.0;
  gated_ = proven_ = good_ = next_ = bad_ = 0;
  is_close_to_guide_ = true;
  phase_ = Phase::kGate;
}

// Returns the minimum number of samples of a run. A run with a free start needs two samples to
// define a curve.
std::size_t RunSearch::min_count() const noexcept {
  return start_.kind == RunStart::Kind::kFree ? 2 : 1;
}

RunSearch::Status RunSearch::step(const SampleWindow& window, std::size_t limit,
                                  bool is_final) noexcept {
  std::size_t available = limit - first_;
  if (available >= SegmentFit::kMaxRun) {
    available = SegmentFit::kMaxRun;
    is_final = true;
  }
  offered_ = available;
  switch (phase_) {
    case Phase::kGate:
      return run_gate(window, available, is_final);
    case Phase::kGallop:
      return run_gallop(window, available, is_final);
    case Phase::kBisect:
      return run_bisect(window);
    case Phase::kDone:
      break;
  }
  return Status::kDone;
}

RunSearch::Status RunSearch::run_gate(const SampleWindow& window, std::size_t available,
                                      bool is_final) noexcept {
  for (std::size_t added = 0; gated_ < available && added < kGateStep; ++added) {
    const std::size_t i = first_ + gated_;
    moments_.add(window.point(i), lead_mm_ + (window.path_mm(i) - window.path_mm(first_)));
    tightest_ = std::max(tightest_, window.inverse_limit()[i]);
    ++gated_;
    if (gated_ < kGateMin) continue;
    if (!(moments_.residual() * tightest_ <= 1.0)) {
      phase_ = Phase::kGallop;
      next_ = gated_;
      return Status::kBusy;
    }
    proven_ = gated_;
  }
  if (gated_ < available) return Status::kBusy;
  if (!is_final) return Status::kNeedSamples;
  phase_ = Phase::kGallop;
  next_ = available;
  return Status::kBusy;
}

RunSearch::Status RunSearch::run_gallop(const SampleWindow& window, std::size_t available,
                                        bool is_final) noexcept {
  if (next_ > available) {
    if (!is_final) return Status::kNeedSamples;
    next_ = available;
  }
  if (try_count(window, next_)) {
    if (is_final && good_ == available) {
      phase_ = Phase::kDone;
      return Status::kDone;
    }
    next_ = window.is_thinned() ? SegmentFit::kMaxRun : longer(good_);
    return Status::kBusy;
  }
  bad_ = next_;
  phase_ = Phase::kBisect;
  return Status::kBusy;
}

RunSearch::Status RunSearch::run_bisect(const SampleWindow& window) noexcept {
  const std::size_t smallest = min_count();
  if (bad_ <= smallest) {
    bridge(window);
    phase_ = Phase::kDone;
    return Status::kDone;
  }
  if (good_ > 0 && bad_ - good_ <= std::max<std::size_t>(1, good_ / 16)) {
    phase_ = Phase::kDone;
    return Status::kDone;
  }
  std::size_t middle = (good_ + bad_) / 2;
  // Tries the longest run that the gate has proven first, because a fit of it usually succeeds.
  if (proven_ > good_ && proven_ < bad_) middle = proven_;
  middle = std::max(middle, smallest);
  if (!try_count(window, middle)) bad_ = middle;
  return Status::kBusy;
}

bool RunSearch::try_count(const SampleWindow& window, std::size_t count) noexcept {
  if (count < min_count()) return false;
  if (!fit_.fit(window, start_, first_, count, SegmentFit::End::kFree, known(window))) return false;
  keep_fit(count);
  return true;
}

std::span<const double> RunSearch::known(const SampleWindow& window) const noexcept {
  return window.is_thinned() ? parameters() : std::span<const double>{};
}

void RunSearch::keep_fit(std::size_t count) noexcept {
  good_ = count;
  curve_ = fit_.curve();
  std::copy(fit_.parameters().begin(), fit_.parameters().end(), t_.begin());
}

// Called if not even the shortest run is accepted, for example at a hairpin inside the tolerance
// band. Goes straight to the first sample that is far enough for a segment.
void RunSearch::bridge(const SampleWindow& window) noexcept {
  std::size_t count = min_count();
  const auto is_at_start = [&](std::size_t i) {
    const double squared = distance_squared(start_.point, window.point(i));
    return squared < kShortestSegmentMm * kShortestSegmentMm &&
           squared * window.inverse_limit()[i] <= 1.0;
  };
  while (count < offered_ && is_at_start(first_ + count - 1)) ++count;
  count = std::min(count, offered_);
  fit_.bridge(window, start_, first_, count);
  is_close_to_guide_ = fit_.follows_guide(window);
  keep_fit(count);
}

void RunSearch::pin(const SampleWindow& window, bool start, bool end) noexcept {
  start = start && start_.kind == RunStart::Kind::kFree && good_ >= 2;
  const RunStart pinned = {RunStart::Kind::kPoint, window.point(first_), {}};
  const auto attempt = [&](bool at_start, bool at_end) {
    const RunStart& from = at_start ? pinned : start_;
    if (!fit_.fit(window, from, first_, good_,
                  at_end ? SegmentFit::End::kPinned : SegmentFit::End::kFree, known(window)))
      return false;
    if (control_length(fit_.curve()) < kShortestSegmentMm) return false;
    is_close_to_guide_ = true;
    if (at_start) start_ = pinned;
    keep_fit(good_);
    return true;
  };
  if (start && end && attempt(true, true)) return;
  if (start && attempt(true, false)) return;
  if (end) attempt(false, true);
}

void RunSearch::thin(SampleWindow& window) noexcept {
  std::array<double, SegmentFit::kMaxRun> left, right;
  for (std::size_t i = 0; i < good_; ++i) {
    const Vec away = window.point(i) - evaluate(curve_, t_[i]);
    const double offset = std::copysign(norm(away), cross(derivative(curve_, t_[i]), away));
    const double slack = window.tolerance_mm() - 1.0 / std::sqrt(window.inverse_limit()[i]);
    left[i] = offset - slack;
    right[i] = offset + slack;
  }
  window.thin(left.data(), right.data(), t_.data());
  const bool is_gated = proven_ == good_;
  good_ = window.size();
  gated_ = proven_ = is_gated ? good_ : 0;
  phase_ = is_gated ? Phase::kGate : Phase::kGallop;
  next_ = SegmentFit::kMaxRun;
  bad_ = 0;
}

void RunSearch::ensure_length(const SampleWindow& window) noexcept {
  if (control_length(curve_) < kShortestSegmentMm) bridge(window);
}

}  // namespace felt
