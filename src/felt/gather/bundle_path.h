#pragma once

#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/gather/line_sections.h"

namespace felt {

/// The middle line of a strip of rough lines.
struct BundlePath {
  std::vector<Point> points;  ///< at nearly equal distances; a closed path repeats its first point
  bool closed = false;
  double strip_mm = 0.0;  ///< median distance between the outermost lines; 0 for a single line

  friend bool operator==(const BundlePath&, const BundlePath&) = default;
};

/// Returns the middle line of rough lines that belong to one strip (line_groups). It covers all
/// lines, from the first end to the last, and the lines count equally at each position. Beyond the
/// end of a line, its effect fades out.
///
/// 1. Directs all lines the same way and gives each point a position along the strip: lines that
///    lie beside each other get matching positions, from the longest line outwards along the
///    strongest connections. A line without neighbours continues the line whose end is nearest.
/// 2. If the strip meets itself again, it is closed, and positions repeat after its length.
/// 3. Averages all points of equal position, moves each point to the position of the nearest point
///    of the average, and repeats this.
/// The common parameter along the strip is the idea of StrokeStrip (van Mossel et al. 2021,
/// doi:10.1145/3450626.3459777), which solves for it with an optimiser.
///
/// A single line is returned as it is. Fails with kInvalidArgument if no line has a length, or if a
/// coordinate is not finite or exceeds kMaxCoordinateMm.
Result<BundlePath> bundle_path(std::span<const RoughLine> lines);

}  // namespace felt
