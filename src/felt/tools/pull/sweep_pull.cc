#include "felt/tools/pull/sweep_pull.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "felt/geometry/nearest.h"
#include "felt/tools/pull/refit.h"

namespace felt {
namespace {

/// Pieces are divided only if they are longer than kTooLong times kPieceMm, so that new pieces are
/// not divided again immediately.
constexpr double kTooLong = 1.5;

}  // namespace

SweepPull::SweepPull(StrokePtr snapshot, double u0, WeightKind weights)
    : strand_(std::move(snapshot)), weights_(weights) {
  place_ = strand_.locate(std::clamp(u0, 0.0, strand_.snapshot_u(strand_.count())));
}

Point SweepPull::point() const noexcept {
  return evaluate(strand_.segment(place_.segment), place_.t);
}

CurveNear SweepPull::near() const noexcept {
  const auto [i, t] = place_;
  const Cubic c = strand_.segment(i);
  const bool is_end = (t <= 0.0 && strand_.joint(i) != JointKind::kSmooth) ||
                      (t >= 1.0 && strand_.joint(i + 1) != JointKind::kSmooth);
  return {.curve = point(), .normal = perp(tangent(c, t)), .is_end = is_end};
}

void SweepPull::track(Point pen) {
  const int here = place_.segment;
  double best = std::numeric_limits<double>::infinity();
  for (const int i : {strand_.previous(here), here, strand_.next(here)}) {
    if (i < 0) continue;
    const Nearest near = nearest(strand_.segment(i), pen);
    if (near.distance_squared >= best) continue;
    best = near.distance_squared;
    place_ = {i, near.t};
  }
}

void SweepPull::keep_short() {
  const double from = strand_.snapshot_u(place_.segment);
  const double u = from + place_.t * (strand_.snapshot_u(place_.segment + 1) - from);
  std::array<int, 3> parts{strand_.previous(place_.segment), place_.segment,
                           strand_.next(place_.segment)};
  // The highest numbers come first, so that the other numbers stay valid.
  std::sort(parts.rbegin(), parts.rend());
  const auto end = std::unique(parts.begin(), parts.end());
  for (auto i = parts.begin(); i != end; ++i) {
    if (*i < 0 || strand_.count() >= kMaxSegments) continue;
    // The arc is at most as long as its control polygon.
    if (control_length(strand_.segment(*i)) <= kTooLong * kPieceMm) continue;
    strand_.divide_evenly(*i, kPieceMm, kMaxSegments - strand_.count() + 1);
  }
  place_ = strand_.locate(u);
}

bool SweepPull::step(Point pen, double part) {
  const Point was = point();
  track(pen);
  keep_short();
  track(pen);
  if (distance(was, point()) > kLeapMm) ++leaps_;
  const auto [i, t] = place_;
  const Vec pull = part * (pen - point());
  if (pull == Vec{}) return false;
  strand_.prepare(i);
  const EditWeights weights = edit_weights(weights_, t, strand_.compliance(i, t, true));
  if (!strand_.bend(i, t, weights, pull)) return false;
  for (const int k : {strand_.previous(i), i, strand_.next(i)}) {
    if (k >= 0) strand_.limit_handles(k, kLongestHandle);
  }
  return true;
}

Result<Stroke> SweepPull::finished() const {
  return with_good_shapes(strand_);
}

}  // namespace felt
