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
  /// The area that the file shows. If set, the page is not written. If not set, the file shows the
  /// page, or, if the drawing has none, all ink with a margin around it.
  std::optional<Rect> area{};
  double margin_mm = 5.0;
  /// Largest distance between the written outline and the exact one. With the default, this
  /// distance stays within 0.01 mm even with the rounding of coordinates (R53). In addition,
  /// Feltline's own attributes contain the exact stroke.
  double tolerance_mm = 0.005;
  /// Colour behind the ink; not drawn if alpha is 0. If not set, the colour of the page is drawn,
  /// or no colour if the page is not written.
  std::optional<Rgba> paper{};
  /// If set, each stroke has a mask that shows the grain of the surface. All viewers support such
  /// masks. Lines and outlines do not change, and import_svg reads the same drawing.
  /// Lines then have the styles of its media, otherwise those of the drawing.
  std::optional<GrainPrint> grain{};
  /// Pictures of layers that the file shows.
  PictureChoice pictures = PictureChoice::kMarked;
};

/// Returns a whole drawing as the parts of an SVG file. The layers become layers of Inkscape,
/// including hidden and locked ones. import_svg reads back an equal drawing. Fails if the page
/// cannot be written.
Result<std::unique_ptr<DrawingParts>> svg_parts(const Drawing& drawing, const SvgOptions& options);

/// Returns the same file as one text.
Result<std::string> svg_text(const Drawing& drawing, const SvgOptions& options);

/// Returns the start of such a file, before the first layer, if `ink` is the box of all ink. Code
/// that writes strokes one at a time (svg_elements.h) begins the file with it. Fails like
/// svg_parts().
Result<std::string> svg_head(const Drawing& drawing, const SvgOptions& options, const Rect& ink);

/// Returns a file with the ink only, without layers and without a page for import_svg().
Result<std::string> svg_ink_text(const Drawing& drawing, const SvgOptions& options);

}  // namespace felt
