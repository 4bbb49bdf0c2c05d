#pragma once

#include "felt/geometry/rect.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// The sheet that a drawing is made on, as a person sees and prints it. Ink may lie beside it: the
/// sheet bounds the picture that is printed and exported, not the drawing.
struct SheetPage {
  static constexpr double kLeastMm = 10.0;
  static constexpr double kMostMm = 5000.0;

  double width_mm = 297.0;  ///< A4, landscape; kLeastMm..kMostMm
  double height_mm = 210.0;
  Rgba paper{255, 255, 255, 255};  ///< alpha 0: none is drawn, printed or exported

  [[nodiscard]] Rect area() const noexcept { return {0.0, 0.0, width_mm, height_mm}; }
  friend bool operator==(const SheetPage&, const SheetPage&) noexcept = default;
};

}  // namespace felt
