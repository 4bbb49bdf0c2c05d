#pragma once

#include <optional>
#include <span>

#include "felt/geometry/point.h"

namespace felt::bench {

/// A position of a pen at a time.
struct Sample {
  Point position;
  double t_s = 0.0;
};

/// Measures of how a stroke was drawn that do not depend on its size.
struct Movement {
  double power = 0.0;     ///< exponent of the law speed ~ curvature^power
  double fit = 0.0;       ///< R squared of that law
  double peaks_hz = 0.0;  ///< peaks of the speed per second
  double jerk = 0.0;      ///< log dimensionless jerk (Hogan, Sternad, J Mot Behav 41, 2009)
};

/// Measures a stroke. Returns nullopt if it is shorter than 0.6 s or does not move.
std::optional<Movement> measure(std::span<const Sample> stroke);

}  // namespace felt::bench
