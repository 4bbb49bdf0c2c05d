#pragma once

#include <vector>

#include "felt/geometry/affine.h"
#include "felt/io/svg/svg_center_line.h"

namespace felt {

/// The widths of a line that was drawn in user units.
struct SvgLineWidths {
  std::vector<WidthKnot> knots;  ///< in mm; empty if `to_mm` has no inverse
  bool is_stretched = false;     ///< the width depends on the direction, so it was sampled
  bool was_thin = false;         ///< the width was below kMinWidthMm at some point and was raised
};

/// Returns the widths of a line that is `width` user units wide along `line` (in mm). `to_mm`
/// transformed the line to the page. A pen of width w draws a line that is w |det| / |to_mm d| wide
/// when it moves in the direction d, a vector of length 1 in user units.
SvgLineWidths svg_line_widths(const SvgCenterLine& line, const Affine& to_mm, double width);

}  // namespace felt
