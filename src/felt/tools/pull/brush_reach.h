#pragma once

#include "felt/stroke/arc_map.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Options of the brush.
struct BrushOptions {
  double radius_mm = 20.0;  ///< reach of the influence along the ink, to each side
  /// Whether ends and corners move like all other ink instead of staying in place.
  bool free_ends = false;
  /// How far the ink may move at the lift, except under the pen, to save segments. During the pull
  /// it follows the exact displacement within a fifth of that.
  double tolerance_mm = 0.1;
};

/// An end or corner within this arc length of the grab is grabbed itself.
inline constexpr double kPinGrabMm = 2.0;

/// The reach of a pull to one side of the rigidly held part.
struct BrushSide {
  double held_mm = 0.0;    ///< from the grab to the point where the influence begins to fall off
  double way_mm = 0.0;     ///< from there to the end of the change; 0 at an end of the stroke
  double radius_mm = 0.0;  ///< distance at which the influence is 0: way_mm, or more at a free end
};

/// The part of a stroke that a pull moves, by arc length. It is known before the touch and is the
/// same for every displacement (docs/design/editing.md#brush).
///
///   influence  w = 1 on held ink;  next to it w(x) = 1 - 3x^2 + 2x^3, x = distance / radius
///
/// Pins are ends and corners. Towards a pin the radius is at most the distance to it, so that the
/// pin and its tangents stay, because w and w' are 0 there. If a pin is within kPinGrabMm of the
/// grab, it is held instead, with the ink up to it: pin and grab move exactly with the pen. The
/// radius still counts from the grab (if it is less than 4 mm, pins within half of it are held):
/// ink farther along than the radius never moves. On a closed stroke both sides share the length. A
/// side that only the radius limits ends at a joint if there is one in its last fifth, so that no
/// joint has to be added.
struct BrushReach {
  double grab_mm = 0.0;  ///< arc length from the start of the stroke
  BrushSide before, after;
  bool is_whole = false;  ///< the whole stroke moves with the pen
  bool is_ring = false;   ///< the stroke is closed

  /// Return the part of the stroke that moves; on a closed one, last <= first means through the
  /// seam.
  [[nodiscard]] double first_u(const ArcMap& map) const noexcept;
  [[nodiscard]] double last_u(const ArcMap& map) const noexcept;
};

/// Returns the reach of a pull at u0. Requires the arc map of `stroke` and u0 in [0, n].
BrushReach brush_reach(const Stroke& stroke, const ArcMap& map, double u0,
                       const BrushOptions& options);

/// Return w(x) and its derivative; 1 and 0 for x <= 0, 0 and 0 from x = 1 on.
constexpr double influence(double x) noexcept {
  if (x <= 0.0) return 1.0;
  return x < 1.0 ? 1.0 - x * x * (3.0 - 2.0 * x) : 0.0;
}
constexpr double influence_slope(double x) noexcept {
  return x > 0.0 && x < 1.0 ? -6.0 * x * (1.0 - x) : 0.0;
}

}  // namespace felt
