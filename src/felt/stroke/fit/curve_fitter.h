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

/// Appends the place of each of the samples on `segment`. They are a hair apart, so that a width
/// may change where the pen rests (R15): as far as the next place `next_u` and the reserve in the
/// tolerance (KeptSamples::kReserve) allow.
void append_sample_places(const SamplePlace& place, double next_u, const Cubic& segment,
                          double tolerance_mm, std::vector<double>& sample_u);

/// Fits joined cubics to the samples of a pen while it draws.
///
/// Greedy: from the last joint, LongRun finds how far one cubic can go; the joint is then put at
/// kReach of that run, a place with samples on both sides, where the long fit's position and
/// tangent are well determined (its far end is where it is about to break). The next segment takes
/// over both, so smooth joints are G1 exactly. A run never passes a corner (CornerDetector): there
/// a segment ends and the next starts with a tangent of its own.
///
///      o--o--o--o--o--o--o--o--o--o            samples
///      |===== run, one cubic ======|           longest within the tolerance
///      |== committed ======|                   never changes again
///                          |=== next run ...   same place, same tangent
///
/// How fast the pen goes makes no difference: nearer samples are merged (R3), and a run may have
/// any number of them. Before a segment is committed every kept sample has its place on it
/// (RunPlacer).
///
/// Stroke ends and corners lie exactly on their samples where the tolerance allows.
///
/// Work of one push() is bounded by kMaxWorkPerPush, whatever the stroke; a search that needs more
/// goes on with the next sample. No allocation after warm-up.
/// The result depends on the order of the samples only (R7). Thread: one.
class CurveFitter {
 public:
  /// The joint is put at this part of the longest run.
  static constexpr double kReach = 0.8;
  /// Resolution of the devices of the paper [Paper section 2: PHANToM, 0.03 mm], and the threshold
  /// that the specification gives data points. Between the two it is a part of the tolerance.
  static constexpr double kResolutionMm = 0.03;
  static constexpr double kDataPointMm = 0.25;
  static constexpr double kSpacing = 0.125;
  /// Never more than this part of it: what merged samples take off the tolerance, the curve lacks.
  static constexpr double kMaxSpacing = 0.2;
  /// A sample becomes a data point if it is farther than this from the last one (R3); others are
  /// merged into that one (KeptSamples). 0.03 mm at the default tolerance.
  static constexpr double spacing_mm(double tolerance_mm) noexcept {
    return std::min(std::clamp(kSpacing * tolerance_mm, kResolutionMm, kDataPointMm),
                    kMaxSpacing * tolerance_mm);
  }
  /// Work of one push, in samples x rounds of the fit: about 10 microseconds.
  static constexpr long kWorkPerPush = 1000;
  /// A push stops when kWorkPerPush is exceeded, so this is the most that it does: one step more,
  /// which is an exact fit, the fits of a commit, or the places of some samples.
  static constexpr long kMaxWorkPerPush = kWorkPerPush + 4 * SegmentFit::kMaxWork;

  explicit CurveFitter(const CurveFitOptions& options);

  /// Forgets the last stroke and starts one.
  void begin() noexcept;
  /// Takes the next sample. Requires finite coordinates of at most 1e9 mm.
  void push(Point p);
  /// Pen-up: completes the curve. A stroke within kMinSegmentMm becomes one segment of about that
  /// length (R10). Without a sample the curve stays empty.
  void end();

  /// Number of committed segments; they never change. After end() all of them.
  [[nodiscard]] int segment_count() const noexcept {
    return points_.empty() ? 0 : static_cast<int>(points_.size() / 3);
  }
  /// Committed segment i.
  [[nodiscard]] Cubic segment(int i) const noexcept;
  /// Kind of the joint before committed segment i, 0 < i < segment_count().
  [[nodiscard]] JointKind joint(int i) const noexcept {
    return joints_[static_cast<std::size_t>(i - 1)];
  }
  /// Places of the samples that the committed segments cover, in order. While a long run is placed,
  /// the first samples of the next segment follow; those may still change.
  [[nodiscard]] const ChunkedVector<SamplePlace>& places() const noexcept { return places_; }
  /// Provisional segments from the last committed joint to the newest sample, for display while
  /// drawing: the best run so far and straight lines beyond it. Appends to `tail`.
  void append_live_tail(std::vector<Cubic>& tail) const;
  /// Work since construction, in samples x rounds of exact fits and samples placed.
  [[nodiscard]] long work() const noexcept { return work_ + run_.work(); }
  /// A copy of the committed curve.
  [[nodiscard]] FittedCurve curve() const;
  /// The same, into the buffers of `curve`.
  void copy_to(FittedCurve& curve) const;

 private:
  /// What is done with the open run.
  enum class Phase {
    kWait,    ///< for its first samples
    kSearch,  ///< finds out how far it goes
    kPlace,   ///< places its samples on the segment that it becomes
  };
  /// The segment that is committed next.
  struct Candidate {
    Cubic segment{};
    std::size_t last = 0;   // kept sample at its end
    bool is_whole = false;  // it ends with the run, on that sample
    Vec end_tangent;        // else: of the next one
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
  std::size_t placed_before_ = 0;  // places of the committed segments
  long work_ = 0;
  bool ended_ = false;
  RunStart::Kind next_kind_ = RunStart::Kind::kFree;
  Vec next_tangent_;
  std::size_t next_first_ = 0;  // first sample of the open run
  std::size_t scanned_ = 0;     // no corner in the open run before it
  bool at_corner_ = false;      // the sample before scanned_ is a corner
  ChunkedVector<Point> points_;
  ChunkedVector<JointKind> joints_;
  ChunkedVector<SamplePlace> places_;
};

/// Where to cut a run that one cubic covers: the index into its parameters of the sample that
/// becomes the joint, near `reach` of the run, on a stretch that moves (so that the tangent there
/// means something) and far enough along for a segment. Requires a run of at least one sample.
std::size_t choose_joint(const Cubic& curve, std::span<const double> parameters,
                         double reach) noexcept;
/// The same near the parameter of this index.
std::size_t choose_joint_near(const Cubic& curve, std::span<const double> parameters,
                              std::size_t middle) noexcept;

}  // namespace felt
