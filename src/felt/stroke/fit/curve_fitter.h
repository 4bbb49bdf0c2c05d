#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/base/chunked_vector.h"
#include "felt/geometry/cubic.h"
#include "felt/stroke/fit/corner_detector.h"
#include "felt/stroke/fit/ink_fit.h"
#include "felt/stroke/fit/kept_samples.h"
#include "felt/stroke/fit/long_run.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Appends one stroke parameter on `segment` for each sample that `place` represents. The
/// parameters increase slightly from sample to sample, so that the width can change while the pen
/// rests (R15). They do not exceed `next_u`, the next parameter. Between the first and the last of
/// these parameters, the curve moves by less than the reserve in the tolerance
/// (KeptSamples::kReserve).
void append_sample_places(const SamplePlace& place, double next_u, const Cubic& segment,
                          double tolerance_mm, std::vector<double>& sample_u);

/// Fits joined cubics to the samples of a pen while it draws.
///
/// The fitter is greedy: from the last joint on, LongRun finds the longest run of samples that one
/// cubic fits. The next joint is put at the fraction kReach of that run. At the joint, the long fit
/// has samples on both sides, so the position and tangent of its curve are well determined there;
/// at the end of the run they are not. The next segment starts with this position and tangent, so
/// smooth joints are G1 exactly. A run never passes a corner (CornerDetector): the segment ends at
/// the corner, and the next segment starts there with a new tangent.
///
///      o--o--o--o--o--o--o--o--o--o            samples
///      |===== run, one cubic ======|           longest within the tolerance
///      |== committed ======|                   never changes again
///                          |=== next run ...   same point, same tangent
///
/// The speed of the pen makes no difference: samples close to each other are merged (R3), and a run
/// may have any number of samples. Every kept sample gets its parameter on a segment before the
/// segment is committed (RunPlacer).
///
/// Stroke ends and corners lie exactly on their samples if the tolerance allows.
///
/// The work of one push() is at most kMaxWorkPerPush for any stroke; a search that needs more
/// continues with the next sample. Does not allocate after warm-up. The result depends only on the
/// samples and their order (R7). Not thread-safe: use it from one thread at a time.
class CurveFitter {
 public:
  /// The joint is put at this fraction of the longest run.
  static constexpr double kReach = 0.8;
  /// Bounds of the spacing of data points: the resolution of the paper's devices [Paper section 2:
  /// PHANToM, 0.03 mm], and the threshold of docs/design/strokes.md#data-points. Between these
  /// bounds the spacing is the fraction kSpacing of the tolerance.
  static constexpr double kResolutionMm = 0.03;
  static constexpr double kDataPointMm = 0.25;
  static constexpr double kSpacing = 0.125;
  /// Maximum spacing as a fraction of the tolerance. It is limited because the distance to merged
  /// samples is subtracted from the tolerance of the curve.
  static constexpr double kMaxSpacing = 0.2;
  /// Returns the spacing of data points in mm. A sample becomes a data point if its distance from
  /// the last data point is greater than the spacing (R3); other samples are merged into that data
  /// point (KeptSamples). At the default tolerance, the spacing is 0.03 mm.
  static constexpr double spacing_mm(double tolerance_mm) noexcept {
    return std::min(std::clamp(kSpacing * tolerance_mm, kResolutionMm, kDataPointMm),
                    kMaxSpacing * tolerance_mm);
  }
  /// Work of one push, in samples x rounds of the fit. This work takes about 10 microseconds.
  static constexpr long kWorkPerPush = 1000;
  /// Upper bound of the work of one push. A push stops after the step that exceeds kWorkPerPush; a
  /// step is an exact fit, the fits of a commit, or placing some samples.
  static constexpr long kMaxWorkPerPush = kWorkPerPush + 4 * SegmentFit::kMaxWork;

  explicit CurveFitter(const CurveFitOptions& options);

  /// Discards the last stroke and starts a new one.
  void begin() noexcept;
  /// Adds the next sample. Requires finite coordinates of at most 1e9 mm.
  void push(Point p);
  /// Completes the curve. Called at pen-up. A stroke that stays within kMinSegmentMm becomes one
  /// segment of about that length (R10). If no sample was added, the curve stays empty.
  void end();

  /// Returns the number of committed segments, which never change. After end(), all segments are
  /// committed.
  [[nodiscard]] int segment_count() const noexcept {
    return points_.empty() ? 0 : static_cast<int>(points_.size() / 3);
  }
  /// Returns committed segment i.
  [[nodiscard]] Cubic segment(int i) const noexcept;
  /// Returns the kind of the joint before committed segment i, 0 < i < segment_count().
  [[nodiscard]] JointKind joint(int i) const noexcept {
    return joints_[static_cast<std::size_t>(i - 1)];
  }
  /// Returns the positions of the samples that the committed segments cover, in order. While the
  /// samples of a long run are being placed, positions on the next segment come after them; these
  /// positions may still change.
  [[nodiscard]] const ChunkedVector<SamplePlace>& places() const noexcept { return places_; }
  /// Appends to `tail` provisional segments from the last committed joint to the newest sample, for
  /// display while drawing: the best run so far, and straight lines beyond it.
  void append_live_tail(std::vector<Cubic>& tail) const;
  /// Returns the work since construction: samples x rounds of exact fits, plus samples placed.
  [[nodiscard]] long work() const noexcept { return work_ + run_.work(); }
  /// Returns a copy of the committed curve.
  [[nodiscard]] FittedCurve curve() const;
  /// Copies the committed curve into `curve` and reuses its buffers.
  void copy_to(FittedCurve& curve) const;

 private:
  /// State of the open run.
  enum class Phase {
    kWait,    ///< waits for the first samples of the run
    kSearch,  ///< searches for the end of the longest run
    kPlace,   ///< assigns the samples of the run their parameters on its segment
  };
  /// The segment that is committed next.
  struct Candidate {
    Cubic segment{};
    std::size_t last = 0;   // last kept sample of the segment
    bool is_whole = false;  // true if the segment is the whole run
    Vec end_tangent;        // otherwise: the tangent at which the run is cut
  };

  void advance(long work);
  bool start_search();
  void scan_for_corner() noexcept;
  void finish_run() noexcept;
  void propose_whole() noexcept;
  void propose_cut(std::size_t count) noexcept;
  void place_some();
  void retry_before(std::size_t sample) noexcept;
  void commit();
  void add_dot();

  KeptSamples kept_;
  CornerDetector corners_;
  LongRun run_;
  RunPlacer placer_;
  Candidate candidate_;
  Phase phase_ = Phase::kWait;
  LongRun::Detail detail_ = LongRun::Detail::kThinned;
  std::size_t placed_before_ = 0;  // size of places_ at the last commit
  long work_ = 0;
  bool ended_ = false;
  RunStart::Kind next_kind_ = RunStart::Kind::kFree;
  Vec next_tangent_;
  std::size_t next_first_ = 0;  // first sample of the open run
  std::size_t scanned_ = 0;     // the open run may use the samples before this one
  bool at_corner_ = false;      // the sample before scanned_ is a corner, where the run ends
  ChunkedVector<Point> points_;
  ChunkedVector<JointKind> joints_;
  ChunkedVector<SamplePlace> places_;
};

/// Returns where to cut a run that one cubic covers: the index into `parameters` of the sample that
/// becomes the joint. Prefers samples near the fraction `reach` of the run. At the chosen sample,
/// the curve moves fast enough for a well-determined tangent, and the part before it is long enough
/// for a segment. If there is no such sample, the last sample becomes the joint. Requires at least
/// one sample.
std::size_t choose_joint(const Cubic& curve, std::span<const double> parameters,
                         double reach) noexcept;
/// Does the same, but prefers samples near the index `middle`.
std::size_t choose_joint_near(const Cubic& curve, std::span<const double> parameters,
                              std::size_t middle) noexcept;

}  // namespace felt
