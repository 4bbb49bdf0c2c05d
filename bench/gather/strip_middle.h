#pragma once

#include <optional>
#include <span>

#include "felt/gather/bundle_path.h"

namespace felt::bench {

/// How far a gathered line is from the middle of its strip.
struct StripDistance {
  double width = 0.0;  ///< median width of the strip, including the width of the pen
  double mean = 0.0;   ///< mean distance of the line from the middle
  double p95 = 0.0;    ///< 95th percentile of this distance
};

/// Measures on sections across `path`, independently of how it was made: the strip on a section are
/// the crossings of `lines`, the nearest one of each line, up to the first gap of more than twice
/// the strip's own width; its middle is the mean of these crossings. Returns nullopt if no section
/// crosses two lines.
std::optional<StripDistance> strip_distance(const BundlePath& path,
                                            std::span<const RoughLine> lines, double pen_width);

}  // namespace felt::bench
