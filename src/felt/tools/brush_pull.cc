#include "felt/tools/brush_pull.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/base/check.h"
#include "felt/geometry/nearest.h"
#include "felt/stroke/edit/subdivide.h"
#include "felt/tools/handles.h"

namespace felt {
namespace {

constexpr double kPullAccuracy = 1e-7;
/// If the displacement is at most kExactRadii radii, the ink follows the exact displacement within
/// the tolerance. If it is larger, the ink is stretched so much that a proportionally larger error
/// is not visible.
constexpr double kExactRadii = 2.0;
/// At the lift, joints may lie at multiples of 1/k of a segment. Each k of this list is tried, and
/// the result with the fewest segments is used.
constexpr int kFiner[] = {3, 4, 5, 6};
/// Fraction of the tolerance within which the pull follows the exact displacement.
constexpr double kPullShare = 0.2;
/// Maximum number of times that a piece is halved.
constexpr int kMaxRounds = 5;
/// Lengthening the handles of compressed ink moves the grabbed point. Moving this point back may
/// compress another segment, so both steps are repeated up to kMendRounds times.
constexpr int kMendRounds = 4;

double bernstein(const std::array<double, 4>& b, double t) {
  const double s = 1.0 - t;
  return s * s * s * b[0] + 3.0 * t * s * s * b[1] + 3.0 * t * t * s * b[2] + t * t * t * b[3];
}

}  // namespace

BrushPull::BrushPull(StrokePtr snapshot, double u0, const BrushOptions& options)
    : snapshot_(std::move(snapshot)), tolerance_mm_(options.tolerance_mm) {
  const double n = snapshot_->segment_count();
  u0 = u0 >= 0.0 ? std::min(u0, n) : 0.0;
  origin_ = snapshot_->position(u0);
  const ArcMap map(*snapshot_, kPullAccuracy);
  const BrushReach reach = brush_reach(*snapshot_, map, u0, options);
  first_u_ = reach.first_u(map);
  last_u_ = reach.last_u(map);
  base_ = snapshot_->data();
  const auto at = [&](double way) { return map.u_at(reach.grab_mm + way); };
  const std::array places{first_u_, at(-reach.before.held_mm), u0, at(reach.after.held_mm),
                          last_u_};
  cut(places, {});
  if (!reach.is_whole) {
    const double radius = std::max(reach.before.radius_mm, reach.after.radius_mm);
    const double largest_error = kPullShare * tolerance_mm_ / (kExactRadii * radius);
    plan(reach);
    for (int round = 0; round < kMaxRounds; ++round) {
      const std::vector<double> more = crooked(largest_error);
      if (more.empty()) break;
      const Joints& j = joints_;
      cut(std::array<double, 5>{double(j.first), double(j.held_first), double(j.grab),
                                double(j.held_last), double(j.last)},
          more);
      plan(reach);
    }
    for (const Run& run : runs_) give_handles(base_, static_cast<std::size_t>(run.segment));
    plan(reach);
  }
  weigh(reach.is_whole);
  find_grab();
}

Cubic BrushPull::segment(int i) const noexcept {
  const Point* p = &base_.points[3 * static_cast<std::size_t>(i)];
  return {{p[0], p[1], p[2], p[3]}};
}

/// Cuts base_ at the five parameters `places` and at `more`. Stores the joint numbers of `places`
/// in joints_.
void BrushPull::cut(std::span<const double> places, std::span<const double> more) {
  std::vector<std::pair<double, std::size_t>> all;
  for (std::size_t i = 0; i < places.size(); ++i) all.emplace_back(places[i], i);
  for (const double u : more) all.emplace_back(u, places.size());
  std::sort(all.begin(), all.end());
  std::vector<double> us;
  for (const auto& [u, i] : all) us.push_back(u);
  std::vector<int> numbers;
  auto stroke = Stroke::create(base_).and_then(
      [&](const Stroke& base) { return subdivided(base, us, &numbers); });
  if (!stroke) {
    // If the stroke cannot be cut, it is pulled by its existing joints.
    numbers.clear();
    for (const double u : us) numbers.push_back(static_cast<int>(std::lround(u)));
  } else {
    base_ = stroke->data();
  }
  const std::array<int*, 5> named{&joints_.first, &joints_.held_first, &joints_.grab,
                                  &joints_.held_last, &joints_.last};
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].second < named.size()) *named[all[k].second] = numbers[k];
  }
}

/// Computes the influence along the segments of both sides.
void BrushPull::plan(const BrushReach& reach) {
  runs_.clear();
  add_runs(wrapped(joints_.held_first - joints_.first), reach.before, -1.0);
  add_runs(wrapped(joints_.last - joints_.held_last), reach.after, 1.0);
}

void BrushPull::add_runs(int count, const BrushSide& side, double sign) {
  if (side.way_mm <= 0.0) return;
  const auto begin = runs_.size();
  double way = 0.0;
  for (int k = 0; k < count; ++k) {
    const int i = wrapped(sign > 0.0 ? joints_.held_last + k : joints_.held_first - 1 - k);
    runs_.push_back({.segment = i, .sign = sign, .start_mm = way});
    way += arc_length(segment(i), kPullAccuracy);
  }
  // Uses the lengths after the cuts, so that the influence ends exactly at the end of the last
  // segment.
  const double radius = side.radius_mm > side.way_mm ? side.radius_mm : way;
  for (auto r = begin; r < runs_.size(); ++r) {
    Run& run = runs_[r];
    const bool is_last = r + 1 == runs_.size();
    run.radius_mm = radius;
    const Cubic c = sign > 0.0 ? segment(run.segment) : reversed(segment(run.segment));
    const double x0 = run.start_mm / radius;
    const double x1 = (is_last ? way : runs_[r + 1].start_mm) / radius;
    const double w0 = influence(x0), w1 = influence(x1);
    run.weights = {w0, w0 + influence_slope(x0) / radius * distance(c.p[0], c.p[1]),
                   w1 - influence_slope(x1) / radius * distance(c.p[2], c.p[3]), w1};
  }
}

/// Returns the middles of the segments over which the influence differs from a cubic in t by more
/// than `most_error`.
std::vector<double> BrushPull::crooked(double largest_error) const {
  std::vector<double> middles;
  for (const Run& run : runs_) {
    const Cubic c = run.sign > 0.0 ? segment(run.segment) : reversed(segment(run.segment));
    for (const double t : {0.25, 0.5, 0.75}) {
      const double way = run.start_mm + arc_length(c, 0.0, t, kPullAccuracy);
      const double error = influence(way / run.radius_mm) - bernstein(run.weights, t);
      if (std::fabs(error) > largest_error) {
        middles.push_back(run.segment + 0.5);
        break;
      }
    }
  }
  return middles;
}

void BrushPull::weigh(bool is_whole) {
  weights_.assign(base_.points.size(), is_whole ? 1.0 : 0.0);
  if (is_whole) return;
  const auto set = [&](int i, const std::array<double, 4>& w) {
    std::copy(w.begin(), w.end(), weights_.begin() + 3 * i);
  };
  for (const Run& run : runs_) {
    std::array<double, 4> w = run.weights;
    if (run.sign < 0.0) std::reverse(w.begin(), w.end());
    set(run.segment, w);
  }
  const int held = wrapped(joints_.held_last - joints_.held_first);
  for (int k = 0; k < held; ++k) set(wrapped(joints_.held_first + k), {1.0, 1.0, 1.0, 1.0});
  if (base_.closed) {
    const double seam = std::max(weights_.front(), weights_.back());
    weights_.front() = weights_.back() = seam;
  }
}

/// Finds the parameter of the grab. The grab is at a joint unless a cut there would have made a
/// piece that is too short.
void BrushPull::find_grab() {
  const int n = count();
  grab_segment_ = std::min(joints_.grab, n - 1);
  grab_t_ = joints_.grab < n ? 0.0 : 1.0;
  double best = distance_squared(evaluate(segment(grab_segment_), grab_t_), origin_);
  if (best <= 1e-24) return;
  for (const int i : {joints_.grab - 1, joints_.grab}) {
    if (!base_.closed && (i < 0 || i >= n)) continue;
    const Nearest found = nearest(segment(wrapped(i)), origin_);
    if (found.distance_squared < best) {
      best = found.distance_squared;
      grab_segment_ = wrapped(i);
      grab_t_ = found.t;
    }
  }
}

void BrushPull::keep_all_smooth(StrokeData& data) const {
  for (int j = base_.closed ? 0 : 1; j < count(); ++j) {
    if (weights_[3 * static_cast<std::size_t>(j)] == 0.0) continue;
    keep_smooth(data, static_cast<std::size_t>(j), tangent(segment(j), 0.0));
  }
}

/// Moves the joint nearest to the grab, with its handles, so that the curve passes exactly through
/// the target at the grab.
void BrushPull::follow_exactly(StrokeData& data, Point target) const {
  const std::size_t n = data.points.size() / 3;
  const auto i = static_cast<std::size_t>(grab_segment_);
  const Point* p = &data.points[3 * i];
  const Vec rest = target - evaluate(Cubic{{p[0], p[1], p[2], p[3]}}, grab_t_);
  const bool near_start = grab_t_ < 0.5;
  const double t = near_start ? grab_t_ : 1.0 - grab_t_, s = 1.0 - t;
  const Vec shift = rest / (s * s * (s + 3.0 * t));
  const std::size_t j = near_start ? i : i + 1;
  data.points[3 * j] += shift;
  if (j > 0) data.points[3 * j - 1] += shift;
  if (j < n) data.points[3 * j + 1] += shift;
  if (!data.closed || (j > 0 && j < n)) return;
  data.points[j > 0 ? 0 : 3 * n] = data.points[3 * j];
  data.points[j > 0 ? 1 : 3 * n - 1] += shift;
}

void BrushPull::pull(StrokeData& data, Vec displacement) const {
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    if (weights_[k] != 0.0) data.points[k] += weights_[k] * displacement;
  }
  keep_all_smooth(data);
  follow_exactly(data, origin_ + displacement);
  for (int round = 0; round < kMendRounds && keep_lengths(data); ++round) {
    follow_exactly(data, origin_ + displacement);
  }
}

/// Lengthens the handles of segments that are compressed below the length that I5 requires. No
/// point moves by more than the length of the handles. Returns true if it found such a segment.
bool BrushPull::keep_lengths(StrokeData& data) const {
  bool any = false;
  const int n = count();
  for (int i = 0; i < n; ++i) {
    any = keep_length(data, static_cast<std::size_t>(i), segment(i)) || any;
  }
  if (any) keep_all_smooth(data);
  return any;
}

Result<Stroke> BrushPull::at(Vec displacement) const {
  if (displacement == Vec{}) return *snapshot_;
  StrokeData data = base_;
  pull(data, displacement);
  return Stroke::create(std::move(data));
}

Result<Stroke> BrushPull::finished(Vec displacement) const {
  Result<Stroke> pulled = at(displacement);
  if (!pulled || displacement == Vec{}) return pulled;
  Stroke best = *std::move(pulled);
  const Stroke whole = best;
  for (const int finer : kFiner) {
    const auto few = with_free_joints(whole, finer);
    if (few && few->segment_count() < best.segment_count()) best = *few;
  }
  return best;
}

/// Returns the stroke with as few segments as the tolerance allows. Candidate joints divide each
/// existing segment into `finer` parts.
Result<Stroke> BrushPull::with_free_joints(const Stroke& pulled, int finer) const {
  const int n = pulled.segment_count();
  const int span = wrapped(joints_.last - joints_.first);
  std::vector<bool> is_cut(static_cast<std::size_t>(n), false);
  for (int k = 0; k < (span > 0 ? span : n); ++k) {
    is_cut[static_cast<std::size_t>(wrapped(joints_.first + k))] = true;
  }
  // If the grab is inside a segment, that segment is kept.
  const bool is_within = grab_t_ > 0.0 && grab_t_ < 1.0;
  if (is_within) is_cut[static_cast<std::size_t>(grab_segment_)] = false;
  std::vector<double> us;
  for (int i = 0; i <= n; ++i) {
    us.push_back(i);
    if (i == n || !is_cut[static_cast<std::size_t>(i)]) continue;
    for (int k = 1; k < finer; ++k) us.push_back(i + static_cast<double>(k) / finer);
  }
  std::vector<int> numbers;
  auto fine = subdivided(pulled, us, &numbers);
  if (!fine) return fine;
  const auto now = [&](int joint) {
    const auto at = std::lower_bound(us.begin(), us.end(), static_cast<double>(joint));
    return numbers[static_cast<std::size_t>(at - us.begin())];
  };
  std::vector<int> keep;
  if (is_within) keep = {now(grab_segment_), now(grab_segment_ + 1)};
  return with_fewer_segments(*fine, now(joints_.first), now(joints_.last), tolerance_mm_, keep,
                             is_within ? -1 : now(joints_.grab));
}

}  // namespace felt
