#pragma once

#include <cstdint>
#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// Closed paths of lines and cubic curves that are filled together by the non-zero rule.
struct OutlinePath {
  enum class Verb : std::uint8_t {
    kMove,   ///< takes one point and begins a contour
    kLine,   ///< takes one point
    kCubic,  ///< takes two handles and the end
    kClose,  ///< takes none
  };
  std::vector<Verb> verbs;
  std::vector<Point> points;
};

/// The outline of a stroke by curves, for vector files: the ink of `StrokeOutliner`, smooth at any
/// zoom and in a third of the numbers. Each side of a stretch is fitted by as few cubics as stay
/// within the tolerance of its true edge; where a bend is tighter than the half width there is no
/// smooth edge, and the side follows the polygon. Requires tolerance_mm > 0.
OutlinePath outline_path(const Stroke& stroke, double tolerance_mm);

}  // namespace felt
