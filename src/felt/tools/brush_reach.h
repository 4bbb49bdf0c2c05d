#pragma once

#include "felt/stroke/arc_map.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Options of the brush.
struct BrushOptions {
  double radius_mm = 20.0;  ///< reach of the influence along the ink, to each side
  /// Whether ends and corners move like all other ink instead of staying in place.
  bool free_ends = false;
  /// How far ink that is not under the pen may move at the lift, mm, to save segments. During the
  /// pull the ink is within a fifth of this tolerance of the exact displacement.
  double tolerance_mm = 0.1;
};

/// An end or corner within this arc length of the grab is grabbed itself.
inline constexpr double kPinGrabMm = 2.0;

/// The reach of a pull to one side of the grab. Held ink, next to the grab, moves exactly with the
/// pen.
struct BrushSide {
  double held_mm = 0.0;    ///< from the grab to the point where the influence begins to fall off
  double way_mm = 0.0;     ///< from there to the end of the change; 0 at an end of the stroke
  double radius_mm = 0.0;  ///< from there to influence 0; more than way_mm at a free end
};

/// The part of a stroke that a pull moves, by arc length. It does not depend on the displacement
/// (docs/design/editing.md#brush).
///
///   influence  w = 1 on held ink;  next to it w(x) = 1 - 3x^2 + 2x^3, x = distance / radius
///
/// Pins are ends and corners. Towards a pin the radius is at most the distance to it. Then w and w'
/// are 0 at the pin, so the pin and its tangents do not move. If a pin is within kPinGrabMm of the
/// grab, the pin and the ink up to it move exactly with the pen instead. The radius is still
/// measured from the grab, so ink farther away than the radius never moves. If the radius is less
/// than 4 mm, only pins within half of the radius move with the pen. On a closed stroke each side
/// is at most half of the length. If only the radius limits a side and the last fifth of the side
/// contains a joint, the side ends at that joint, so that no joint has to be added.
struct BrushReach {
  double grab_mm = 0.0;  ///< arc length from the start of the stroke
  BrushSide before, after;
  bool is_whole = false;  ///< the whole stroke moves with the pen
  bool is_ring = false;   ///< the stroke is closed

  /// Return the part of the stroke that moves. On a closed stroke, last <= first means that the
  /// part crosses the seam.
  [[nodiscard]] double first_u(const ArcMap& map) const noexcept;
  [[nodiscard]] double last_u(const ArcMap& map) const noexcept;
};

/// Returns the reach of a pull at u0. Requires the arc map of `stroke` and u0 in [0, n].
BrushReach brush_reach(const Stroke& stroke, const ArcMap& map, double u0,
                       const BrushOptions& options);

/// Return w(x) and its derivative: 1 and 0 if x <= 0, 0 and 0 if x >= 1.
constexpr double influence(double x) noexcept {
  if (x <= 0.0) return 1.0;
  return x < 1.0 ? 1.0 - x * x * (3.0 - 2.0 * x) : 0.0;
}
constexpr double influence_slope(double x) noexcept {
  return x > 0.0 && x < 1.0 ? -6.0 * x * (1.0 - x) : 0.0;
}

}  // namespace felt
