#pragma once

#include <cstdint>
#include <string>

#include "felt/base/histogram.h"

namespace felt::cli {

/// What `fit --stats` counts. Those of several workers add up.
struct FitStats {
  std::int64_t strokes = 0;
  std::int64_t samples = 0;
  std::int64_t segments = 0;
  std::int64_t corners = 0;
  double max_error_mm = 0.0;  ///< largest distance from a sample to the curve
  double error_sum_mm = 0.0;
  std::int64_t fit_ns = 0;       ///< thread CPU time from pen-down to pen-up
  std::int64_t refine_ns = 0;    ///< thread CPU time of the refinement
  std::int64_t allocations = 0;  ///< while samples come in, once warm
  Histogram calls;               ///< thread CPU time of the call for a single sample

  void add(const FitStats& other) noexcept;
};

/// One line of JSON: the object of the command line contract.
std::string stats_json(const FitStats& stats);

/// `sum` per `count`, 0 when there is nothing to count.
double per(double sum, std::int64_t count) noexcept;

}  // namespace felt::cli
