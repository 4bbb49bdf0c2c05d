#pragma once

#include <optional>

#include "felt/driver/plane_calibration.h"
#include "felt/geometry/rect.h"

namespace felt {

/// The part of the drawing plane in which the user draws.
struct DrawingArea {
  Vec3 middle_mm;          ///< in the device's frame
  double width_mm = 0.0;   ///< along the page's x, in millimetres of the hand's movement
  double height_mm = 0.0;  ///< along the page's y, in millimetres of the hand's movement

  friend constexpr bool operator==(const DrawingArea&, const DrawingArea&) noexcept = default;
};

/// Returns the reachable area around the centre of the device's workspace. Along each axis of the
/// page, the area extends as far as a straight line through the centre stays within the workspace.
DrawingArea reach_of(const PlaneCalibration& plane, const Capabilities& device) noexcept;

/// Returns `plane` moved so that the centre of `area` is the centre of `page`. `scale` is
/// millimetres on the page per millimetre of the hand, clamped to 0.5..2. Without `scale`, uses the
/// smallest scale in this range with which the whole page can be reached, or 2 if none is large
/// enough. In the device's frame, the plane is not moved along its normal.
PlaneCalibration fit_to_page(const PlaneCalibration& plane, const DrawingArea& area,
                             const Rect& page, std::optional<double> scale) noexcept;

}  // namespace felt
