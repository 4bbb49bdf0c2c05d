#include "felt/io/ink_of_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/io/line_steps.h"
#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/fit/width_fitter.h"

namespace felt {
namespace {

/// Distances between the points at which the fit checks a straight piece of a drawn line: the
/// distance near the ends of the piece, and the largest distance (line_steps()).
constexpr double kFirstStepMm = 0.15, kMaxStepMm = 1.0;
/// Largest number of points inserted between others in one file. After that, long straight pieces
/// become straight segments, so that a small file with very long lines cannot cause very much work.
constexpr std::size_t kMaxInserted = 4'000'000;
/// Largest number of points that are fitted together. A longer run is fitted in parts that meet in
/// corners, so that memory is bounded.
constexpr std::size_t kLongestRun = 100'000;
/// Once kMaxInserted points were inserted, this length replaces kRuledMm: a longer piece becomes a
/// straight segment, and a shorter one is fitted without extra points.
constexpr double kMinRuledMm = 1.0;

InkFitOptions drawn_line_options() {
  InkFitOptions options;
  options.curve.tolerance_mm = kDrawnLineToleranceMm;
  return options;
}

StrokeData data_of(const FittedCurve& curve) {
  StrokeData data;
  data.points = curve.points;
  data.joints = curve.joints;
  return data;
}

bool is_usable(const WidePoint& p) {
  return is_in_range(p.position) && std::isfinite(p.width_mm);
}

}  // namespace

/// Builds a stroke from straight and fitted parts, which meet in corners.
class InkOfPoints::Pieces {
 public:
  [[nodiscard]] bool empty() const noexcept { return data_.points.empty(); }

  /// Adds a straight segment to `to`. Requires a length of at least kMinSegmentMm.
  void add_straight(const WidePoint& from, const WidePoint& to) {
    const Point start = empty() ? from.position : data_.points.back();
    begin_part(start, from.width_mm);
    const Cubic line = straight(start, to.position);
    data_.points.insert(data_.points.end(), line.p.begin() + 1, line.p.end());
    add_width(segments(), to.width_mm);
    after_straight_ = true;
  }

  /// Adds the curve that was fitted to a run. If a straight segment precedes it, that segment is
  /// moved to end where the curve begins.
  void add_fitted(StrokeData&& run) {
    if (after_straight_) {
      const std::size_t last = data_.points.size() - 1;
      const Cubic line = straight(data_.points[last - 3], run.points.front());
      std::copy(line.p.begin(), line.p.end(), data_.points.end() - 4);
    }
    // If another fitted run precedes this one, moves the start of this run to the end of that run.
    // The two differ by less than the tolerance.
    if (!empty() && !after_straight_) run.points.front() = data_.points.back();
    const double offset = segments();
    begin_part(run.points.front(), run.widths.front().width_mm);
    data_.points.insert(data_.points.end(), run.points.begin() + 1, run.points.end());
    data_.joints.insert(data_.joints.end(), run.joints.begin(), run.joints.end());
    for (const WidthKnot& knot : run.widths) add_width(offset + knot.u, knot.width_mm);
    after_straight_ = false;
  }

  /// Returns the stroke. It is closed if it ends within `reach_mm` of its start and the closed
  /// stroke satisfies the invariants.
  StrokeData finish(double reach_mm) && {
    if (reach_mm > 0.0 && distance(data_.points.front(), data_.points.back()) <= reach_mm) {
      StrokeData ring = data_;
      ring.closed = true;
      ring.points.back() = ring.points.front();
      ring.joints.push_back(JointKind::kCorner);
      if (check_invariants(ring)) return ring;
    }
    return std::move(data_);
  }

 private:
  [[nodiscard]] double segments() const noexcept {
    return static_cast<double>(data_.points.size() / 3);
  }
  void begin_part(Point start, double width_mm) {
    if (empty()) {
      data_.points.push_back(start);
      add_width(0.0, width_mm);
    } else {
      data_.joints.push_back(JointKind::kCorner);
    }
  }
  // Where two parts meet, the width of the first one is kept.
  void add_width(double u, double width_mm) {
    if (data_.widths.empty() || u > data_.widths.back().u) {
      data_.widths.push_back({u, std::max(width_mm, kMinWidthMm)});
    }
  }

  StrokeData data_;
  bool after_straight_ = false;
};

InkOfPoints::InkOfPoints(const InkFitOptions& fit, double width_tolerance_mm)
    : fit_(fit),
      width_tolerance_mm_(width_tolerance_mm),
      pencil_(fit),
      ruler_(drawn_line_options()) {}

Result<StrokeData> InkOfPoints::of_samples(std::span<const InkSample> samples) {
  return of_samples(samples, fit_.width_map);
}

Result<StrokeData> InkOfPoints::of_samples(std::span<const InkSample> samples,
                                           const WidthMapOptions& widths) {
  pencil_.begin();
  for (const InkSample& sample : samples) pencil_.push(sample);
  pencil_.end();
  pencil_.refine();
  if (pencil_.curve().points.empty()) {
    return fail(ErrorCode::kInvalidData, "none of its points has usable coordinates");
  }
  Result<Stroke> stroke = pencil_.stroke(widths);
  if (!stroke) return tl::unexpected(stroke.error());
  return StrokeData(stroke->data());
}

Result<StrokeData> InkOfPoints::of_line(std::span<const WidePoint> line) {
  line_.clear();
  for (const WidePoint& p : line) {
    if (is_usable(p)) line_.push_back({p.position, std::max(p.width_mm, kMinWidthMm)});
  }
  if (line_.empty()) {
    return fail(ErrorCode::kInvalidData, "none of its points has usable coordinates");
  }
  Pieces pieces;
  const auto end_run = [&]() -> Result<void> {
    if (run_.size() < 2 && !(pieces.empty() && line_.size() == 1)) return {};
    Result<StrokeData> run = fitted_run();
    if (!run) return tl::unexpected(run.error());
    pieces.add_fitted(*std::move(run));
    return {};
  };
  run_.assign(1, line_.front());
  for (std::size_t i = 1; i < line_.size(); ++i) {
    const WidePoint &from = line_[i - 1], &to = line_[i];
    const double length = distance(from.position, to.position);
    const bool ruled = length > (inserted_ < kMaxInserted ? kRuledMm : kMinRuledMm);
    if (!ruled && run_.size() < kLongestRun) {
      add_between(from, to);
      continue;
    }
    if (!ruled) {
      if (Result<void> done = end_run(); !done) return tl::unexpected(done.error());
      run_.assign(1, from);
      add_between(from, to);
      continue;
    }
    if (Result<void> done = end_run(); !done) return tl::unexpected(done.error());
    pieces.add_straight(from, to);
    run_.assign(1, to);
  }
  if (Result<void> done = end_run(); !done) return tl::unexpected(done.error());
  const bool is_ring = line_.size() > 3 && line_.front().position == line_.back().position;
  Result<StrokeData> whole = std::move(pieces).finish(is_ring ? 4.0 * kDrawnLineToleranceMm : 0.0);
  if (whole) whole->medium = fit_.medium;
  return whole;
}

// Appends `to` to the run, after points on the straight line to it, so that the fitted curve cannot
// leave that line.
void InkOfPoints::add_between(const WidePoint& from, const WidePoint& to) {
  if (inserted_ < kMaxInserted) {
    line_steps(distance(from.position, to.position), kFirstStepMm, kMaxStepMm, steps_);
    for (const double t : steps_) {
      run_.push_back(
          {lerp(from.position, to.position, t), from.width_mm + t * (to.width_mm - from.width_mm)});
    }
    inserted_ += steps_.size();
  }
  run_.push_back(to);
}

Result<StrokeData> InkOfPoints::fitted_run() {
  ruler_.begin();
  for (const WidePoint& p : run_) ruler_.push({p.position, {}, {}});
  ruler_.end();
  ruler_.refine();
  const FittedCurve& curve = ruler_.curve();
  const auto widest = std::max_element(run_.begin(), run_.end(), [](const auto& a, const auto& b) {
    return a.width_mm < b.width_mm;
  });
  WidthFitter width({.tolerance_mm = width_tolerance_mm_, .max_mm = widest->width_mm});
  for (std::size_t i = 0; i < run_.size(); ++i) width.push(curve.sample_u[i], run_[i].width_mm);
  width.finish(curve.segment_count());
  StrokeData data = data_of(curve);
  data.widths.assign(width.knots().begin(), width.knots().end());
  return data;
}

}  // namespace felt
