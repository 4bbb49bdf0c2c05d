#pragma once

#include <optional>
#include <span>
#include <vector>

#include "felt/gather/line_sections.h"

namespace felt {

/// A point of a rough line and its position along the strip.
struct StripPoint {
  std::uint32_t line = 0;
  Point point;
  double along_mm = 0.0;  ///< position along the strip
};

/// Positions of all lines along their common strip.
struct StripPositions {
  std::vector<StripPoint> points;  ///< sorted by line, then along the line; not empty
  double first_mm = 0.0, last_mm = 0.0;
  std::optional<double> period_mm;  ///< the length of a closed strip
  double step_mm = 0.0;             ///< distance of the points along their line
};

/// Directs all lines of a strip and gives their points positions along it (bundle_path, steps 1 and
/// 2). Lines without length are ignored; requires one with a length, and points in range.
StripPositions strip_positions(std::span<const RoughLine> lines);

}  // namespace felt
