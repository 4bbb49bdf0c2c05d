#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "felt/geometry/bvh.h"
#include "felt/stroke/fit/ink_fitter.h"
#include "fit_stats.h"

namespace felt::cli {

/// Measures what the fit of one stroke costs and how well it follows the samples.
class StrokeMeter {
 public:
  explicit StrokeMeter(const InkFitOptions& options);

  /// Times the call of the fitter for every single sample, and counts the allocations in them.
  ///
  /// The stroke is fitted kRuns times; a call counts with the least of its times, since it does the
  /// same work each time and what is more is the machine's (interrupts, cold caches). Allocations
  /// are those of the last run, when the buffers have their size: the rule is none in steady state.
  void measure_calls(std::span<const InkSample> samples, FitStats& stats);

  /// Adds the distance from each sample to the nearest point of the whole curve.
  void measure_error(std::span<const InkSample> samples, const Stroke& stroke, FitStats& stats);

 private:
  static constexpr int kRuns = 3;
  void run(std::span<const InkSample> samples, std::int64_t& allocations);

  InkFitter fitter_;
  std::int64_t clock_cost_ns_;
  std::vector<std::int64_t> least_ns_;  // per sample of one stroke
  std::vector<BvhSegment> segments_;
  SegmentBvh tree_;
};

}  // namespace felt::cli
