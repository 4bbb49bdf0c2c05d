#pragma once

#include "felt/stroke/arc_map.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// How the brush pulls.
struct BrushOptions {
  double radius_mm = 20.0;  ///< reach of the influence along the ink, to each side
  /// Ends and corners go along as all other ink does, instead of staying where they are.
  bool free_ends = false;
  /// How far the ink may move at the lift, beside the pen, so that it needs few segments; while it
  /// is pulled it follows the exact displacement to a fifth of that.
  double tolerance_mm = 0.1;
};

/// An end or a corner this near to the grab, along the ink, is itself taken hold of.
inline constexpr double kPinGrabMm = 2.0;

/// How far a pull reaches to one side of what is held rigidly.
struct BrushSide {
  double held_mm = 0.0;    ///< from the grab to where the influence begins to fall off
  double way_mm = 0.0;     ///< from there to where the change ends; 0 at an end of the stroke
  double radius_mm = 0.0;  ///< where the influence would be 0: way_mm, or more at a free end
};

/// What of a stroke a pull moves, by arc length: known before the touch, the same for every
/// displacement (architecture section 10).
///
///   influence  w = 1 on what is held;  w(x) = 1 - 3x^2 + 2x^3, x = way / radius, beside it
///
/// Pins are ends and corners. Towards a pin the radius is at most the way to it, so that it stays
/// with its tangents, since w and w' are 0 there. A pin within kPinGrabMm of the grab is held
/// instead, together with the ink up to it: it moves exactly with the pen, and so does the grab.
/// The radius counts from the grab all the same (where it is less than 4 mm, pins within half of it
/// are held): ink farther than the radius from the grab, along the ink, never moves. On a closed
/// stroke both sides share the length. A side that nothing but the radius limits ends at a joint if
/// there is one in its last fifth, so that no joint has to be made.
struct BrushReach {
  double grab_mm = 0.0;  ///< arc length from the start of the stroke
  BrushSide before, after;
  bool is_whole = false;  ///< all of the stroke moves with the pen
  bool is_ring = false;   ///< the stroke is closed

  /// The part of the stroke that moves; on a closed one last <= first goes through the seam.
  [[nodiscard]] double first_u(const ArcMap& map) const noexcept;
  [[nodiscard]] double last_u(const ArcMap& map) const noexcept;
};

/// `map` is of `stroke`; u0 in [0, n].
BrushReach brush_reach(const Stroke& stroke, const ArcMap& map, double u0,
                       const BrushOptions& options);

/// w(x) and its derivative; 1 and 0 for x <= 0, 0 and 0 from x = 1 on.
constexpr double influence(double x) noexcept {
  if (x <= 0.0) return 1.0;
  return x < 1.0 ? 1.0 - x * x * (3.0 - 2.0 * x) : 0.0;
}
constexpr double influence_slope(double x) noexcept {
  return x > 0.0 && x < 1.0 ? -6.0 * x * (1.0 - x) : 0.0;
}

}  // namespace felt
