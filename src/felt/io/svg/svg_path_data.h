#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "felt/io/svg/svg_path.h"

namespace felt {

/// What path data says, up to its first error.
struct SvgPathData {
  std::vector<SvgContour> contours;
  std::string problem;  ///< what is wrong and where, empty where nothing is
};

/// Reads the attribute `d` by the whole grammar of SVG: repeated commands, numbers that run
/// together, flags without separators. An error ends it; what came before counts, as the standard
/// has it. `most` is the largest magnitude of a number.
SvgPathData parse_svg_path(std::string_view d, std::size_t most_segments, double most = 1e9);

/// Reads pairs of numbers, as polylines have them: x,y x,y ...
struct SvgPointList {
  std::vector<Point> points;
  std::string problem;
};
SvgPointList parse_svg_points(std::string_view text);

}  // namespace felt
