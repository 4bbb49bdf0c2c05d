#include "felt/stroke/fit/segment_fit.h"

#include <algorithm>

#include "felt/geometry/polyline.h"
#include "felt/stroke/fit/guide_curve.h"
#include "felt/stroke/fit/normal_equations.h"
#include "felt/stroke/fit/segment_fit_kernels.h"
#include "felt/stroke/stroke.h"

namespace felt {
namespace {

// From this round on, a fit that does not converge fast enough is abandoned.
constexpr int kGiveUpRound = 2;
// Fraction of the tolerance by which a curve may leave its guide at the points compared; the rest
// of the tolerance is left for the curve between these points.
constexpr double kGuideShare = 0.95;
// Weight of a pinned end sample, relative to the mean of all.
constexpr double kPinWeight = 1e6;
// Minimum weight of an end sample, relative to all samples together.
constexpr double kEndShare = 0.02;

detail::PowerCubic power_form(const Cubic& c, Point origin) noexcept {
  const Vec b1 = c.p[0] - origin, b2 = c.p[1] - origin, b3 = c.p[2] - origin, b4 = c.p[3] - origin;
  return {b1, 3.0 * (b2 - b1), 3.0 * ((b3 - b2) - (b2 - b1)), (b4 - b1) - 3.0 * (b3 - b2)};
}

detail::RunView view(const SampleWindow& w, std::size_t first, std::size_t count, Point origin) {
  return {w.x() + first,      w.y() + first, w.inverse_limit() + first,
          w.weight() + first, count,         origin};
}

// Returns true if the error would reach its limit by shrinking in each remaining round by the same
// factor as in the last one. Convergence slows down over time, so hardly any fit is abandoned that
// would have succeeded.
bool may_arrive(double worst, double before, int rounds_left) noexcept {
  const double factor = worst / before;
  if (factor >= 1.0) return false;
  for (; rounds_left > 0 && worst > 1.0; --rounds_left) worst *= factor;
  return worst <= 1.0;
}

}  // namespace

// The first solution is ordinary least squares (tangent weight 1), because the metric needs a
// curve. Each round then moves the parameters to the foot points and tests the curve. If it is not
// accepted, the next solution uses the metric of that curve.
bool SegmentFit::fit(const SampleWindow& window, const RunStart& start, std::size_t first,
                     std::size_t count, End end, std::span<const double> known) noexcept {
  start_ = start;
  first_ = first;
  count_ = count;
  if (start.kind == RunStart::Kind::kFree) start_.point = window.point(first);
  if (!initialise(window, known) || !solve(window, 1.0, end)) return false;
  double before = 1e300;
  for (int round = 0;; ++round) {
    work_ += static_cast<long>(count);
    const double worst = place(window);
    if (worst <= 1.0 && gaps_are_tame(window) && follows_guide(window)) {
      for (std::size_t i = 1; i < count_; ++i) t_[i] = std::max(t_[i], t_[i - 1]);
      return true;
    }
    if (round == kMaxRounds) return false;
    if (round >= kGiveUpRound && !may_arrive(worst, before, kMaxRounds - round)) return false;
    before = worst;
    if (!solve(window, kTangentWeight, end)) return false;
  }
}

// Sets the parameters to the known ones, or in proportion to chord lengths. Returns false if all
// samples coincide with the start.
bool SegmentFit::initialise(const SampleWindow& window, std::span<const double> known) noexcept {
  const double begin = window.path_mm(first_);
  const double lead = distance(start_.point, window.point(first_));
  curve_ = {};  // the metric must not depend on an earlier run
  length_mm_ = lead + (window.path_mm(first_ + count_ - 1) - begin);
  if (!(length_mm_ > 0.0)) return false;
  const double scale = 1.0 / length_mm_;
  for (std::size_t i = 0; i < count_; ++i) {
    t_[i] = (lead + (window.path_mm(first_ + i) - begin)) * scale;
  }
  if (!known.empty()) {
    const double shrink = t_[known.size() - 1];
    for (std::size_t i = 0; i < known.size(); ++i) t_[i] = shrink * known[i];
  }
  t_[count_ - 1] = 1.0;
  return true;
}

// Solves the least-squares problem at the current parameters; the metric comes from the current
// curve.
bool SegmentFit::solve(const SampleWindow& window, double tangent_weight, End end) noexcept {
  const detail::RunView run = view(window, first_, count_, start_.point);
  const detail::PowerCubic power = power_form(curve_, start_.point);
  const Vec last = window.point(first_ + count_ - 1) - start_.point;
  const double* weights = run.weight;
  double weight = 0.0;
  for (std::size_t i = 0; i < count_; ++i) weight += weights[i];
  // Samples determine the curve mainly across its direction. Along its direction, only the end
  // sample determines it, so the weight of the end sample grows with the number of samples.
  const double smallest = kEndShare * weight;
  const double end_weight = end == End::kPinned ? kPinWeight * weight / static_cast<double>(count_)
                                                : std::max(smallest, weights[count_ - 1]);
  detail::NormalSums sums;  // uninitialised: every value that is read is written first
  detail::Priors priors{weight * kEnergy, weight * kRidge, last, length_mm_};
  switch (start_.kind) {
    case RunStart::Kind::kFree:
      detail::accumulate_free_start(power, run, t_.data(), 1, count_ - 1, tangent_weight, sums);
      detail::add_end_sample(sums, 0, Vec{}, std::max(smallest, weights[0]));
      detail::add_end_sample(sums, 3, last, end_weight);
      if (!detail::solve_free(sums, priors, start_.point, curve_)) return false;
      break;
    case RunStart::Kind::kPoint:
      detail::accumulate_fixed_start(power, run, t_.data(), 0, count_ - 1, tangent_weight, sums);
      detail::add_end_sample(sums, 2, last, end_weight);
      if (!detail::solve_point(sums, priors, start_.point, curve_)) return false;
      break;
    case RunStart::Kind::kTangent:
      detail::accumulate_fixed_start(power, run, t_.data(), 0, count_ - 1, tangent_weight, sums);
      detail::add_end_sample(sums, 2, last, end_weight);
      if (!detail::solve_tangent(sums, priors, start_.point, start_.tangent, curve_)) return false;
      break;
  }
  if (end == End::kPinned) {
    // Because of the large weight, only a rounding error is left. B3 moves by the same amount as
    // B4.
    const Vec shift = window.point(first_ + count_ - 1) - curve_.p[3];
    curve_.p[2] += shift;
    curve_.p[3] = window.point(first_ + count_ - 1);
  }
  return is_finite(curve_.p[1]) && is_finite(curve_.p[2]) && is_finite(curve_.p[3]);
}

// Moves the parameters to the foot points. Returns the largest ratio of a squared distance to its
// limit, with each sample measured at a parameter not less than those of the samples before it.
double SegmentFit::place(const SampleWindow& window) noexcept {
  const detail::PowerCubic power = power_form(curve_, start_.point);
  const std::size_t last = count_ - 1;
  detail::project(power, view(window, first_, count_, start_.point), t_.data(), ratio_.data());
  const auto measure = [&](std::size_t i, double t) {
    const Vec e = (evaluate(curve_, t) - window.point(first_ + i));
    return norm_squared(e) * window.inverse_limit()[first_ + i];
  };
  // The end samples of the run have the parameters of the ends of the curve.
  if (start_.kind == RunStart::Kind::kFree) {
    t_[0] = 0.0;
    ratio_[0] = measure(0, 0.0);
  }
  t_[last] = 1.0;
  ratio_[last] = measure(last, 1.0);
  double worst = 0.0, furthest = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    if (t_[i] < furthest) {
      ratio_[i] = measure(i, furthest);
    } else {
      furthest = t_[i];
    }
    worst = std::max(worst, ratio_[i]);
  }
  return worst;
}

bool SegmentFit::gaps_are_tame(const SampleWindow& window) const noexcept {
  const double tolerance = window.tolerance_mm();
  double t0 = 0.0;
  Point p0 = start_.point;
  for (std::size_t i = 0; i < count_; ++i) {
    const double t1 = std::max(t_[i], t0);
    const Point p1 = window.point(first_ + i);
    const double allowed = tolerance + kGapBulge * distance(p0, p1);
    const auto is_tame = [&](double part) {
      const Point between = evaluate(curve_, t0 + part * (t1 - t0));
      return nearest_on_line(p0, p1, between).distance_squared <= allowed * allowed;
    };
    if (t1 > t0 && !is_tame(0.5)) return false;
    if (t1 - t0 > 0.15 && (!is_tame(0.25) || !is_tame(0.75))) return false;
    t0 = t1;
    p0 = p1;
  }
  return true;
}

// Returns true if the curve stays within the tolerance of the guide, at the samples and between
// them.
bool SegmentFit::follows_guide(const SampleWindow& window) const noexcept {
  if (guide_ == nullptr || guide_->empty()) return true;
  const double limit = kGuideShare * window.tolerance_mm();
  double t0 = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const double t1 = std::max(t_[i], t0);
    if (!guide_->is_close_at(window.source(first_ + i), evaluate(curve_, t1), limit)) return false;
    const std::size_t source = window.source(first_ + i);
    if (source > 0 && t1 > t0) {
      const auto at = [&](double part) { return evaluate(curve_, t0 + part * (t1 - t0)); };
      const Point stretch[] = {at(0.0), at(0.25), at(0.5), at(0.75), at(1.0)};
      const std::size_t before = i > 0 ? window.source(first_ + i - 1) : source - 1;
      if (!guide_->is_close_between(before, source, stretch, limit)) return false;
    }
    t0 = t1;
  }
  return true;
}

void SegmentFit::bridge(const SampleWindow& window, const RunStart& start, std::size_t first,
                        std::size_t count) noexcept {
  start_ = start;
  first_ = first;
  count_ = count;
  if (start.kind == RunStart::Kind::kFree) start_.point = window.point(first);
  const Point end = window.point(first + count - 1);
  const double reach = distance(start_.point, end);
  curve_ = straight(start_.point, end);
  if (start_.kind == RunStart::Kind::kTangent || reach < kShortestSegmentMm) {
    // The handle makes the segment long enough (I5) even if the pen returned to its start.
    Vec along =
        start_.kind == RunStart::Kind::kTangent ? start_.tangent : normalized(end - start_.point);
    if (along == Vec{}) along = {1.0, 0.0};
    curve_.p[1] = start_.point + std::max(reach / 3.0, kShortestSegmentMm) * along;
    curve_.p[2] = lerp(curve_.p[1], end, 0.5);
  }
  for (std::size_t i = 0; i < count; ++i) t_[i] = 0.0;
  t_[count - 1] = 1.0;
}

}  // namespace felt
