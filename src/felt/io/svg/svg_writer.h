#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/geometry/rect.h"
#include "felt/io/drawing_parts.h"
#include "felt/io/picture/grain_mask.h"

namespace felt {

/// What an SVG file shows.
struct SvgOptions {
  /// The part that is shown, in place of the page, which the file leaves out then. Without either,
  /// all ink and the margin around it.
  std::optional<Rect> sheet{};
  double margin_mm = 5.0;
  /// How far the drawn outline may be from the true one. With the rounding of coordinates it stays
  /// within 0.01 mm (R53); the model itself is written exactly.
  double tolerance_mm = 0.005;
  /// Behind the ink; alpha 0 leaves it out. Without it, the colour of the page, or nothing if there
  /// is no page.
  std::optional<Rgba> paper{};
  /// Strokes are seen through a picture of the surface's grain, which all viewers show. Lines and
  /// outlines stay what they are, and import_svg reads them as without it.
  std::optional<GrainPrint> grain{};
};

/// A whole drawing in parts: its layers become layers of Inkscape, hidden and locked ones too.
/// import_svg gives it back equal. Error: the page cannot be written.
Result<std::unique_ptr<DrawingParts>> svg_parts(const Drawing& drawing, const SvgOptions& options);

/// The same as one text.
Result<std::string> svg_text(const Drawing& drawing, const SvgOptions& options);

/// The ink alone, without layers and without a page that import_svg would give back: what a stream
/// of strokes becomes (svg_text.h).
Result<std::string> svg_ink_text(const Drawing& drawing, const SvgOptions& options);

}  // namespace felt
