#pragma once

#include <vector>

namespace felt {

/// A style of line on swell paper: all lines whose mean widths are in this range get one width.
struct LineStyle {
  double from_mm = 0.0, to_mm = 0.0;  ///< of the mean widths
  double width_mm = 0.0;              ///< the width that they get
};

/// Returns the styles for lines of these mean widths, in mm, ascending. Widths that differ by less
/// than TactileLimits::kStyleMm are one style, as in TactileRule::kLineStyles; if there are more
/// than TactileLimits::kLineStyles, the most similar neighbours become one. The width of a style is
/// the mean of its lines, at least SwellRules::kLineMm and kStyleMm more than the one before.
std::vector<LineStyle> line_styles_of(std::vector<double> widths_mm);

}  // namespace felt
