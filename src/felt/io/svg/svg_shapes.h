#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/io/svg/svg_length.h"
#include "felt/io/svg/svg_path.h"
#include "felt/io/svg/svg_style.h"

namespace pugi {
class xml_node;
}

namespace felt {

/// The outline of a shape of SVG in its user units.
struct SvgOutline {
  std::vector<SvgContour> contours;
  std::string problem;  ///< what of it could not be read, empty where all was
};

/// True for path, rect, circle, ellipse, line, polyline, polygon.
bool is_svg_shape(std::string_view name) noexcept;

/// The outline of an element with such a name, `most_segments` curves of it at most. None of it
/// where its sizes are zero, negative or missing, as the standard has it.
SvgOutline svg_outline(std::string_view name, const pugi::xml_node& node,
                       const SvgDeclared& declared, const SvgUnits& units,
                       std::size_t most_segments);

}  // namespace felt
