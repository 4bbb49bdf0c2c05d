#pragma once

#include <memory>
#include <optional>
#include <string>

#include "felt/base/result.h"
#include "felt/document/layer_picture.h"
#include "felt/geometry/rect.h"
#include "felt/io/drawing_parts.h"
#include "felt/io/picture/grain_mask.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Options for writing a PDF file.
struct PdfOptions {
  /// The area that the page shows. If not set, the page shows all ink with a margin around it.
  std::optional<Rect> area{};
  double margin_mm = 5.0;
  /// Largest distance between the written outline of a stroke and the exact one. Rounding adds up
  /// to 0.0007 mm.
  double tolerance_mm = 0.009;
  Rgba paper{255, 255, 255, 0};  ///< colour behind the ink; not drawn if alpha is 0
  /// If set, each stroke has a mask with the grain of the surface, and lines have the styles of its
  /// media. Otherwise lines have the styles of the drawing. Strokes are always written as outlines.
  std::optional<GrainPrint> grain{};
  PictureChoice pictures = PictureChoice::kMarked;  ///< the pictures of layers in the file
};

/// Returns the strokes of visible layers as a PDF 1.4 file with one page at true size. Each stroke
/// is one filled outline of curves, sharp at any zoom, in its colour; where a transparent stroke
/// crosses itself, it is not darker. Equal drawings give equal bytes, because the file contains
/// neither date nor program version.
///
/// Pictures of layers are images below the fills and strokes of their layer. The grain is written
/// as a soft mask for the outline (PDF 1.4, 7.5.4). A layer or a group of layers with an opacity or
/// a blend mode is a transparency group.
///
/// Fails if the page is empty or larger than the 5080 mm that PDF allows (14400 points), if an
/// option is invalid, if a picture is damaged, or if a stroke reaches farther than 1e6 mm from the
/// page.
Result<std::unique_ptr<DrawingParts>> pdf_parts(const Drawing& drawing, const PdfOptions& options);

/// Returns the same file as one text.
Result<std::string> pdf_text(const Drawing& drawing, const PdfOptions& options);

}  // namespace felt
