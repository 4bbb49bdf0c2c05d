#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "felt/io/svg/svg_path_builder.h"

namespace felt {

/// The contours of path data, up to the first error in the data.
struct SvgPathData {
  std::vector<SvgContour> contours;
  std::string problem;  ///< the error and its position, or empty
};

/// Parses the attribute `d` in the full grammar of SVG: repeated commands, numbers without
/// separators, flags without separators. Parsing stops at an error; the commands before it are
/// used, as the standard requires. `max_number` is the largest magnitude of a number.
SvgPathData parse_svg_path(std::string_view d, std::size_t max_segments, double max_number = 1e9);

/// Pairs of numbers, as in polylines: x,y x,y ...
struct SvgPointList {
  std::vector<Point> points;
  std::string problem;
};
SvgPointList parse_svg_points(std::string_view text);

}  // namespace felt
