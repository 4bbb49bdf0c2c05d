#pragma once

#include <span>
#include <string>

#include "felt/document/edit.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// The distance between two drawings.
struct InkDifference {
  double ends_mm = 0.0;   ///< starts and ends of strokes
  double curve_mm = 0.0;  ///< Hausdorff distance of the middle lines, in both directions
  /// Largest difference of the width at equal fractions of the length, without the ends (5 % each).
  /// If a width changes in a step, the steps may be 0.15 mm apart along the line, which is the
  /// tolerance of the fit.
  double width_mm = 0.0;
  std::string other{};  ///< differences without a distance: counts, closed, colours
};

/// Compares strokes in their order.
InkDifference ink_difference(std::span<const StrokePtr> a, std::span<const StrokePtr> b);

}  // namespace felt
