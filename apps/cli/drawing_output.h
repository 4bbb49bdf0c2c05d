#pragma once

#include <cstdint>
#include <string>

#include "felt/document/drawing.h"
#include "felt/geometry/rect.h"
#include "felt/stroke/named_stroke.h"
#include "format.h"
#include "output.h"
#include "picture.h"
#include "stroke_spool.h"

namespace felt::cli {

/// Strokes encoded for an output, which is done on the workers.
struct EncodedStrokes {
  std::string text;  ///< elements of an SVG file; for the other formats lines of .ndjson
  Rect bounds;       ///< of their ink
  void clear() { *this = {}; }
};

/// Adds a stroke for an output of that format. `number` is a different one for each stroke. On
/// error, a stroke that the format cannot hold, `out` stays as it was.
Result<void> encode(const NamedStroke& stroke, std::int64_t number, Format format,
                    EncodedStrokes& out);

/// Where a drawing goes: as a whole with write(), or stroke by stroke with append() and then
/// finish(). Nothing shows under the output's name before that is done.
///
/// What a whole drawing holds beyond strokes comes along if the format can hold it: layers, hidden
/// ones too, its surface, its page unless the picture options ask for another, and the texts of its
/// materials. Strokes by themselves have neither layers nor a page. For .ndjson, .svg and .png,
/// memory does not grow with their number; for the other formats they become a drawing of one layer
/// first.
class DrawingOutput {
 public:
  /// The picture options count for all formats but .ndjson. Error: the place cannot be written.
  static Result<DrawingOutput> create(const std::string& path, Format format,
                                      const PictureOptions& picture);

  /// Writes a whole drawing. Call once. Error: what the format cannot hold, a surface whose grain
  /// is asked for and not known, or the disk; messages begin with the path if they are about the
  /// file.
  Result<void> write(Drawing drawing);

  /// Appends strokes that encode() made for this format.
  Result<void> append(const EncodedStrokes& strokes);
  /// Appends the strokes of visible layers, named by stroke_name().
  Result<void> append(const Document& document);
  /// Completes the file after the last append().
  Result<void> finish();

 private:
  DrawingOutput(std::string path, Format format, PictureOptions picture, Output output);
  Result<void> begin_svg();
  Result<void> finish_svg();
  Result<void> finish_png();
  Result<void> finish_drawing();

  std::string path_;
  Format format_;
  PictureOptions picture_;
  Output output_;
  // Of what was appended.
  bool has_begun_ = false;
  Rect ink_;
  StrokeSpool spool_;
};

}  // namespace felt::cli
