#pragma once

#include <optional>

#include "felt/driver/plane_calibration.h"
#include "felt/geometry/rect.h"

namespace felt {

/// The part of the drawing plane that a person draws in.
struct DrawingArea {
  Vec3 middle_mm;          ///< in the device's frame
  double width_mm = 0.0;   ///< along the sheet's x, as the hand feels it
  double height_mm = 0.0;  ///< along its y

  friend constexpr bool operator==(const DrawingArea&, const DrawingArea&) noexcept = default;
};

/// All that the device reaches through the middle of its workspace: as far as a straight way along
/// each axis of the sheet stays within the box.
DrawingArea reach_of(const PlaneCalibration& plane, const Capabilities& device) noexcept;

/// The same plane with the area's middle on the middle of the page. `scale` is millimetres of the
/// sheet for one of the hand, clamped to 0.5..2; none: the smallest of these with which the whole
/// page can be reached. The sheet does not move towards the hand or away from it.
PlaneCalibration fit_to_page(const PlaneCalibration& plane, const DrawingArea& area,
                             const Rect& page, std::optional<double> scale) noexcept;

}  // namespace felt
