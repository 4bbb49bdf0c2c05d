#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "felt/stroke/fit/run_moments.h"
#include "felt/stroke/fit/sample_window.h"
#include "felt/stroke/fit/segment_fit.h"

namespace felt {

/// Finds how far one cubic can go: the longest run of a window's samples from a given start that
/// SegmentFit accepts, in small steps of bounded work, so that it can follow a pen. LongRun goes on
/// where the window ends.
///
///   1. gate: as long as the moments prove that the run is within the tolerance, a sample costs
///      one update (RunMoments);
///   2. gallop: then exact fits, each a quarter longer than the last good one;
///   3. bisect: after the first that fails, halve the gap to the last good one until it is within
///      a sixteenth of the run. The last few samples of a run are given to the next segment
///      anyway, where a joint has samples on both sides.
///
/// Use: begin(); step() until it says kDone; then count(), curve(), parameters().
class RunSearch {
 public:
  enum class Status {
    kNeedSamples,  ///< all samples offered are used; call again when there are more
    kBusy,         ///< one step of work done, more to do
    kDone,         ///< the run is found
  };

  /// Accepts only runs within the tolerance of `guide` (SegmentFit::set_guide).
  void set_guide(const GuideCurve* guide) noexcept { fit_.set_guide(guide); }

  /// True unless the run is a bridge, for want of any fit, that leaves the guide.
  [[nodiscard]] bool is_close_to_guide() const noexcept { return is_close_to_guide_; }

  /// Starts a search at sample `first` of the window. On a free start that sample is the first of
  /// the curve, else it is the one after the joint.
  void begin(const SampleWindow& window, const RunStart& start, std::size_t first) noexcept;

  /// Does one step: some gate updates or one exact fit. Samples before `limit` may be used;
  /// `is_final` says that there will be no more of them for this run (a corner, the end of the
  /// stroke). Requires limit > first.
  Status step(const SampleWindow& window, std::size_t limit, bool is_final) noexcept;

  /// The start, after begin().
  [[nodiscard]] const RunStart& start() const noexcept { return start_; }
  [[nodiscard]] std::size_t first() const noexcept { return first_; }
  /// Samples in the best run so far; 0 before the first exact fit.
  [[nodiscard]] std::size_t count() const noexcept { return good_; }
  /// Its curve, and the parameters of its samples.
  [[nodiscard]] const Cubic& curve() const noexcept { return curve_; }
  [[nodiscard]] std::span<const double> parameters() const noexcept { return {t_.data(), good_}; }

  /// Replaces the run found by one with the same samples that begins or ends exactly on its first
  /// or last sample, if that is within the tolerance. For the ends of a stroke.
  void pin(const SampleWindow& window, bool start, bool end) noexcept;

  /// Where the run found is shorter than a segment may be (I5), goes straight to the first sample
  /// that is far enough from the start, or to the last one offered. All samples between are within
  /// kMinSegmentMm of the start, so the tolerance holds. After kDone; may change count().
  void ensure_length(const SampleWindow& window) noexcept;

  /// Makes room in a window that the run found fills, and takes the search up again: of its samples
  /// those farthest to either side of the curve stay, so what a longer run misses is seen on them
  /// first. Requires kDone, first() == 0 and count() == SegmentFit::kMaxRun == window.size().
  void thin(SampleWindow& window) noexcept;

  /// Work since construction, in samples x rounds of exact fits.
  [[nodiscard]] long work() const noexcept { return fit_.work(); }

 private:
  enum class Phase { kGate, kGallop, kBisect, kDone };

  Status run_gate(const SampleWindow& window, std::size_t available, bool is_final) noexcept;
  Status run_gallop(const SampleWindow& window, std::size_t available, bool is_final) noexcept;
  Status run_bisect(const SampleWindow& window) noexcept;
  bool try_count(const SampleWindow& window, std::size_t count) noexcept;
  void keep_fit(std::size_t count) noexcept;
  [[nodiscard]] std::span<const double> known(const SampleWindow& window) const noexcept;
  void bridge(const SampleWindow& window) noexcept;
  [[nodiscard]] std::size_t least_count() const noexcept;

  RunStart start_;
  std::size_t first_ = 0;
  Phase phase_ = Phase::kDone;
  RunMoments moments_;
  double lead_mm_ = 0.0;     // from the start point to sample `first`
  double tightest_ = 0.0;    // largest inverse limit in the gate
  std::size_t gated_ = 0;    // samples in the moments
  std::size_t proven_ = 0;   // longest run that the gate accepted
  std::size_t good_ = 0;     // longest run that the exact fit accepted
  std::size_t next_ = 0;     // next run to try
  std::size_t bad_ = 0;      // shortest run that failed
  std::size_t offered_ = 0;  // samples that may be used
  bool is_close_to_guide_ = true;
  SegmentFit fit_;
  Cubic curve_{};
  std::array<double, SegmentFit::kMaxRun> t_{};
};

}  // namespace felt
