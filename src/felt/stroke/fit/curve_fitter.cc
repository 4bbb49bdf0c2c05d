#include "felt/stroke/fit/curve_fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace felt {
namespace {

// Number of samples that one step checks for corners, or places on a curve.
constexpr std::size_t kStepSamples = 128;
// If the proven part of a run has at least this many samples, it becomes a segment; otherwise the
// search is repeated with every sample in the window.
constexpr std::size_t kWorthACut = SegmentFit::kMaxRun / 2;
// A stroke with a shorter path is a dot, because all its samples, even merged ones, are within
// kMinSegmentMm (the smallest tolerance) of the first one.
constexpr double kDotMm = (1.0 - CurveFitter::kMaxSpacing - KeptSamples::kReserve) * kMinSegmentMm;
// At a joint, the curve's speed must be at least this fraction of its mean, so that the tangent is
// well determined.
constexpr double kJointSpeed = 0.6;

// Work of a step in addition to its fit: gate updates, solving, a commit.
constexpr long kStepWork = 64;
constexpr long kAllWork = std::numeric_limits<long>::max();

}  // namespace

std::size_t choose_joint(const Cubic& curve, std::span<const double> parameters,
                         double reach) noexcept {
  const double wanted = std::ceil(reach * static_cast<double>(parameters.size()));
  return choose_joint_near(curve, parameters,
                           std::min(parameters.size(), static_cast<std::size_t>(wanted)) - 1);
}

std::size_t choose_joint_near(const Cubic& curve, std::span<const double> parameters,
                              std::size_t middle) noexcept {
  const std::size_t count = parameters.size();
  const double speed = kJointSpeed * control_length(curve);
  const auto is_good = [&](std::size_t k) {
    const double t = parameters[k];
    return norm(derivative(curve, t)) >= speed &&
           control_length(split(curve, t).first) >= kShortestSegmentMm;
  };
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
  const double room = 0.5 * KeptSamples::kReserve * tolerance_mm;
  const double span = std::min({kStep * place.count, next_u - place.u, room / speed});
  const double step = std::max(0.0, span) / (place.count + 1.0);
  for (std::uint32_t i = 0; i < place.count; ++i) sample_u.push_back(place.u + i * step);
}

CurveFitter::CurveFitter(const CurveFitOptions& options)
    : kept_(options.effective_tolerance_mm(), spacing_mm(options.effective_tolerance_mm())) {}

void CurveFitter::begin() noexcept {
  kept_.clear();
  corners_.clear();
  phase_ = Phase::kWait;
  detail_ = LongRun::Detail::kThinned;
  ended_ = false;
  next_kind_ = RunStart::Kind::kFree;
  next_first_ = 0;
  scanned_ = 0;
  at_corner_ = false;
  points_.clear();
  joints_.clear();
  places_.clear();
  placed_before_ = 0;
}

void CurveFitter::push(Point p) {
  if (!kept_.add(p)) return;
  corners_.update(kept_);
  advance(kWorkPerPush);
}

void CurveFitter::end() {
  ended_ = true;
  if (kept_.size() == 0) return;
  corners_.finish(kept_);
  if (points_.empty() && phase_ != Phase::kPlace && kept_.path_mm(kept_.size() - 1) < kDotMm) {
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
  for (std::size_t i = 0; i < placed_before_; ++i) {
    const double next = i + 1 < placed_before_ ? places_[i + 1].u : end;
    const int at = std::min(static_cast<int>(places_[i].u), segment_count() - 1);
    append_sample_places(places_[i], next, segment(at), kept_.tolerance_mm(), curve.sample_u);
  }
}

// Processes the open run until `work` is used up.
void CurveFitter::advance(long work) {
  const long before = this->work();
  for (long steps = 1; this->work() - before + kStepWork * (steps - 1) < work; ++steps) {
    if (phase_ == Phase::kWait && !start_search()) return;
    if (phase_ == Phase::kPlace) {
      place_some();
      continue;
    }
    scan_for_corner();
    const bool is_final = at_corner_ || (ended_ && scanned_ == kept_.size());
    const RunSearch::Status status = run_.step(kept_, scanned_, is_final);
    if (status == RunSearch::Status::kDone) finish_run();
    if (status == RunSearch::Status::kNeedSamples && scanned_ == corners_.decided()) return;
  }
}

// Starts the search for the next run. Returns false if too few samples are available.
bool CurveFitter::start_search() {
  const std::size_t smallest = next_kind_ == RunStart::Kind::kFree ? 2 : 1;
  if (corners_.decided() < next_first_ + smallest) return false;
  const Point at = points_.empty() ? kept_.point(next_first_) : points_.back();
  run_.begin(kept_, {next_kind_, at, next_tangent_}, next_first_, detail_);
  phase_ = Phase::kSearch;
  return true;
}

// Advances `scanned_`, up to and including the next corner. The open run may use the samples before
// `scanned_`.
void CurveFitter::scan_for_corner() noexcept {
  const std::size_t end = std::min(corners_.decided(), scanned_ + kStepSamples);
  while (!at_corner_ && scanned_ < end) {
    at_corner_ = kept_.is_corner(scanned_);
    ++scanned_;
  }
}

// Proposes a segment after the search for a run: the whole run if it ends at a corner or at the end
// of the stroke, otherwise its part up to a cut.
void CurveFitter::finish_run() noexcept {
  run_.ensure_length();
  const bool is_corner = at_corner_ && run_.end() == scanned_;
  const bool is_last = ended_ && run_.end() == kept_.size();
  const bool to_sample = is_last || is_corner;
  if (points_.empty() || to_sample) run_.pin(points_.empty(), to_sample);
  if (to_sample) {
    propose_whole();
  } else {
    propose_cut(run_.count());
  }
}

void CurveFitter::propose_whole() noexcept {
  candidate_ = {run_.curve(), run_.end() - 1, true, {}};
  placer_.begin(run_, candidate_.segment, 1.0);
  phase_ = Phase::kPlace;
}

// Proposes to cut the run at a joint with samples on both sides. Uses the first `count` samples of
// its window.
void CurveFitter::propose_cut(std::size_t count) noexcept {
  const auto samples = static_cast<double>(run_.source(count - 1) + 1 - run_.first());
  const auto wanted = run_.first() + static_cast<std::size_t>(std::ceil(kReach * samples)) - 1;
  std::size_t middle = 0;
  while (run_.source(middle) < wanted) ++middle;
  const std::span<const double> t = run_.parameters().first(count);
  const std::size_t k = choose_joint_near(run_.curve(), t, middle);
  candidate_ = {split(run_.curve(), t[k]).first, run_.source(k), false,
                tangent(run_.curve(), t[k])};
  placer_.begin(run_, candidate_.segment, t[k]);
  phase_ = Phase::kPlace;
}

// Places the next samples on the candidate, and commits it after the last one.
void CurveFitter::place_some() {
  const double index = segment_count();
  for (std::size_t done = 0; done < kStepSamples; ++done) {
    const std::size_t i = placer_.next();
    const std::optional<double> t = placer_.place(run_, kept_);
    ++work_;
    if (!t) return retry_before(i);
    const bool is_end = i == candidate_.last;
    places_.push_back({index + (is_end ? 1.0 : *t), kept_.sample_count(i)});
    if (is_end) return commit();
  }
}

// Handles a run that misses kept sample `sample`: searches again with that sample held in the
// window, a limited number of times. After that, proposes the part before the sample if that part
// is long, or else searches again with every sample in the window.
void CurveFitter::retry_before(std::size_t sample) noexcept {
  places_.truncate(placed_before_);
  if (run_.search_again(kept_, sample, placer_.furthest())) {
    phase_ = Phase::kSearch;
    return;
  }
  std::size_t count = 0;
  while (count < run_.count() && run_.source(count) < sample) ++count;
  if (count > 0 && run_.source(count - 1) - run_.first() >= kWorthACut) return propose_cut(count);
  detail_ = LongRun::Detail::kEverySample;
  phase_ = Phase::kWait;
}

// Ends the open run with the candidate and prepares the next one.
void CurveFitter::commit() {
  if (points_.empty()) {
    points_.push_back(candidate_.segment.p[0]);
  } else {
    joints_.push_back(next_kind_ == RunStart::Kind::kTangent ? JointKind::kSmooth
                                                             : JointKind::kCorner);
  }
  for (std::size_t k = 1; k < 4; ++k) points_.push_back(candidate_.segment.p[k]);
  placed_before_ = places_.size();
  next_kind_ = candidate_.is_whole ? RunStart::Kind::kPoint : RunStart::Kind::kTangent;
  next_tangent_ = candidate_.end_tangent;
  next_first_ = candidate_.last + 1;
  scanned_ = next_first_;
  at_corner_ = false;
  phase_ = Phase::kWait;
  detail_ = LongRun::Detail::kThinned;
}

void CurveFitter::append_live_tail(std::vector<Cubic>& tail) const {
  if (kept_.size() == 0) return;
  std::size_t next = next_first_;
  Point at = points_.empty() ? kept_.point(0) : points_.back();
  if (phase_ != Phase::kWait && run_.count() > 0) {
    tail.push_back(run_.curve());
    at = run_.curve().p[3];
    next = run_.end();
  }
  for (; next < kept_.size(); ++next) {
    const Point p = kept_.point(next);
    if (p == at) continue;
    tail.push_back(straight(at, p));
    at = p;
  }
  if (kept_.newest() != at) tail.push_back(straight(at, kept_.newest()));
}

// Adds the segment of a dot: all samples are within kMinSegmentMm of the first.
void CurveFitter::add_dot() {
  const Point first = kept_.point(0);
  const Vec along = normalized(kept_.newest() - first);
  const Vec step = kShortestSegmentMm * (along == Vec{} ? Vec{1.0, 0.0} : along);
  const Cubic dot = straight(first, first + step);
  for (const Point& p : dot.p) points_.push_back(p);
  for (std::size_t i = 0; i < kept_.size(); ++i) places_.push_back({0.0, kept_.sample_count(i)});
  placed_before_ = places_.size();
}

}  // namespace felt
