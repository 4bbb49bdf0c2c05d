#pragma once

#include <string>
#include <vector>

#include "felt/base/random.h"
#include "felt/stroke/fit/ink_fit.h"

namespace felt::bench {

using Line = std::vector<InkSample>;

/// A hand that shakes.
struct ShakyHand {
  double hz = 5.0, amplitude_mm = 1.0, axis_rad = 0.0;
  double across = 0.3;  ///< motion across the axis as a share of that along it
};

inline constexpr double kRateHz = 133.0;

/// Reads the strokes of .ndjson files that take 1.5 to 8 s, and makes intended lines of them
/// (README.md). Throws std::runtime_error with the name of the file.
std::vector<Line> read_intended(const std::vector<std::string>& paths, double mm_per_unit);
/// Returns a spiral of 10 s with six turns.
Line spiral_line();
/// Returns a hand of 4 to 7 Hz.
ShakyHand random_hand(double amplitude_mm, Random& random);
/// Returns the line as this hand draws it.
Line shaken(const Line& line, const ShakyHand& hand, Random& random);

}  // namespace felt::bench
