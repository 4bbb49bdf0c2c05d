#pragma once

#include <span>
#include <string>

#include "felt/document/edit.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// How far two drawings lie apart.
struct InkDifference {
  double ends_mm = 0.0;   ///< starts and ends of strokes
  double curve_mm = 0.0;  ///< Hausdorff distance of the middle lines, both ways
  /// Of the width at equal shares of the length, without the ends (5 % each). Where a width changes
  /// in a step, the steps may be 0.15 mm apart along the line, which is the tolerance of the fit.
  double width_mm = 0.0;
  std::string other{};  ///< what is not a matter of millimetres: counts, closed, colours
};

/// Strokes in their order, like with like.
InkDifference ink_difference(std::span<const StrokePtr> a, std::span<const StrokePtr> b);

}  // namespace felt
