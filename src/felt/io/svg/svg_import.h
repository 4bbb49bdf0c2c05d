#pragma once

#include <string_view>

#include "felt/base/result.h"
#include "felt/io/import.h"

namespace felt {

/// Reads an SVG file of any program, `.svg` or gzip-compressed `.svgz` (docs/formats/svg.md).
///
/// What Feltline wrote comes back exactly, layers too, also after another program saved it. Of
/// other drawings the centre lines of stroked paths and shapes become strokes, curve by curve as
/// they are; a PowerStroke of Inkscape comes with its widths; a shape that is only filled gets a
/// thin line along its edge. 1 px is 1/96 inch; the top left corner of the drawing becomes (0, 0).
/// What ink cannot show is a notice of the report with its line and element.
///
/// `bytes` is the whole file and not trusted: time and memory are bounded by its size, and nothing
/// outside it is opened. Error: no XML or no SVG, one of a newer Feltline, or a limit of
/// limits.h; the message names line and reason.
Result<Imported> import_svg(std::string_view bytes, const ImportOptions& options = {});

}  // namespace felt
