#include "felt/stroke/fit/long_run.h"

#include <algorithm>

namespace felt {
namespace {

// Newton steps from the interpolated guess to the foot point.
constexpr int kFootSteps = 2;

}  // namespace

void LongRun::begin(const KeptSamples& kept, const RunStart& start, std::size_t first,
                    Detail detail) noexcept {
  detail_ = detail;
  start_ = start;
  first_ = first;
  held_count_ = 0;
  restart(kept);
}

bool LongRun::search_again(const KeptSamples& kept, std::size_t a, std::size_t b) noexcept {
  if (held_count_ + 2 > kMaxHeld) return false;
  held_[held_count_++] = a;
  held_[held_count_++] = b;
  restart(kept);
  return true;
}

void LongRun::restart(const KeptSamples& kept) noexcept {
  next_ = first_;
  window_.clear();
  add_next(kept);
  search_.begin(window_, start_, 0);
}

void LongRun::add_next(const KeptSamples& kept) noexcept {
  window_.add(kept, next_);
  const auto held = std::span(held_).first(held_count_);
  if (std::find(held.begin(), held.end(), next_) != held.end()) window_.hold_newest();
  ++next_;
}

RunSearch::Status LongRun::step(const KeptSamples& kept, std::size_t limit,
                                bool is_final) noexcept {
  while (next_ < limit && window_.size() < window_.capacity()) add_next(kept);
  const bool is_all = next_ == limit && is_final;
  const RunSearch::Status status = search_.step(window_, window_.size(), is_all);
  if (status != RunSearch::Status::kDone) return status;
  if (detail_ == Detail::kEverySample || is_all || count() < window_.capacity()) return status;
  if (next_ == limit) return RunSearch::Status::kNeedSamples;
  search_.thin(window_);
  return RunSearch::Status::kBusy;
}

void RunPlacer::begin(const LongRun& run, const Cubic& curve, double end) noexcept {
  curve_ = curve;
  scale_ = end > 0.0 ? 1.0 / end : 1.0;
  next_ = run.first();
  in_window_ = 0;
  furthest_ = 0.0;
  furthest_sample_ = next_;
}

// A sample of the window already has the parameter of the fit. If a sample was left out, its
// parameter is guessed from its neighbours in the window. For samples in the window, the fit has
// proven the distance if the parameters are in order. For all other samples, the distance is
// checked here.
std::optional<double> RunPlacer::place(const LongRun& run, const KeptSamples& kept) noexcept {
  const bool was_fitted = run.source(in_window_) == next_;
  const Point p = kept.point(next_);
  const double foot =
      was_fitted ? std::min(1.0, run.parameters()[in_window_] * scale_) : foot_between(run, p);
  const bool is_proven = was_fitted && foot >= furthest_;
  if (foot >= furthest_) furthest_sample_ = next_;
  furthest_ = std::max(furthest_, foot);
  if (!is_proven &&
      distance_squared(evaluate(curve_, furthest_), p) * kept.inverse_limit(next_) > 1.0) {
    return std::nullopt;
  }
  if (was_fitted) ++in_window_;
  ++next_;
  return furthest_;
}

// The first and the last sample of a run are always in the window.
double RunPlacer::foot_between(const LongRun& run, Point p) const noexcept {
  const auto before = static_cast<double>(run.source(in_window_ - 1));
  const auto after = static_cast<double>(run.source(in_window_));
  const double share = (static_cast<double>(next_) - before) / (after - before);
  const std::span<const double> t = run.parameters();
  double foot = (t[in_window_ - 1] + share * (t[in_window_] - t[in_window_ - 1])) * scale_;
  for (int k = 0; k < kFootSteps; ++k) {
    const Vec speed = derivative(curve_, foot);
    const double squared = norm_squared(speed);
    if (!(squared > 0.0)) break;
    foot = std::clamp(foot - dot(evaluate(curve_, foot) - p, speed) / squared, 0.0, 1.0);
  }
  return foot;
}

}  // namespace felt
