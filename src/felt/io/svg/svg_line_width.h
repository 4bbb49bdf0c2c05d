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

/// Returns the widths on the page of a line that was drawn with a width of `width` user units.
/// `line` is its centre line in mm, and `to_mm` transforms user units to the page. The width at a
/// point depends on the direction d of the line there (a vector of length 1 in user units): it is w
/// |det| / |to_mm d|, where w is `width` and det is the determinant of `to_mm`.
SvgLineWidths svg_line_widths(const SvgCenterLine& line, const Affine& to_mm, double width);

}  // namespace felt
