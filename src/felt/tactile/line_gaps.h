#pragma once

#include <vector>

#include "felt/tactile/tactile_check.h"
#include "felt/tactile/touch_lines.h"

namespace felt {

/// Finds where the ink of two lines, or of two parts of one line, is nearer than `gap_mm` without
/// being joined near there (TactileRule::kGap).
///
/// Two points are joined if a path along the two lines, through at most one junction, is shorter
/// than kJoinedGaps times the gap. Two straight lines that leave a junction at the angle a are a
/// gap g apart after the path g / sin(a / 2), so that angles below 29 degrees are faults.
///
/// A series of points of a line that are too near the same other line is one fault. Each pair is
/// reported once, at the line that comes first.
std::vector<TactileFault> find_line_gaps(const TouchLines& lines, double gap_mm);

inline constexpr double kJoinedGaps = 4.0;

/// Returns the lines of each shape: lines that touch or cross, directly or through others.
std::vector<std::vector<std::uint32_t>> shapes_of(const TouchLines& lines);

}  // namespace felt
