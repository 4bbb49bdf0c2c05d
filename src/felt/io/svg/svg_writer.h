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

/// The content and precision of an SVG file.
struct SvgOptions {
  /// The part to show instead of the page; the page is then not written. Without both, the file
  /// shows all ink and the margin around it.
  std::optional<Rect> sheet{};
  double margin_mm = 5.0;
  /// Largest distance between the drawn outline and the true one. Including the rounding of
  /// coordinates it stays within 0.01 mm (R53). The model itself is written exactly.
  double tolerance_mm = 0.005;
  /// Colour behind the ink; not drawn if alpha is 0. If not set, the colour of the page, or nothing
  /// if there is no page.
  std::optional<Rgba> paper{};
  /// If set, strokes are seen through a picture of the surface's grain, which all viewers show.
  /// Lines and outlines do not change, and import_svg reads the same drawing.
  std::optional<GrainPrint> grain{};
};

/// Returns a whole drawing in parts. Its layers become layers of Inkscape, including hidden and
/// locked ones. import_svg reads back an equal drawing. Fails if the page cannot be written.
Result<std::unique_ptr<DrawingParts>> svg_parts(const Drawing& drawing, const SvgOptions& options);

/// Returns the same file as one text.
Result<std::string> svg_text(const Drawing& drawing, const SvgOptions& options);

/// Returns the ink alone, without layers and without a page for import_svg, as for a stream of
/// strokes (svg_elements.h).
Result<std::string> svg_ink_text(const Drawing& drawing, const SvgOptions& options);

}  // namespace felt
