#pragma once

#include "felt/stroke/stroke.h"
#include "methods.h"

namespace felt::bench {

/// The effects of a pull on a stroke.
struct Effect {
  /// Maximum distance from the old stroke outside the intended span to the new stroke, mm. The span
  /// is the part of the stroke within the brush radius of the grab, measured along the ink.
  double outside_mm = 0.0;
  /// Distance from the pen to the new stroke, mm.
  double pen_mm = 0.0;
  /// Change of the bending energy (new minus old), 1/mm. The energy is the sum of theta^2/h over
  /// points that are h = 0.25 mm apart along the ink, where theta is the turn at a point. This is
  /// the integral of kappa^2 ds for smooth ink, and is finite at corners.
  double bending_per_mm = 0.0;
  /// Change of the total turn (new minus old), degrees. The total turn is the sum of |theta| over
  /// the same points: the integral of |kappa| ds, which does not depend on the size of the ink.
  double turn_deg = 0.0;
  /// Number of smooth joints that turn by more than 0.1 degrees after the pull.
  int breaks = 0;
  int segments_added = 0;
};

/// Measures the effects of a pull. Requires that the stroke is longer than 1 mm.
Effect effect_of(const Pull& pull, const StrokeData& now, double radius_mm);

}  // namespace felt::bench
