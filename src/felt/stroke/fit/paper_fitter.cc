#include "felt/stroke/fit/paper_fitter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "felt/base/check.h"

namespace felt {
namespace {

bool long_enough(Point a, Point b) {
  return distance(a, b) >= kMinSegmentMm;
}

// Returns the unit direction of the curve at its end. If a handle has length zero, the next control
// point decides.
Vec end_direction(const Cubic& c) {
  for (const std::size_t i : {2u, 1u, 0u}) {
    if (c.p[i] != c.p[3]) return normalized(c.p[3] - c.p[i]);
  }
  return {};
}

Vec start_direction(const Cubic& c) {
  return -end_direction({{c.p[3], c.p[2], c.p[1], c.p[0]}});
}

JointKind joint_between(const Cubic& before, const Cubic& after) {
  const double angle_rad = angle_between(end_direction(before), start_direction(after));
  return angle_rad * 180.0 / std::numbers::pi <= kSmoothJointMaxDeg ? JointKind::kSmooth
                                                                    : JointKind::kCorner;
}

// Returns part / whole, or 0 if the path is too long for a double.
double share_of(double part, double whole) {
  const double share = part / whole;
  return std::isfinite(share) ? share : 0.0;
}

// Returns t after one Newton step for (f(t) - p) . f'(t) = 0.
double newton_step(const Cubic& c, Point p, double t) {
  const Vec d = evaluate(c, t) - p, d1 = derivative(c, t), d2 = second_derivative(c, t);
  const double next = t - dot(d, d1) / (norm_squared(d1) + dot(d, d2));
  return std::isfinite(next) ? next : t;
}

}  // namespace

PaperFitter::PaperFitter(const CurveFitOptions& options, int shared_samples, double data_point_mm)
    : tolerance_mm_(options.tolerance_mm),
      shared_(static_cast<std::size_t>(shared_samples)),
      data_point_mm_(data_point_mm) {
  FELT_CHECK(shared_samples >= 0);
}

void PaperFitter::begin() {
  points_.clear();
  path_mm_.clear();
  merged_.clear();
  curve_.points.clear();
  curve_.joints.clear();
  curve_.sample_u.clear();
  ends_.assign(1, 0);
  good_.from = good_.to = trial_.to = 0;
}

void PaperFitter::push(Point p) {
  newest_ = p;
  if (points_.empty() || distance(points_.back(), p) >= data_point_mm_) {
    add_point(p);
  } else {
    ++merged_.back();
  }
}

void PaperFitter::add_point(Point p) {
  merged_.push_back(0);
  path_mm_.push_back(points_.empty() ? 0.0 : path_mm_.back() + distance(points_.back(), p));
  points_.push_back(p);
  if (points_.size() > shared_) grow_to(points_.size() - 1 - shared_);
}

void PaperFitter::end() {
  if (points_.empty()) return;
  if (merged_.back() > 0) {
    --merged_.back();
    add_point(newest_);
  }
  const std::size_t last = points_.size() - 1;
  grow_to(last);
  if (good_.to > good_.from) {
    commit(good_);
  } else if (curve_.points.empty()) {
    add_dot();
  } else if (ends_.back() < last) {
    absorb_tail();
  }
  place_merged();
}

// Assigns the samples between two data points parameters between the parameters of these two.
void PaperFitter::place_merged() {
  std::vector<double> u;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double from = curve_.sample_u[i];
    const double to = i + 1 < points_.size() ? curve_.sample_u[i + 1] : from;
    u.push_back(from);
    for (std::size_t k = 1; k <= merged_[i]; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(merged_[i] + 1);
      u.push_back(std::min(to, from + share * (to - from)));
    }
  }
  curve_.sample_u = std::move(u);
}

// Tries every joint up to the sample `to`. If a fit fails, the segment ends at the last joint that
// succeeded, and the samples after it are tried again as the start of the next segment.
void PaperFitter::grow_to(std::size_t to) {
  while (trial_.to < to) {
    trial_.from = good_.from;
    ++trial_.to;
    if (fit_within(trial_)) {
      std::swap(good_, trial_);
      trial_.to = good_.to;
    } else if (good_.to > good_.from) {
      commit(good_);
      good_.from = trial_.to = good_.to;
    }
  }
}

bool PaperFitter::fit_within(Run& run) const {
  if (!long_enough(points_[run.from], points_[run.to])) return false;
  // The first run of a segment is always accepted. It is usually the chord between two neighbours,
  // which meets both exactly.
  const bool first_try = good_.to == good_.from;
  if (run.to - run.from > kMaxRun && !first_try) return false;
  return fit(run) <= tolerance_mm_ || first_try;
}

// Least squares for B2, B3 with B1, B4 fixed: with b1..b4 the Bernstein basis at t_i,
//   sum b2 b2 B2 + sum b2 b3 B3 = sum b2 R_i,   sum b3 b2 B2 + sum b3 b3 B3 = sum b3 R_i,
// where R_i = P_i - b1 B1 - b4 B4.
double PaperFitter::fit(Run& run) const {
  const Point b1 = points_[run.from], b4 = points_[run.to];
  const std::size_t first = run.from - std::min(run.from, shared_);
  const std::size_t last = std::min(run.to + shared_, points_.size() - 1);
  const double length = path_mm_[run.to] - path_mm_[run.from];
  double s22 = 0.0, s23 = 0.0, s33 = 0.0;
  Vec r2, r3;
  for (std::size_t i = first; i <= last; ++i) {
    const double t = share_of(path_mm_[i] - path_mm_[run.from], length), s = 1.0 - t;
    const double w2 = 3.0 * t * s * s, w3 = 3.0 * t * t * s;
    const Vec rest = (points_[i] - b1) - t * t * t * (b4 - b1);  // relative to B1, so B1 drops out
    s22 += w2 * w2;
    s23 += w2 * w3;
    s33 += w3 * w3;
    r2 += w2 * rest;
    r3 += w3 * rest;
  }
  run.cubic = straight(b1, b4);
  const double det = s22 * s33 - s23 * s23;
  if (det > 1e-9 * s22 * s33) {
    // Relative to B1, only the weights w2 of B2 and w3 of B3 remain.
    const Point b2 = b1 + (s33 * r2 - s23 * r3) / det, b3 = b1 + (s22 * r3 - s23 * r2) / det;
    if (is_finite(b2) && is_finite(b3)) run.cubic = {{b1, b2, b3, b4}};
  }
  return place_samples(run);
}

// Sets run.t and returns the largest distance of a drawn sample to the curve at its t.
double PaperFitter::place_samples(Run& run) const {
  const double length = path_mm_[run.to] - path_mm_[run.from];
  run.t.clear();
  double previous = 0.0, worst = 0.0;
  for (std::size_t i = run.from; i <= run.to; ++i) {
    const double chord_t = share_of(path_mm_[i] - path_mm_[run.from], length);
    const double newton_t = newton_step(run.cubic, points_[i], chord_t);
    double t = std::clamp(chord_t, previous, 1.0);
    double d = distance(evaluate(run.cubic, t), points_[i]);
    const double better_t = std::clamp(newton_t, previous, 1.0);
    const double better_d = distance(evaluate(run.cubic, better_t), points_[i]);
    if (better_d < d) {
      t = better_t;
      d = better_d;
    }
    if (i == run.from) t = 0.0, d = 0.0;
    if (i == run.to) t = 1.0, d = 0.0;
    run.t.push_back(t);
    worst = std::max(worst, d);
    previous = t;
  }
  return worst;
}

void PaperFitter::commit(const Run& run) {
  const int index = curve_.segment_count();
  if (index == 0) {
    curve_.points.push_back(run.cubic.p[0]);
    curve_.sample_u.push_back(0.0);
  } else {
    curve_.joints.push_back(joint_between(curve_.segment(index - 1), run.cubic));
  }
  curve_.points.insert(curve_.points.end(), run.cubic.p.begin() + 1, run.cubic.p.end());
  for (std::size_t k = 1; k < run.t.size(); ++k) curve_.sample_u.push_back(index + run.t[k]);
  ends_.push_back(run.to);
}

void PaperFitter::uncommit_last() {
  ends_.pop_back();
  curve_.points.resize(curve_.points.size() - 3);
  if (!curve_.joints.empty()) curve_.joints.pop_back();
  curve_.sample_u.resize(ends_.back() + 1);
  if (curve_.points.size() == 1) {
    curve_.points.clear();
    curve_.sample_u.clear();
  }
}

// The samples after the last joint are too close to it for a segment (I5). So the last segment is
// fitted again to draw them too. If that fit misses the tolerance, the segment stays as it is, and
// its end represents these samples.
void PaperFitter::absorb_tail() {
  const std::size_t last = points_.size() - 1;
  const std::size_t from = ends_[ends_.size() - 2];
  Run whole{.from = from, .to = last, .cubic = {}, .t = {}};
  if (long_enough(points_[from], points_[last]) && fit(whole) <= tolerance_mm_) {
    uncommit_last();
    commit(whole);
  } else {
    curve_.sample_u.resize(points_.size(), curve_.segment_count());
  }
}

void PaperFitter::add_dot() {
  const Vec along = normalized(points_.back() - points_.front());
  const Vec step = kMinSegmentMm * (along == Vec{} ? Vec{1.0, 0.0} : along);
  const Cubic dot_segment = straight(points_.front(), points_.front() + step);
  curve_.points.assign(dot_segment.p.begin(), dot_segment.p.end());
  double u = 0.0;
  for (const Point p : points_) {
    u = std::clamp(dot(p - points_.front(), step) / norm_squared(step), u, 1.0);
    curve_.sample_u.push_back(u);
  }
}

}  // namespace felt
