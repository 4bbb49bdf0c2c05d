#pragma once

#include <cstdint>
#include <string>

#include "console.h"
#include "felt/document/drawing.h"
#include "felt/formats/lost_objects.h"
#include "felt/geometry/rect.h"
#include "felt/stroke/named_stroke.h"
#include "format.h"
#include "output.h"
#include "picture.h"
#include "stroke_spool.h"

namespace felt::cli {

/// Strokes that a worker has encoded for an output.
struct EncodedStrokes {
  std::string text;  ///< elements of an SVG file, or lines of .ndjson for other formats
  Rect bounds;       ///< bounds of the strokes' ink
  void clear() { *this = {}; }
};

/// Encodes a stroke for an output in `format` and appends it to `out`. `number` must be different
/// for each stroke. Fails if the format cannot hold the stroke; `out` is then unchanged.
Result<void> encode(const NamedStroke& stroke, std::int64_t number, Format format,
                    EncodedStrokes& out);

/// What a DrawingOutput receives: a whole drawing by write(), or single strokes by append().
enum class OutputUse { kWhole, kStrokes };

/// Returns the format that must be passed to encode() for strokes of this output. Only .ndjson and
/// uncompressed .svg are written stroke by stroke; for other outputs, strokes are first kept as
/// lines of .ndjson.
Format stroke_format(const std::string& path, Format format);

/// Writes a drawing to a file, either as a whole with write(), or stroke by stroke with append()
/// and then finish(). The file gets its name when write() or finish() succeeds, not before.
///
/// A whole drawing is written with its layers (hidden ones too), its surface, its page and the
/// texts of its materials, as far as the format supports these. The picture options may specify
/// another page. Single strokes are written as a
/// drawing with one layer and no page. For .ndjson, .svg and .png outputs,
/// the memory use does not depend on the number of strokes; for the other formats, all strokes are
/// first collected in a drawing with one layer.
class DrawingOutput {
 public:
  /// Creates the output. The picture options apply to all formats except .ndjson. Fails if the path
  /// cannot be written.
  static Result<DrawingOutput> create(const std::string& path, Format format,
                                      const PictureOptions& picture,
                                      OutputUse use = OutputUse::kWhole);

  /// Writes a whole drawing. Call it only once. Fails if the format cannot hold the drawing, if
  /// grain is requested and the surface is unknown, or if writing fails. A message about the file
  /// begins with its path.
  Result<void> write(Drawing drawing);

  /// Appends strokes that encode() made for stroke_format(). Requires OutputUse::kStrokes.
  Result<void> append(const EncodedStrokes& strokes);
  /// Completes the file after the last append().
  Result<void> finish();
  /// Returns what the file does not contain of the appended strokes. Call it after finish().
  [[nodiscard]] const LostObjects& lost() const noexcept { return lost_; }

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
  // The following members describe the appended strokes.
  bool has_begun_ = false;
  Rect ink_;
  StrokeSpool spool_;
  LostObjects lost_;
};

/// Prints a notice about each kind of object that the file `output` does not contain. `hint`
/// follows the notice about strokes of hidden layers.
void note_losses(const std::string& output, const LostObjects& lost, Console& console,
                 const std::string& hint = {});

}  // namespace felt::cli
