#pragma once

#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/geometry/rect.h"
#include "felt/stroke/sketch.h"

namespace felt {

/// What an SVG file of ours says.
struct SvgDrawing {
  Sketch sketch;           ///< the strokes, exactly as they were written
  Rect area;               ///< what the file shows, in mm
  Rgba paper{0, 0, 0, 0};  ///< alpha 0 where there is none
};

/// Reads an SVG file that Feltline wrote, by the attributes of docs/formats/svg.md: the outlines
/// are for others and are not looked at. "-" is stdin.
///
/// Error: no XML; an SVG of another program, which is not read yet; a shape that Feltline did not
/// write, or one that another program moved or changed, among those that it did; numbers that make
/// no stroke; a limit of limits.h, or more than 1 GiB. Names the file, the element and the reason.
Result<SvgDrawing> read_svg(const std::string& path);

/// The same, of a text. Messages do not begin with a path.
Result<SvgDrawing> parse_svg(std::string_view text);

}  // namespace felt
