#pragma once

#include "felt/stroke/stroke.h"
#include "methods.h"

namespace felt::bench {

/// What a pull has done to a stroke.
struct Effect {
  /// Largest distance from a place of the old stroke beyond the intended span to the new stroke,
  /// mm. The span: within the radius of the grab, along the ink.
  double outside_mm = 0.0;
  /// From the pen to the new stroke, mm.
  double pen_mm = 0.0;
  /// Bending energy, sum of theta^2/h over points h = 0.25 mm apart along the ink, theta the turn
  /// there: the integral of kappa^2 ds where the ink is smooth, and finite where it is not. New
  /// minus old, 1/mm.
  double bending_per_mm = 0.0;
  /// Whole turn, sum of |theta| over the same points: the integral of |kappa| ds, whatever the size
  /// of the ink. New minus old, degrees.
  double turn_deg = 0.0;
  /// Smooth joints of the stroke that turn by more than 0.1 degrees now.
  int breaks = 0;
  int segments_added = 0;
};

/// Requires that the stroke is longer than a millimetre.
Effect effect_of(const Pull& pull, const StrokeData& now, double radius_mm);

}  // namespace felt::bench
