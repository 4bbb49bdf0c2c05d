#pragma once

#include <string>
#include <vector>

#include "tests/support/fit_checker.h"

namespace felt::bench {

/// The input strokes of every peer.
struct InkData {
  std::string name;                          ///< the source of the strokes
  std::vector<fit_check::Ink> raw;           ///< all samples
  std::vector<fit_check::Ink> deduplicated;  ///< without consecutive repeats, >= 4 points
};

/// Returns the total number of samples.
std::int64_t sample_count(const std::vector<fit_check::Ink>& inks);

/// Reads .ndjson files of raw strokes. Throws std::runtime_error with the file name.
InkData read_ink_data(const std::vector<std::string>& paths, double mm_per_unit);

/// Returns a stroke of `count` samples at 1 kHz, for the latency of long strokes. It consists of
/// slow straight and slow round parts (in which one segment fits very many samples), rests,
/// handwriting, quick zigzags and jumps. Noise is 0.1 tolerances and quantisation 0.15 tolerances,
/// so the work is the same at any scale. The same seed returns the same stroke.
fit_check::Ink make_long_stroke(std::int64_t count, double tolerance, unsigned seed);

}  // namespace felt::bench
