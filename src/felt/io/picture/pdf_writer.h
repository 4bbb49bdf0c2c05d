#pragma once

#include <memory>
#include <optional>
#include <string>

#include "felt/base/result.h"
#include "felt/geometry/rect.h"
#include "felt/io/drawing_parts.h"
#include "felt/io/picture/grain_mask.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Options for writing a PDF file.
struct PdfOptions {
  /// The page. If not set, all ink and the margin around it.
  std::optional<Rect> sheet{};
  double margin_mm = 5.0;
  /// Largest distance between the outline of a stroke and its true one; rounding adds 0.0007 mm.
  double tolerance_mm = 0.009;
  Rgba paper{255, 255, 255, 0};  ///< colour behind the ink; not drawn if alpha is 0
  /// If set, strokes are seen through a picture of the surface's grain. They stay outlines.
  std::optional<GrainPrint> grain{};
};

/// Returns the strokes of visible layers as a PDF 1.4 file with one page at true size. Each stroke
/// is one filled outline of curves, sharp at any zoom, in its colour; a transparent stroke is not
/// darker where it crosses itself. Equal sketches give equal bytes, because the file contains
/// neither date nor program version.
///
/// Grain is a soft mask on the outline (PDF 1.4, 7.5.4).
///
/// Fails if the page is empty or larger than the 5080 mm that PDF allows (14400 points), if an
/// option is invalid, or if a stroke reaches farther than 1e6 mm from the page.
Result<std::unique_ptr<DrawingParts>> pdf_parts(const Drawing& drawing, const PdfOptions& options);

/// Returns the same file as one text.
Result<std::string> pdf_text(const Drawing& drawing, const PdfOptions& options);

}  // namespace felt
