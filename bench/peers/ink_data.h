#pragma once

#include <string>
#include <vector>

#include "tests/support/fit_checker.h"

namespace felt::bench {

/// The strokes that every peer gets.
struct InkData {
  std::string name;                          ///< where they come from
  std::vector<fit_check::Ink> raw;           ///< all samples
  std::vector<fit_check::Ink> deduplicated;  ///< consecutive repeats removed, >= 4 points
};

/// Number of samples in all.
std::int64_t sample_count(const std::vector<fit_check::Ink>& inks);

/// Reads .ndjson files of raw strokes. Throws std::runtime_error that names the file.
InkData read_ink_data(const std::vector<std::string>& paths, double mm_per_unit);

/// A stroke of `count` samples at 1 kHz for the latency of long strokes: slow straight and slow
/// round runs (runs of samples that fit no end of time), rests, handwriting, quick zigzags, and
/// jumps. Noise and quantisation are 0.1 and 0.15 tolerances, so it is the same work at any scale.
/// The same seed gives the same stroke.
fit_check::Ink make_long_stroke(std::int64_t count, double tolerance, unsigned seed);

}  // namespace felt::bench
