#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "felt/document/fill.h"
#include "felt/geometry/affine.h"
#include "felt/io/svg/svg_path_builder.h"

namespace felt {

/// The filled area of a shape.
struct SvgArea {
  Fill fill;  ///< without its colour
  /// True if the shape is filled by the non-zero rule and is too complex to convert it. Then
  /// the even-odd rule can show holes where it covers an area twice.
  bool may_lack_parts = false;
};

/// Converts the contours of a shape, in user units, to an area in mm. Open contours are closed by a
/// straight line. A fill is painted by the even-odd rule; if the shape uses the non-zero rule, its
/// contours are converted by make_even_odd(), so that the area is the same. It has no loop then if
/// the shape covers no area.
SvgArea svg_area(const std::vector<SvgContour>& contours, const Affine& to_mm, bool even_odd);

/// Returns the references of a fill as text, for our own attributes in files: the largest gap, then
/// for each loop its pieces, for example "0.5;3 0 1.25,-,4 2 0;". "-" is a bridge.
std::string fill_pieces_text(const Fill& fill);

/// Sets the gap and the pieces of a fill from such a text. Returns false, and does not change the
/// fill, if the text does not fit its loops.
bool read_fill_pieces(std::string_view text, Fill& fill);

}  // namespace felt
