#pragma once

#include <string_view>

#include "felt/base/result.h"
#include "felt/io/import.h"

namespace felt {

/// Reads an SVG file of any program, `.svg` or gzip-compressed `.svgz` (docs/formats/svg.md).
///
/// A file that Feltline wrote is read back exactly, including layers, even if another program has
/// loaded and saved it since. In other drawings, the centre lines of stroked paths and shapes
/// become strokes with the same curves, and a PowerStroke of Inkscape becomes a stroke with its
/// widths. The fill of a shape becomes a fill. 1 px is 1/96 inch. The
/// top left corner of the drawing becomes (0, 0). For content that cannot become ink, the report
/// has a notice with the line and the element.
///
/// `bytes` is the whole file. It is untrusted: the time and memory for reading it are bounded by
/// its size, and no other file is opened. Fails if it is not XML or SVG, was written by a newer
/// Feltline, or exceeds a limit of limits.h. The message states the line and the reason.
Result<Imported> import_svg(std::string_view bytes, const ImportOptions& options = {});

}  // namespace felt
