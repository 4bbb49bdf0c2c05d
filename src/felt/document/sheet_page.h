#pragma once

#include <string>

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
  /// Id of the surface it is made of (SurfaceMaterial::id), UTF-8 of at most 4096 bytes. "" where
  /// none was chosen, as in files of other programs: then it is felt and seen on whatever the
  /// person has chosen. An id that is not known is kept.
  std::string surface{};

  [[nodiscard]] Rect area() const noexcept { return {0.0, 0.0, width_mm, height_mm}; }
  friend bool operator==(const SheetPage&, const SheetPage&) noexcept = default;
};

}  // namespace felt
