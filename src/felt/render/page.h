#pragma once

#include <optional>

#include "felt/base/result.h"
#include "felt/render/grain.h"
#include "felt/render/image.h"
#include "felt/render/view.h"
#include "felt/stroke/sketch.h"

namespace felt {

/// What a picture of a sketch looks like.
struct PageOptions {
  double dpi = 300.0;
  /// The part of the sheet to show; without it, all ink and the margin around it.
  std::optional<Rect> sheet{};
  double margin_mm = 5.0;
  Rgba paper{255, 255, 255, 255};  ///< alpha 0 gives a transparent picture
  Grain grain{};                   ///< the relief of the sheet, in the ink; smooth without
};

/// Bounds of all ink; empty for no strokes.
Rect ink_bounds(const Sketch& sketch) noexcept;

/// The part of the sheet that the options show: `sheet`, or the ink and its margin, or for an
/// empty sketch a square of the margin around the origin.
Rect page_area(const Sketch& sketch, const PageOptions& options) noexcept;

/// Draws the strokes in order onto paper. Error: options that make no sense (a resolution or
/// margin that is not finite, an empty sheet), or a picture larger than Image::kMaxPixels.
Result<Image> render_page(const Sketch& sketch, const PageOptions& options);

}  // namespace felt
