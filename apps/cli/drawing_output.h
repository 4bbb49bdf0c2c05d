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

/// Strokes encoded for an output, by a worker.
struct EncodedStrokes {
  std::string text;  ///< elements of an SVG file; for the other formats lines of .ndjson
  Rect bounds;       ///< of their ink
  void clear() { *this = {}; }
};

/// Encodes a stroke for an output of that format. `number` must be different for each stroke. Fails
/// if the format cannot hold the stroke; `out` does not change then.
Result<void> encode(const NamedStroke& stroke, std::int64_t number, Format format,
                    EncodedStrokes& out);

/// What a DrawingOutput receives: a whole drawing by write(), or single strokes by append().
enum class OutputUse { kWhole, kStrokes };

/// Returns the format that encode() must get for strokes that go to this output. Only .ndjson and
/// uncompressed .svg are written stroke by stroke; for other outputs strokes are kept as lines.
Format stroke_format(const std::string& path, Format format);

/// The output of a drawing: either as a whole with write(), or stroke by stroke with append() and
/// then finish(). No file appears under the output's name before write() or finish() is done.
///
/// A whole drawing keeps more than its strokes if the format can hold it: layers, including hidden
/// ones, its surface, its page (unless the picture options specify another), and the texts of its
/// materials. Single strokes have neither layers nor a page. For .ndjson, .svg and .png, memory
/// does not grow with their number; for the other formats they are collected in a drawing with one
/// layer first.
class DrawingOutput {
 public:
  /// The picture options apply to all formats but .ndjson. With OutputUse::kStrokes an .svg on
  /// stdout appears only when it is complete, because its first line has its size. Fails if the
  /// path cannot be written.
  static Result<DrawingOutput> create(const std::string& path, Format format,
                                      const PictureOptions& picture,
                                      OutputUse use = OutputUse::kWhole);

  /// Writes a whole drawing. Call once. Fails if the format cannot hold it, if grain is requested
  /// and the surface is unknown, or if writing fails. Messages begin with the path if they are
  /// about the file.
  Result<void> write(Drawing drawing);

  /// Appends strokes that encode() made for stroke_format(). Requires OutputUse::kStrokes.
  Result<void> append(const EncodedStrokes& strokes);
  /// Appends the strokes of visible layers, named by stroke_name(). Requires OutputUse::kStrokes.
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
  Format stroke_format_;
  PictureOptions picture_;
  Output output_;
  // About the appended strokes.
  bool has_begun_ = false;
  Rect ink_;
  StrokeSpool spool_;
};

}  // namespace felt::cli
