#pragma once

#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/io/import.h"

namespace felt {

/// Reads lines of JSON (docs/formats/ndjson.md): fitted strokes as they are, raw pen samples in mm
/// as ink, one layer, no sheet. A line that is no stroke becomes a notice, and the rest is taken.
/// Strokes without a name are called after their line's number among the strokes.
///
/// Error: nothing could be taken though there are lines (the first reason), or they hold events.
Result<ImportedDrawing> import_lines(std::string_view text, const ImportOptions& options = {});

/// The sketch as lines, the header first.
std::string lines_of(const Sketch& sketch);

}  // namespace felt
