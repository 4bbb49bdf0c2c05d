// Implements the second half of subdivide.h: replaces runs of segments by one cubic each.
//
// From each joint, `longest` tries longer and longer runs, then finds the limit by bisection.
// RunFit fits one cubic to points of a run. The ends of the cubic and the tangents there are given.
// Two steps alternate: least squares finds the two handle lengths, then the parameter of each point
// moves towards the nearest point of the curve. A fit is accepted only if the curve is within the
// tolerance everywhere, not just at the points (is_within).

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "felt/stroke/edit/subdivide.h"
#include "felt/stroke/profile_builder.h"

namespace felt {
namespace {

using Match = ProfileBuilder::Match;

/// The tolerance of the widths along a merged run.
constexpr double kWidthToleranceMm = 0.005;
/// The maximum length of a run, in segments, and the number of points on each of its segments.
constexpr int kMaxRun = 96;
constexpr int kPlaces = 4;
/// The maximum number of least-squares rounds of a fit.
constexpr int kSearchRounds = 16;
/// A fit is abandoned if its error is still more than kHopeless tolerances after kPatience rounds.
constexpr int kPatience = 4;
constexpr double kHopeless = 3.0;
/// The weight of a distance along the curve, compared with the distance from its tangent line.
constexpr double kTangentWeight = 0.01;
/// The limits of the handle lengths, as fractions of the length of the run, so that handles are not
/// zero and do not cross.
constexpr double kMinHandle = 0.04;
constexpr double kMaxHandle = 1.0;
/// The accuracy with which the curve goes through the point `through`, mm.
constexpr double kMeetMm = 1e-11;
/// The maximum number of steps in which the handles, and the parameter of `through`, are changed
/// until the curve goes through that point.
constexpr int kMeetRounds = 8;
constexpr int kFootRounds = 4;
/// Each run that is tried is about 1/kGrowth longer than the one before. The search stops when
/// kFailures runs in a row do not fit.
constexpr int kGrowth = 3;
constexpr int kFailures = 3;

/// One cubic that replaces a run of segments. Its ends and the directions there are given; the
/// lengths of its two handles are fitted to points on the run.
class RunFit {
 public:
  /// Prepares the segments [first, last) of the stroke. The curve will go through the joint
  /// `through` if that joint is inside the run.
  RunFit(const Stroke& stroke, int first, int last, int through) : stroke_(stroke), first_(first) {
    if (through > first && through < last) {
      met_ = static_cast<std::size_t>(kPlaces * (through - first));
    }
    const int count = kPlaces * (last - first);
    for (int k = 0; k <= count; ++k) {
      places_.push_back(evaluate(stroke.segment(segment_of(k, count)), t_of(k, count)));
    }
    t_.assign(places_.size(), 0.0);
    for (std::size_t k = 1; k < places_.size(); ++k) {
      t_[k] = t_[k - 1] + distance(places_[k - 1], places_[k]);
    }
    length_ = t_.back();
    for (double& t : t_) t /= length_;
    start_ = tangent(stroke.segment(first), 0.0);
    end_ = -tangent(stroke.segment(last - 1), 1.0);
    set_handles(length_ / 3.0, length_ / 3.0);
  }

  /// Fits the curve. Returns true if the curve and the run are within the tolerance of each other,
  /// and the curve is long enough for a segment.
  bool fit(double tolerance_mm) {
    if (!(length_ > 0.0)) return false;
    for (int round = 0; round < kSearchRounds; ++round) {
      if (!solve()) return false;
      place();
      if (round < 2) continue;
      if (!meet()) return false;
      const double error = farthest();
      if (error <= tolerance_mm && is_within(tolerance_mm)) {
        return control_length(curve_) >= kMinSegmentMm;
      }
      if (round >= kPatience && error > kHopeless * tolerance_mm) return false;
    }
    return false;
  }

  [[nodiscard]] const Cubic& curve() const { return curve_; }
  /// Returns the parameters of the points on the old stroke and on the new one, in which the curve
  /// is segment `now`.
  [[nodiscard]] std::vector<Match> matches(int now) const {
    std::vector<Match> result;
    for (std::size_t k = 0; k < t_.size(); ++k) {
      result.push_back({first_ + static_cast<double>(k) / kPlaces, now + t_[k]});
    }
    return result;
  }

 private:
  [[nodiscard]] int segment_of(int k, int count) const {
    return first_ + (k == count ? k - 1 : k) / kPlaces;
  }
  static double t_of(int k, int count) {
    return k == count ? 1.0 : static_cast<double>(k % kPlaces) / kPlaces;
  }

  void set_handles(double start_mm, double end_mm) {
    const Point a = places_.front(), b = places_.back();
    curve_ = {{a, a + start_mm * start_, b + end_mm * end_, b}};
  }

  /// Finds the handle lengths by least squares; distances along the curve have little weight.
  bool solve() {
    double c11 = 0.0, c12 = 0.0, c22 = 0.0, x1 = 0.0, x2 = 0.0;
    const Cubic bare{{curve_.p[0], curve_.p[0], curve_.p[3], curve_.p[3]}};
    for (std::size_t k = 1; k + 1 < places_.size(); ++k) {
      const double t = t_[k], s = 1.0 - t;
      const Vec along = normalized(derivative(curve_, t));
      const auto weighted = [&](Vec v) {
        return v - (1.0 - kTangentWeight) * dot(v, along) * along;
      };
      const Vec a1 = 3.0 * t * s * s * start_, a2 = 3.0 * t * t * s * end_;
      const Vec rest = weighted(places_[k] - evaluate(bare, t));
      c11 += dot(a1, weighted(a1));
      c12 += dot(a1, weighted(a2));
      c22 += dot(a2, weighted(a2));
      x1 += dot(a1, rest);
      x2 += dot(a2, rest);
    }
    const double det = c11 * c22 - c12 * c12;
    if (!(det > 1e-12 * c11 * c22)) return false;
    const double smallest = kMinHandle * length_, largest = kMaxHandle * length_;
    set_handles(std::clamp((x1 * c22 - x2 * c12) / det, smallest, largest),
                std::clamp((c11 * x2 - c12 * x1) / det, smallest, largest));
    return true;
  }

  /// Changes the handles as little as possible so that the curve goes through the point `through`.
  /// Returns false if they would become too short or too long.
  bool meet() {
    if (met_ == 0) return true;
    const Point target = places_[met_];
    double& t = t_[met_];
    for (int round = 0; round < kMeetRounds; ++round) {
      for (int k = 0; k < kFootRounds; ++k) {
        const Vec d = derivative(curve_, t);
        const double step = dot(target - evaluate(curve_, t), d) / norm_squared(d);
        t = std::clamp(t + step, t_[met_ - 1], t_[met_ + 1]);
      }
      const Vec rest = target - evaluate(curve_, t);
      if (norm_squared(rest) <= kMeetMm * kMeetMm) return true;
      const double s = 1.0 - t;
      const double a = 3.0 * t * s * s * dot(rest, start_), b = 3.0 * t * t * s * dot(rest, end_);
      const double share = norm_squared(rest) / (a * a + b * b);
      const double start_mm = distance(curve_.p[0], curve_.p[1]) + share * a;
      const double end_mm = distance(curve_.p[2], curve_.p[3]) + share * b;
      const double smallest = kMinHandle * length_, largest = kMaxHandle * length_;
      // NaN compares false.
      if (!(std::min(start_mm, end_mm) >= smallest && std::max(start_mm, end_mm) <= largest))
        return false;
      set_handles(start_mm, end_mm);
    }
    return false;
  }

  /// Moves each parameter one step towards the nearest point of the curve, and keeps the parameters
  /// in order.
  void place() {
    for (std::size_t k = 1; k + 1 < places_.size(); ++k) {
      const Vec d = derivative(curve_, t_[k]);
      const double step = dot(places_[k] - evaluate(curve_, t_[k]), d) / norm_squared(d);
      t_[k] = std::clamp(t_[k] + std::clamp(step, -0.1, 0.1), t_[k - 1], 1.0);
    }
  }

  /// Returns the largest distance of a point from its counterpart on the curve.
  [[nodiscard]] double farthest() const {
    double worst = 0.0;
    for (std::size_t k = 0; k < t_.size(); ++k) {
      worst = std::max(worst, distance_squared(places_[k], evaluate(curve_, t_[k])));
    }
    return std::sqrt(worst);
  }

  /// Returns true if the curve is within the tolerance of the run everywhere. Compares the pieces
  /// between neighbouring points: the difference of two cubics is a cubic, which is inside the hull
  /// of its control points.
  [[nodiscard]] bool is_within(double tolerance_mm) const {
    const int count = static_cast<int>(places_.size()) - 1;
    const double largest = tolerance_mm * tolerance_mm;
    for (int k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double from = static_cast<double>(k % kPlaces) / kPlaces;
      const Cubic old = sub_segment(stroke_.segment(first_ + k / kPlaces), from,
                                    k % kPlaces + 1 == kPlaces ? 1.0 : from + 1.0 / kPlaces);
      const Cubic now = sub_segment(curve_, t_[i], t_[i + 1]);
      for (std::size_t j = 0; j < 4; ++j) {
        if (!(distance_squared(old.p[j], now.p[j]) <= largest)) return false;
      }
    }
    return true;
  }

  const Stroke& stroke_;
  int first_;
  std::size_t met_ = 0;  // the index of the point `through`, or 0
  std::vector<Point> places_;
  std::vector<double> t_;
  double length_ = 0.0;
  Vec start_, end_;  // directions of the handles
  Cubic curve_{};
};

/// Copies a stroke and replaces runs by single segments.
class Rewriter {
 public:
  explicit Rewriter(const Stroke& stroke) : stroke_(stroke), profile_(stroke.widths()) {
    const StrokeData& old = stroke.data();
    data_.points.push_back(old.points.front());
    data_.closed = old.closed;
    data_.medium = old.medium;
    data_.color = old.color;
  }

  void copy(int segment) {
    profile_.shift(segment, segment + 1, count() - segment);
    push(stroke_.segment(segment), segment + 1);
  }
  /// Appends one segment for the run up to `last`.
  void merge(const RunFit& fit, int last) {
    profile_.follow(fit.matches(count()), kWidthToleranceMm);
    push(fit.curve(), last);
  }
  [[nodiscard]] int count() const { return static_cast<int>(data_.points.size() / 3); }

  [[nodiscard]] Result<Stroke> finish() && {
    if (!data_.closed) data_.joints.pop_back();
    data_.widths = std::move(profile_).finish(count());
    return Stroke::create(std::move(data_));
  }

 private:
  void push(const Cubic& c, int end_joint) {
    data_.points.insert(data_.points.end(), c.p.begin() + 1, c.p.end());
    data_.joints.push_back(stroke_.joint(end_joint));
  }

  const Stroke& stroke_;
  ProfileBuilder profile_;
  StrokeData data_;
};

/// Returns, for each joint, true if runs must end there.
std::vector<bool> fixed_joints(const Stroke& stroke, int first, int last,
                               std::span<const int> keep) {
  const int n = stroke.segment_count();
  const bool wraps = last <= first;
  std::vector<bool> fixed(static_cast<std::size_t>(n) + 1, false);
  for (int j = 0; j <= n; ++j) {
    const bool inside = wraps ? j > first || j < last : j > first && j < last;
    const bool seam = j == 0 || j == n;
    fixed[static_cast<std::size_t>(j)] = seam || !inside || stroke.joint(j) != JointKind::kSmooth;
  }
  for (const int j : keep) {
    if (j >= 0 && j <= n) fixed[static_cast<std::size_t>(j)] = true;
  }
  return fixed;
}

/// Returns a long run from `first`, up to `end`, that one cubic can replace. The run grows until it
/// no longer fits; then the limit is found by bisection.
std::optional<std::pair<RunFit, int>> longest(const Stroke& stroke, int first, int end,
                                              double tolerance_mm, int through) {
  std::optional<std::pair<RunFit, int>> best;
  const auto fits = [&](int last) {
    RunFit fit(stroke, first, last, through);
    if (!fit.fit(tolerance_mm)) return false;
    best.emplace(std::move(fit), last);
    return true;
  };
  const int largest = std::min(end, first + kMaxRun);
  int good = first + 1, bad = largest + 1, failures = 0;
  for (int length = 2; good < largest && failures < kFailures; length += 1 + length / kGrowth) {
    const int last = std::min(first + length, largest);
    if (fits(last)) {
      good = last;
      bad = largest + 1;
      failures = 0;
    } else {
      if (failures++ == 0) bad = last;
      if (last == largest) break;
    }
  }
  while (bad - good > 1) {
    const int last = good + (bad - good) / 2;
    (fits(last) ? good : bad) = last;
  }
  return best;
}

}  // namespace

Result<Stroke> with_fewer_segments(const Stroke& stroke, int first, int last, double tolerance_mm,
                                   std::span<const int> keep, int through) {
  const int n = stroke.segment_count();
  if (first < 0 || first > n || last < 0 || last > n || (last <= first && !stroke.closed())) {
    return fail(ErrorCode::kInvalidArgument, "the part to simplify is not within the stroke");
  }
  if (!(tolerance_mm >= 0.0)) {
    return fail(ErrorCode::kInvalidArgument, "a tolerance must be a number of at least 0");
  }
  const std::vector<bool> fixed = fixed_joints(stroke, first, last, keep);
  Rewriter result(stroke);
  for (int i = 0; i < n;) {
    int end = i + 1;
    while (!fixed[static_cast<std::size_t>(end)]) ++end;
    const auto run = longest(stroke, i, end, tolerance_mm, through);
    if (run) {
      result.merge(run->first, run->second);
      i = run->second;
    } else {
      result.copy(i++);
    }
  }
  if (result.count() == n) return stroke;
  return std::move(result).finish();
}

}  // namespace felt
