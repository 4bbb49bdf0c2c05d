#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/io/import.h"
#include "felt/io/ndjson_parser.h"
#include "felt/stroke/ink_fitter.h"

namespace felt {

/// Makes a stroke of a line of JSON (docs/formats/ndjson.md): a fitted one as it is, raw pen
/// samples in mm as ink. Reusable; what comes of a line depends on that line alone. One thread.
class LineStrokes {
 public:
  explicit LineStrokes(const InkFitOptions& fit = {}) : fitter_(fit) {}

  /// None for a header. The id is "" where the line has none. Error: the line is no stroke.
  Result<std::optional<SketchStroke>> read(const NdjsonLine& line);

 private:
  Result<std::optional<SketchStroke>> read_fitted(const NdjsonLine& line);
  Result<std::optional<SketchStroke>> read_raw(const NdjsonLine& line);

  NdjsonParser parser_;
  InkFitter fitter_;
  RawStroke raw_;
};

/// Reads lines of JSON (docs/formats/ndjson.md): fitted strokes as they are, raw pen samples in mm
/// as ink, one layer, no sheet. A line that is no stroke becomes a notice, and the rest is taken.
/// Strokes without a name are called after their line's number among the strokes.
///
/// Error: nothing could be taken though there are lines (the first reason), or they hold events.
Result<ImportedDrawing> import_lines(std::string_view text, const ImportOptions& options = {});

/// The sketch as lines, the header first.
std::string lines_of(const Sketch& sketch);

}  // namespace felt
