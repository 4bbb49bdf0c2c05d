#pragma once

#include <cstddef>
#include <vector>

#include "felt/geometry/cubic.h"
#include "felt/stroke/fit/curve_fitter.h"

namespace felt {

/// The curve fit of the paper, kept as a separate mode for study and comparison (R6).
///
/// Points are added to the current segment while its error stays within a threshold. Otherwise a
/// new segment starts, and "for smoothness two successive segments share a number of points". We
/// read the text as follows:
///   - "a threshold" decides which samples are data points: a sample nearer than `data_point_mm` to
///     the last data point is skipped, unless it is the last sample of the stroke. So slow drawing
///     adds no segments.
///   - [Paper eq. 2, docs/design/errata.md#e7] a segment fitted to the points P_1..P_n runs from B1
///     = P_(1+s) to B4 = P_(n-s); neighbours share 2s + 1 samples, and the joint is the middle one
///     of these, so the curve is exactly C0. The first segment starts at its P_1 and the last one
///     ends at its P_n.
///   - B2 and B3 are the least-squares solution over P_1..P_n at chord-length parameters, 0 at B1
///     and 1 at B4. The s samples beyond each end have parameters below 0 or above 1. They
///     influence the handles, although the segment does not cover them.
///   - [docs/design/errata.md#e9] the tolerance limits the distance from the segment to each data
///     point that it draws. The distance is measured at the parameter of the data point, after one
///     Newton step towards the nearest point of the segment.
///
/// Sharing samples does not make joints smooth (docs/design/errata.md#e8): their tangents differ by
/// 3 to 10 degrees. A joint is declared kSmooth only if the tangents agree to kSmoothJointMaxDeg,
/// otherwise kCorner.
///
///      P: o--o--o--o--o--o--o--o--o--o--o--o      s = 2
///         B1===================B4                 first segment, fitted to the first 9
///                     |--------|--------|         shared: 2s + 1 = 5
///                              B1==========...    second segment
///
/// Use: begin(); push() for each point; end(). For each new sample, the whole run (the samples of
/// the current segment) is fitted again, so the work per sample is bounded only by the longest run,
/// kMaxRun samples. Therefore this class is for study, not for drawing with a device.
class PaperFitter {
 public:
  /// Maximum number of steps from sample to sample in one segment.
  static constexpr std::size_t kMaxRun = 400;

  /// `shared_samples` is s of [Paper eq. 2]. Requires shared_samples >= 0.
  PaperFitter(const CurveFitOptions& options, int shared_samples,
              double data_point_mm = CurveFitter::kDataPointMm);

  /// Discards the last stroke and starts a new one.
  void begin();
  /// Adds the next point, in mm. Requires finite coordinates.
  void push(Point p);
  /// Fits the remaining points. Called at pen-up. A stroke that stays within kMinSegmentMm becomes
  /// one straight segment of that length (R10). If no point was added, the curve stays empty.
  void end();
  /// Returns the segments so far; complete after end(). `sample_u` contains the parameters of the
  /// data points until end(), then those of all samples; a sample between two data points has a
  /// parameter between theirs. No segment has a chord shorter than kMinSegmentMm (I5), so the curve
  /// may stop up to that distance before the end of the stroke if the tolerance is smaller.
  [[nodiscard]] const FittedCurve& curve() const noexcept { return curve_; }

 private:
  /// One segment that draws the samples from..to, both ends included.
  struct Run {
    std::size_t from = 0, to = 0;
    Cubic cubic;
    std::vector<double> t;  ///< parameter of each drawn sample, non-decreasing
  };

  void grow_to(std::size_t to);
  bool fit_within(Run& run) const;
  double fit(Run& run) const;
  double place_samples(Run& run) const;
  void commit(const Run& run);
  void uncommit_last();
  void absorb_tail();
  void add_dot();
  void add_point(Point p);
  void place_merged();

  double tolerance_mm_;
  std::size_t shared_;
  double data_point_mm_;
  std::vector<std::size_t> merged_;  // number of merged samples after each data point
  Point newest_;
  std::vector<Point> points_;
  std::vector<double> path_mm_;    // path length along the chords from the first point
  Run good_, trial_;               // longest run within the tolerance; the one being tried
  std::vector<std::size_t> ends_;  // sample index of each joint so far, the start included
  FittedCurve curve_;
};

}  // namespace felt
