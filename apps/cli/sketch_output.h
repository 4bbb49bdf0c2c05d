#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "felt/geometry/rect.h"
#include "felt/stroke/sketch.h"
#include "format.h"
#include "output.h"
#include "picture.h"

namespace felt::cli {

/// Strokes made ready for an output, which is done on the workers.
struct SketchPiece {
  std::string text;  ///< elements of an SVG file; for the other formats lines of .ndjson
  Rect bounds;       ///< of their ink
  void clear() { *this = {}; }
};

/// Adds a stroke to a piece for an output of that format. `number` is a different one for each
/// stroke. On error, a stroke that the format cannot hold, the piece stays as it was.
Result<void> encode(const SketchStroke& stroke, std::int64_t number, Format format,
                    SketchPiece& piece);

/// Writes a sketch in one of the formats, piece by piece. For .ndjson, .svg and .png, memory does
/// not grow with the number of strokes; the others hold the strokes once, as a drawing, and write
/// the file in parts. Nothing shows under the output's name before `finish`.
class SketchOutput {
 public:
  virtual ~SketchOutput() = default;
  virtual Result<void> append(const SketchPiece& piece) = 0;
  virtual Result<void> finish() = 0;
};

/// Opens the output for a format. The picture options count for all but .ndjson; of
/// a .felt file they say the sheet.
Result<std::unique_ptr<SketchOutput>> open_sketch_output(const std::string& path, Format format,
                                                         const PictureOptions& picture);

/// Writes these strokes into an output of that format, and finishes it.
Result<void> write_strokes(const Sketch& sketch, Format format, SketchOutput& output);

}  // namespace felt::cli
