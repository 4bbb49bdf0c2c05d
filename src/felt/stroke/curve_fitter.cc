#include "felt/stroke/curve_fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace felt {
namespace {

// Room for the longest run, its look-ahead and the samples behind that corners are measured with.
constexpr std::size_t kWindowCapacity = 2048;
// Samples and path kept behind the open run for the corner detector's arms.
constexpr std::size_t kKeepSamples = 8;
constexpr double kKeepPath = CornerDetector::kCornerDetour * CornerDetector::kCornerArm + 1.0;
// A stroke with less path is a dot: what its samples stand for is within the least tolerance of
// the first one.
constexpr double kDotMm = (1.0 - CurveFitter::kSpacing - SampleWindow::kReserve) * kMinSegmentMm;
// A joint's tangent is taken where the curve moves at least at this part of its mean speed.
constexpr double kJointSpeed = 0.6;

// What a step costs besides its fit: gate updates, solving, a commit.
constexpr long kStepWork = 64;
constexpr long kAllWork = std::numeric_limits<long>::max();

double effective_tolerance(const CurveFitOptions& options) {
  return std::max(options.tolerance_mm, kMinSegmentMm);
}

}  // namespace

std::size_t choose_joint(const Cubic& curve, std::span<const double> parameters,
                         double reach) noexcept {
  const std::size_t count = parameters.size();
  const double speed = kJointSpeed * control_length(curve);
  const auto is_good = [&](std::size_t k) {
    const double t = parameters[k];
    return norm(derivative(curve, t)) >= speed &&
           control_length(split(curve, t).first) >= kShortestSegmentMm;
  };
  const double wanted = std::ceil(reach * static_cast<double>(count));
  const std::size_t middle = std::min(count, static_cast<std::size_t>(wanted)) - 1;
  for (std::size_t away = 0; away < count; ++away) {
    if (middle + away < count && is_good(middle + away)) return middle + away;
    if (away <= middle && 2 * away < count && is_good(middle - away)) return middle - away;
  }
  return count - 1;
}

void append_sample_places(const SamplePlace& place, double next_u, const Cubic& segment,
                          double tolerance_mm, std::vector<double>& sample_u) {
  constexpr double kStep = 1e-6;
  // |f'| is at most three times the longest leg of the control polygon.
  const double speed = 3.0 * control_length(segment);
  const double room = 0.5 * SampleWindow::kReserve * tolerance_mm;
  const double span = std::min({kStep * place.count, next_u - place.u, room / speed});
  const double step = std::max(0.0, span) / (place.count + 1.0);
  for (std::uint32_t i = 0; i < place.count; ++i) sample_u.push_back(place.u + i * step);
}

CurveFitter::CurveFitter(const CurveFitOptions& options)
    : window_(effective_tolerance(options), kSpacing * effective_tolerance(options),
              kWindowCapacity) {}

void CurveFitter::begin() noexcept {
  window_.clear();
  corners_.clear();
  searching_ = false;
  ended_ = false;
  next_kind_ = RunStart::Kind::kFree;
  next_first_ = 0;
  scanned_ = 0;
  at_corner_ = false;
  points_.clear();
  joints_.clear();
  places_.clear();
}

void CurveFitter::push(Point p) {
  if (window_.size() == window_.capacity()) make_room();
  if (!window_.add(p)) return;
  corners_.update(window_);
  advance(kWorkPerPush);
}

void CurveFitter::end() {
  ended_ = true;
  if (window_.size() == 0) return;
  corners_.finish(window_);
  if (points_.empty() && window_.path_mm(window_.size() - 1) < kDotMm) {
    add_dot();
  } else {
    advance(kAllWork);
  }
}

Cubic CurveFitter::segment(int i) const noexcept {
  const auto k = static_cast<std::size_t>(3 * i);
  return {{points_[k], points_[k + 1], points_[k + 2], points_[k + 3]}};
}

FittedCurve CurveFitter::curve() const {
  FittedCurve curve;
  copy_to(curve);
  return curve;
}

void CurveFitter::copy_to(FittedCurve& curve) const {
  curve.points.assign(points_.begin(), points_.end());
  curve.joints.assign(joints_.begin(), joints_.end());
  curve.sample_u.clear();
  const double end = segment_count();
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double next = i + 1 < places_.size() ? places_[i + 1].u : end;
    const int at = std::min(static_cast<int>(places_[i].u), segment_count() - 1);
    append_sample_places(places_[i], next, segment(at), window_.tolerance_mm(), curve.sample_u);
  }
}

// Moves `scanned_` on: the open run may use the samples before it, and ends there at a corner.
void CurveFitter::scan_for_corner() noexcept {
  const std::size_t end = std::min(corners_.decided(), next_first_ + SegmentFit::kMaxRun);
  while (!at_corner_ && scanned_ < end) {
    at_corner_ = window_.is_corner(scanned_);
    ++scanned_;
  }
}

// Works on the open run until `work` is used up.
void CurveFitter::advance(long work) {
  const long before = search_.work();
  long steps = 0;
  while (next_first_ < corners_.decided() || searching_) {
    if (!searching_) {
      const std::size_t least = next_kind_ == RunStart::Kind::kFree ? 2 : 1;
      if (corners_.decided() < next_first_ + least) return;
      const Point at = points_.empty() ? window_.point(next_first_) : points_.back();
      search_.begin(window_, {next_kind_, at, next_tangent_}, next_first_);
      searching_ = true;
    }
    scan_for_corner();
    const RunSearch::Status status = search_.step(window_, scanned_, at_corner_ || ended_);
    if (status == RunSearch::Status::kDone) commit();
    if (status == RunSearch::Status::kNeedSamples) return;
    ++steps;
    if (search_.work() - before + kStepWork * steps >= work) return;
  }
}

// Ends the open run with a segment and prepares the next one.
void CurveFitter::commit() {
  searching_ = false;
  search_.ensure_length(window_);
  const std::size_t run_end = next_first_ + search_.count();
  const bool is_corner = at_corner_ && run_end == scanned_;
  const bool is_last = ended_ && run_end == window_.size();
  const bool to_sample = is_last || is_corner;
  if (points_.empty() || to_sample) search_.pin(window_, points_.empty(), to_sample);
  const JointKind joint =
      next_kind_ == RunStart::Kind::kTangent ? JointKind::kSmooth : JointKind::kCorner;
  if (to_sample) {
    append(search_.curve(), joint, search_.count() - 1);
    start_next(RunStart::Kind::kPoint, run_end - 1, {});
    return;
  }
  const std::size_t k = choose_joint(search_.curve(), search_.parameters(), kReach);
  const double t = search_.parameters()[k];
  const Vec along = tangent(search_.curve(), t);
  append(split(search_.curve(), t).first, joint, k);
  start_next(RunStart::Kind::kTangent, next_first_ + k, along);
}

// Adds a segment that covers the run's samples up to index `last_of_run`.
void CurveFitter::append(const Cubic& segment, JointKind joint, std::size_t last_of_run) {
  const double index = segment_count();
  if (points_.empty()) {
    points_.push_back(segment.p[0]);
  } else {
    joints_.push_back(joint);
  }
  for (std::size_t k = 1; k < 4; ++k) points_.push_back(segment.p[k]);
  const std::span<const double> t = search_.parameters();
  const double scale = t[last_of_run] > 0.0 ? 1.0 / t[last_of_run] : 1.0;
  for (std::size_t i = 0; i <= last_of_run; ++i) {
    const double u = index + (i == last_of_run ? 1.0 : std::min(1.0, t[i] * scale));
    places_.push_back({u, window_.sample_count(search_.first() + i)});
  }
}

void CurveFitter::start_next(RunStart::Kind kind, std::size_t joint_sample, Vec along) {
  next_kind_ = kind;
  next_tangent_ = along;
  next_first_ = joint_sample + 1;
  scanned_ = next_first_;
  at_corner_ = false;
}

// The window is full: drop what the open run and the corner arms no longer need. If the search is
// so far behind that this does not help, it catches up first.
void CurveFitter::make_room() {
  const auto droppable = [&] {
    if (next_first_ <= kKeepSamples) return std::size_t{0};
    const double behind = window_.path_mm(next_first_ - 1) - kKeepPath * window_.tolerance_mm();
    std::size_t count = next_first_ - kKeepSamples;
    while (count > 0 && window_.path_mm(count) > behind) --count;
    return count;
  };
  std::size_t count = droppable();
  if (count < window_.capacity() / 4) {
    advance(kAllWork);
    count = droppable();
  }
  if (count == 0) return;
  window_.drop_front(count);
  corners_.shift(count);
  if (searching_) search_.shift(count);
  next_first_ -= count;
  scanned_ -= count;
}

void CurveFitter::append_live_tail(std::vector<Cubic>& tail) const {
  if (window_.size() == 0) return;
  std::size_t next = next_first_;
  Point at = points_.empty() ? window_.point(0) : points_.back();
  if (searching_ && search_.count() > 0) {
    tail.push_back(search_.curve());
    at = search_.curve().p[3];
    next = next_first_ + search_.count();
  }
  for (; next < window_.size(); ++next) {
    const Point p = window_.point(next);
    if (p == at) continue;
    tail.push_back(straight(at, p));
    at = p;
  }
  if (window_.newest() != at) tail.push_back(straight(at, window_.newest()));
}

// All samples within kMinSegmentMm of the first.
void CurveFitter::add_dot() {
  const Point first = window_.point(0);
  const Vec along = normalized(window_.newest() - first);
  const Vec step = kShortestSegmentMm * (along == Vec{} ? Vec{1.0, 0.0} : along);
  const Cubic dot = straight(first, first + step);
  for (const Point& p : dot.p) points_.push_back(p);
  for (std::size_t i = 0; i < window_.size(); ++i)
    places_.push_back({0.0, window_.sample_count(i)});
}

}  // namespace felt
