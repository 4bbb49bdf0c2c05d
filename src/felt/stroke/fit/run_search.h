#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "felt/stroke/fit/run_moments.h"
#include "felt/stroke/fit/sample_window.h"
#include "felt/stroke/fit/segment_fit.h"

namespace felt {

/// Finds how far one cubic can go. A run is a sequence of consecutive samples in a window, fitted
/// by one cubic; this class finds the longest run from a given start that SegmentFit accepts. It
/// works in small steps of bounded work, so that it keeps up with a pen. LongRun continues beyond
/// the end of the window.
///
///   1. Gate: as long as the sums of RunMoments prove that the run is within the tolerance, a
///      sample only takes one update of these sums.
///   2. Gallop: runs are fitted exactly, each a quarter longer than the last accepted one. If the
///      window was thinned, the run of all its samples is tried immediately.
///   3. Bisect: after the first run that fails, the gap between the shortest failed and the longest
///      accepted run is halved until it is at most a sixteenth of the accepted run. Greater
///      precision is not needed, because the last samples of a run go to the next segment anyway.
///
/// Use: begin(); step() until it returns kDone; then count(), curve(), parameters().
class RunSearch {
 public:
  enum class Status {
    kNeedSamples,  ///< all available samples are used; call again when more have arrived
    kBusy,         ///< one step was done; call step() again
    kDone,         ///< the run is found
  };

  /// Sets a guide: the search then accepts only runs whose curve is within the tolerance of `guide`
  /// (SegmentFit::set_guide).
  void set_guide(const GuideCurve* guide) noexcept { fit_.set_guide(guide); }

  /// Returns false only if the best run is a bridge (SegmentFit::bridge) that is not within the
  /// tolerance of the guide. Fitted runs are always within it.
  [[nodiscard]] bool is_close_to_guide() const noexcept { return is_close_to_guide_; }

  /// Starts a search at sample `first` of the window. If the start is free, that sample is the
  /// first of the curve; otherwise it is the sample after the joint.
  void begin(const SampleWindow& window, const RunStart& start, std::size_t first) noexcept;

  /// Does one step: some gate updates or one exact fit. Samples before `limit` may be used.
  /// `is_final` means that no more samples follow for this run, because of a corner or the end of
  /// the stroke. Requires limit > first.
  Status step(const SampleWindow& window, std::size_t limit, bool is_final) noexcept;

  /// Returns the start and the first sample given to begin(). pin() may change the start.
  [[nodiscard]] const RunStart& start() const noexcept { return start_; }
  [[nodiscard]] std::size_t first() const noexcept { return first_; }
  /// Returns the number of samples in the best run so far; 0 before the first exact fit.
  [[nodiscard]] std::size_t count() const noexcept { return good_; }
  /// Return the curve of the best run, and the parameters of its samples.
  [[nodiscard]] const Cubic& curve() const noexcept { return curve_; }
  [[nodiscard]] std::span<const double> parameters() const noexcept { return {t_.data(), good_}; }

  /// Replaces the curve of the best run with a curve that begins exactly on the first sample (if
  /// `start` is true and the start is free) and ends exactly on the last sample (if `end` is true).
  /// If no such curve is accepted, pins only the start, or else only the end, or else changes
  /// nothing. Call it at the ends of a stroke.
  void pin(const SampleWindow& window, bool start, bool end) noexcept;

  /// If the best run is shorter than a segment may be (I5), replaces it with a bridge
  /// (SegmentFit::bridge) to the first sample that is far enough from the start, or to the last
  /// available one. All samples between are within kMinSegmentMm of the start, so the bridge keeps
  /// the tolerance. Call it after kDone. May change count().
  void ensure_length(const SampleWindow& window) noexcept;

  /// Removes samples from the window and resumes the search. Call it if the best run fills the
  /// whole window. The samples farthest to either side of the curve stay, because the curve of a
  /// longer run would first exceed the tolerance at these samples. Requires kDone, first() == 0 and
  /// count() == SegmentFit::kMaxRun == window.size().
  void thin(SampleWindow& window) noexcept;

  /// Returns the work since construction, in samples x rounds of exact fits.
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
  [[nodiscard]] std::size_t min_count() const noexcept;

  RunStart start_;
  std::size_t first_ = 0;
  Phase phase_ = Phase::kDone;
  RunMoments moments_;
  double lead_mm_ = 0.0;     // distance from the start point to sample first_
  double tightest_ = 0.0;    // largest inverse limit of the samples in the gate
  std::size_t gated_ = 0;    // number of samples added to moments_
  std::size_t proven_ = 0;   // size of the longest run that the gate accepted
  std::size_t good_ = 0;     // size of the longest run that was fitted
  std::size_t next_ = 0;     // size of the next run to try
  std::size_t bad_ = 0;      // size of the shortest run that failed
  std::size_t offered_ = 0;  // number of samples that may be used
  bool is_close_to_guide_ = true;
  SegmentFit fit_;
  Cubic curve_{};
  std::array<double, SegmentFit::kMaxRun> t_{};
};

}  // namespace felt
