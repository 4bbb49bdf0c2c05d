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

/// What a PDF file shows.
struct PdfOptions {
  /// The sheet, which is the page; without it, all ink and the margin around it.
  std::optional<Rect> sheet{};
  double margin_mm = 5.0;
  /// How far the outline of a stroke may be from its true one; rounding adds 0.0007 mm.
  double tolerance_mm = 0.009;
  Rgba paper{255, 255, 255, 0};  ///< behind the ink; alpha 0 leaves it out
  /// Strokes are seen through a picture of the sheet's grain; they stay outlines.
  std::optional<GrainPrint> grain{};
};

/// The strokes of visible layers as a PDF 1.4 file of one page at true size: each stroke is one
/// filled outline of curves, sharp at any zoom, in its colour; a transparent one does not darken
/// where it crosses itself. Equal sketches give equal bytes: no date, no name of a program's
/// version.
///
/// Grain is a soft mask on the outline (PDF 1.4, 7.5.4).
///
/// Error: a page that is empty or larger than the 5080 mm that PDF allows (14400 points), options
/// that make no sense, a stroke that reaches farther than 1e6 mm from the page.
Result<std::unique_ptr<DrawingParts>> pdf_parts(const Drawing& drawing, const PdfOptions& options);

/// The same as one text.
Result<std::string> pdf_text(const Drawing& drawing, const PdfOptions& options);

}  // namespace felt
