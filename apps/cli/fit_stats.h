#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "felt/base/histogram.h"
#include "felt/geometry/bvh.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt::cli {

/// The counts of `fit --stats`. Those of several workers can be added.
struct FitStats {
  std::int64_t strokes = 0;
  std::int64_t samples = 0;
  std::int64_t segments = 0;
  std::int64_t corners = 0;
  double max_error_mm = 0.0;  ///< largest distance from a sample to the curve
  double error_sum_mm = 0.0;
  std::int64_t fit_ns = 0;       ///< thread CPU time from pen-down to pen-up
  std::int64_t refine_ns = 0;    ///< thread CPU time of the refinement
  std::int64_t allocations = 0;  ///< while samples are added, after warm-up
  Histogram calls;               ///< thread CPU time of the call for a single sample

  void add(const FitStats& other) noexcept;
};

/// Returns one line of JSON, as defined for the command line.
std::string stats_json(const FitStats& stats);

/// Returns `sum` per `count`, or 0 if there is nothing to count.
double per(double sum, std::int64_t count) noexcept;

/// Returns the CPU time of the calling thread in ns. Other programs do not influence it.
std::int64_t thread_cpu_ns() noexcept;

/// Measures the cost of fitting one stroke, and how closely the curve follows the samples.
class StrokeMeter {
 public:
  explicit StrokeMeter(const InkFitOptions& options);

  /// Times the call of the fitter for every single sample, and counts the allocations in these
  /// calls.
  ///
  /// The stroke is fitted kRuns times, and for each call the shortest of its times counts: it does
  /// the same work in each run, and any additional time is caused by the machine (interrupts, cold
  /// caches). Allocations are those of the last run, when the buffers have reached their final
  /// size; there should be none then.
  void measure_calls(std::span<const InkSample> samples, FitStats& stats);

  /// Adds the distance from each sample to the nearest point of the whole curve.
  void measure_error(std::span<const InkSample> samples, const Stroke& stroke, FitStats& stats);

 private:
  static constexpr int kRuns = 3;
  void run(std::span<const InkSample> samples, std::int64_t& allocations);

  InkFitter fitter_;
  std::int64_t clock_cost_ns_;
  std::vector<std::int64_t> least_ns_;  // for each sample of one stroke
  std::vector<BvhSegment> segments_;
  SegmentBvh tree_;
};

}  // namespace felt::cli
