#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "felt/base/histogram.h"
#include "felt/geometry/bvh.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt::cli {

/// The counts of `fit --stats`. The counts of several workers can be added.
struct FitStats {
  std::int64_t strokes = 0;
  std::int64_t samples = 0;
  std::int64_t segments = 0;
  std::int64_t corners = 0;
  double max_error_mm = 0.0;  ///< largest distance from a sample to the curve
  double error_sum_mm = 0.0;
  std::int64_t fit_ns = 0;       ///< thread CPU time from pen-down to pen-up
  std::int64_t refine_ns = 0;    ///< thread CPU time of the refinement
  std::int64_t allocations = 0;  ///< allocations while samples are added, after warm-up
  Histogram calls;               ///< thread CPU time of each call that adds one sample

  void add(const FitStats& other) noexcept;
};

/// Returns the counts as one line of JSON, which `fit --stats` prints.
std::string stats_json(const FitStats& stats);

/// Returns `sum` / `count`, or 0 if `count` is 0.
double per(double sum, std::int64_t count) noexcept;

/// Returns the CPU time of the calling thread in ns. Time in which other programs run is not
/// counted.
std::int64_t thread_cpu_ns() noexcept;

/// Measures the cost of fitting one stroke, and how closely the curve follows the samples.
class StrokeMeter {
 public:
  explicit StrokeMeter(const InkFitOptions& options);

  /// Measures the time of each call that adds one sample to the fitter, and counts the allocations
  /// in these calls.
  ///
  /// The stroke is fitted kRuns times, and the shortest time of each call is used. A call does the
  /// same work in each run, so additional time is caused by the machine (interrupts, cold caches).
  /// Allocations are counted in the last run, when the buffers have reached their final size; the
  /// count should then be 0.
  void measure_calls(std::span<const InkSample> samples, FitStats& stats);

  /// Adds to `stats` the distance from each sample to the nearest point of the whole curve.
  void measure_error(std::span<const InkSample> samples, const Stroke& stroke, FitStats& stats);

 private:
  static constexpr int kRuns = 3;
  void run(std::span<const InkSample> samples, std::int64_t& allocations);

  InkFitter fitter_;
  std::int64_t clock_cost_ns_;
  std::vector<std::int64_t> min_ns_;  // shortest time for each sample of one stroke
  std::vector<BvhSegment> segments_;
  SegmentBvh tree_;
};

}  // namespace felt::cli
