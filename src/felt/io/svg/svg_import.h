#pragma once

#include <string_view>

#include "felt/base/result.h"
#include "felt/io/import.h"

namespace felt {

/// Reads an SVG file of any program, `.svg` or gzip-compressed `.svgz` (docs/formats/svg.md).
///
/// A file that Feltline wrote is read back exactly, including layers, even if another program saved
/// it in between. From other drawings, the centre lines of stroked paths and shapes become strokes
/// with the same curves; a PowerStroke of Inkscape keeps its widths; a shape that is only filled
/// gets a thin line along its edge. 1 px is 1/96 inch. The top left corner of the drawing becomes
/// (0, 0). Content that ink cannot show gets a notice in the report, with its line and element.
///
/// `bytes` is the whole file and untrusted: time and memory are bounded by its size, and no other
/// file is opened. Fails if it is not XML or SVG, was written by a newer Feltline, or exceeds a
/// limit of limits.h. The message states the line and the reason.
Result<Imported> import_svg(std::string_view bytes, const ImportOptions& options = {});

}  // namespace felt
