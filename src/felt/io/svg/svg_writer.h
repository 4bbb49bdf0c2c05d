#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "felt/base/atomic_file.h"
#include "felt/base/result.h"
#include "felt/geometry/rect.h"
#include "felt/io/drawing_parts.h"
#include "felt/io/layered_sketch.h"
#include "felt/io/picture/grain_mask.h"
#include "felt/stroke/sketch.h"

namespace felt {

/// What an SVG file shows.
struct SvgOptions {
  /// The sheet; without it, all ink and the margin around it.
  std::optional<Rect> sheet{};
  double margin_mm = 5.0;
  /// How far the drawn outline may be from the true one. With the rounding of coordinates it stays
  /// within 0.01 mm (R53); the model itself is written exactly.
  double tolerance_mm = 0.005;
  Rgba paper{255, 255, 255, 0};  ///< behind the ink; alpha 0 leaves it out
  /// Of svg_text: strokes are seen through a picture of the sheet's grain, which all viewers show.
  /// Lines and outlines stay what they are, and import_svg reads them as without it.
  std::optional<GrainPrint> grain{};
};

/// Writes a sketch as SVG, stroke by stroke, in memory that does not grow with their number.
///
/// Life-cycle: `create`, `add` for each stroke from the lowest to the topmost, `finish`. Without
/// `finish` no file appears.
class SvgWriter {
 public:
  /// "-" is stdout, which gets everything at `finish`, since the head of the file says how large
  /// the drawing is.
  static Result<SvgWriter> create(const std::string& path, const SvgOptions& options);

  /// Appends a stroke. On error (see append_svg_stroke) nothing is written and more may follow.
  Result<void> add(const SketchStroke& stroke);

  /// Appends strokes that append_svg_stroke made, with the tolerance of the options, and whose ink
  /// lies in `ink`.
  Result<void> add_text(std::string_view strokes, const Rect& ink);

  Result<void> finish();

 private:
  SvgWriter(AtomicFile file, const SvgOptions& options);

  AtomicFile file_;
  SvgOptions options_;
  Rect ink_;
  std::size_t count_ = 0;
  std::string text_;
};

/// A whole drawing in parts: its layers become layers of Inkscape, hidden and locked ones too. Its
/// page, where there is one, goes before the sheet and the paper of the options. import_svg gives
/// it back equal. Error: the page cannot be written.
Result<std::unique_ptr<DrawingParts>> svg_parts(DrawingView drawing, const SvgOptions& options);

/// The whole file as text.
Result<std::string> svg_text(const Sketch& sketch, const SvgOptions& options);

/// The same of a whole drawing (svg_parts).
Result<std::string> svg_text(const LayeredSketch& drawing, const SvgOptions& options);

/// Writes a whole sketch. Error: the first stroke that cannot be written, or the file.
Result<void> write_svg(const std::string& path, const Sketch& sketch, const SvgOptions& options);

}  // namespace felt
