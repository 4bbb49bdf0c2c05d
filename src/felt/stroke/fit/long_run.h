#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "felt/stroke/fit/kept_samples.h"
#include "felt/stroke/fit/run_search.h"
#include "felt/stroke/fit/sample_window.h"

namespace felt {

/// Finds the longest run, that is, consecutive kept samples of a stroke that one cubic fits. A run
/// may have any number of samples, because a slow stroke has more samples but the same curve.
///
/// RunSearch looks at a window of at most SegmentFit::kMaxRun samples. When the run fills the
/// window, samples are removed from the window (RunSearch::thin) and the search continues with the
/// samples that follow. In that case the result is proven only for the samples in the window;
/// RunPlacer proves it for all samples. If the curve misses a sample, call search_again(), which
/// holds that sample in the window. If search_again() returns false, call begin() with
/// Detail::kEverySample: such a run ends at the end of the window and needs no proof.
///
/// One step() takes at most kMaxRun additions to the window and one step of RunSearch. Nothing is
/// allocated.
class LongRun {
 public:
  enum class Detail {
    kThinned,      ///< any length; samples may be left out of the search
    kEverySample,  ///< at most SegmentFit::kMaxRun samples, all of them in the window
  };

  /// Maximum number of samples that search_again() can hold in the window.
  static constexpr std::size_t kMaxHeld = 16;

  LongRun() : window_(SegmentFit::kMaxRun) {}

  /// Accepts only runs within the tolerance of `guide` (SegmentFit::set_guide).
  void set_guide(const GuideCurve* guide) noexcept { search_.set_guide(guide); }
  [[nodiscard]] bool is_close_to_guide() const noexcept { return search_.is_close_to_guide(); }

  /// Starts a search at kept sample `first`, as RunSearch::begin() does.
  void begin(const KeptSamples& kept, const RunStart& start, std::size_t first,
             Detail detail = Detail::kThinned) noexcept;
  /// Starts the same search again and always keeps the samples a and b in the window. Returns
  /// false, and does nothing, if more than kMaxHeld samples would be held.
  bool search_again(const KeptSamples& kept, std::size_t a, std::size_t b) noexcept;
  /// Does one step. Kept samples before `limit` may be used. `is_final` means that no more samples
  /// follow for this run. Requires limit > first().
  RunSearch::Status step(const KeptSamples& kept, std::size_t limit, bool is_final) noexcept;
  /// Ensure the minimum length of a segment, and pin the ends to their samples (see RunSearch).
  void ensure_length() noexcept { search_.ensure_length(window_); }
  void pin(bool start, bool end) noexcept { search_.pin(window_, start, end); }

  [[nodiscard]] const RunStart& start() const noexcept { return search_.start(); }
  /// Return the first kept sample of the run, and one past the last. The two are equal before the
  /// first exact fit.
  [[nodiscard]] std::size_t first() const noexcept { return first_; }
  [[nodiscard]] std::size_t end() const noexcept {
    return count() == 0 ? first_ : source(count() - 1) + 1;
  }
  /// Return the number of window samples in the run, their parameters, and the index that window
  /// sample i has among the kept samples.
  [[nodiscard]] std::size_t count() const noexcept { return search_.count(); }
  [[nodiscard]] std::span<const double> parameters() const noexcept { return search_.parameters(); }
  [[nodiscard]] std::size_t source(std::size_t i) const noexcept { return window_.source(i); }
  [[nodiscard]] const Cubic& curve() const noexcept { return search_.curve(); }
  /// Returns the work since construction, in samples x rounds of exact fits.
  [[nodiscard]] long work() const noexcept { return search_.work(); }

 private:
  void restart(const KeptSamples& kept) noexcept;
  void add_next(const KeptSamples& kept) noexcept;

  SampleWindow window_;
  RunSearch search_;
  RunStart start_;
  std::array<std::size_t, kMaxHeld> held_{};
  std::size_t held_count_ = 0;
  Detail detail_ = Detail::kThinned;
  std::size_t first_ = 0;
  std::size_t next_ = 0;  // index of the kept sample to add to the window next
};

/// Assigns parameters on a run's curve to its kept samples, one after the other, including those
/// that are not in the window. This proves that each sample is within its limit, in order.
class RunPlacer {
 public:
  /// Starts at the first sample of `run`. `curve` is the part of the run's curve from 0 to
  /// parameter `end`.
  void begin(const LongRun& run, const Cubic& curve, double end) noexcept;
  /// Returns the kept sample to place next.
  [[nodiscard]] std::size_t next() const noexcept { return next_; }
  /// Places that sample and returns its parameter, which is not less than that of the previous
  /// sample. Returns nullopt if the sample is outside its limit. Requires next() < run.end().
  std::optional<double> place(const LongRun& run, const KeptSamples& kept) noexcept;
  /// Returns the placed sample that is furthest along the curve. Later samples must not lie before
  /// it.
  [[nodiscard]] std::size_t furthest() const noexcept { return furthest_sample_; }

 private:
  [[nodiscard]] double foot_between(const LongRun& run, Point p) const noexcept;

  Cubic curve_{};
  double scale_ = 1.0;
  std::size_t next_ = 0;
  std::size_t in_window_ = 0;  // first window sample that is not before next_
  double furthest_ = 0.0;
  std::size_t furthest_sample_ = 0;
};

}  // namespace felt
