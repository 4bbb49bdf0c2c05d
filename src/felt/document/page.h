#pragma once

#include <string>

#include "felt/geometry/rect.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// The page of a drawing: its size, colour and surface. Ink may lie outside the page. The page
/// limits the printed and exported area, not the drawing.
struct Page {
  static constexpr double kMinMm = 10.0;
  static constexpr double kMaxMm = 5000.0;

  double width_mm = 297.0;  ///< A4, landscape; kMinMm..kMaxMm
  double height_mm = 210.0;
  Rgba paper{255, 255, 255, 255};  ///< if alpha is 0, no background is drawn, printed or exported
  /// Id of the surface (SurfaceMaterial::id), UTF-8 of at most 4096 bytes. If no surface was chosen
  /// (as in files of other programs), it is "" and the user's current surface is used. An unknown
  /// id is kept.
  std::string surface{};

  [[nodiscard]] Rect area() const noexcept { return {0.0, 0.0, width_mm, height_mm}; }
  friend bool operator==(const Page&, const Page&) noexcept = default;
};

}  // namespace felt
