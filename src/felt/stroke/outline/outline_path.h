#pragma once

#include <cstdint>
#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// Closed paths of lines and cubic curves that are filled together with the non-zero rule.
struct OutlinePath {
  enum class Verb : std::uint8_t {
    kMove,   ///< one point: starts a contour there
    kLine,   ///< one point: the end of the line
    kCubic,  ///< three points: two handles and the end of the curve
    kClose,  ///< no point
  };
  std::vector<Verb> verbs;
  std::vector<Point> points;
};

/// Returns the outline of a stroke as curves, for vector files: the same ink as from
/// `StrokeOutliner`, but smooth at any zoom and with a third of the coordinates. Each side is
/// fitted by cubics that stay within the tolerance of its true edge, as few as possible. If a bend
/// is tighter than the half width, the edge is not smooth, and the side consists of straight lines.
/// Requires tolerance_mm > 0.
OutlinePath outline_path(const Stroke& stroke, double tolerance_mm);

}  // namespace felt
