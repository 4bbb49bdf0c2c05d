#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/io/svg/svg_length.h"
#include "felt/io/svg/svg_path_builder.h"
#include "felt/io/svg/svg_style.h"

namespace pugi {
class xml_node;
}

namespace felt {

/// The outline of a shape of SVG in its user units.
struct SvgOutline {
  std::vector<SvgContour> contours;
  std::string problem;  ///< says which part could not be read; empty if there was no error
};

/// Returns true for path, rect, circle, ellipse, line, polyline, polygon.
bool is_svg_shape(std::string_view name) noexcept;

/// Returns the outline of an element for which is_svg_shape() is true, with at most `max_segments`
/// curves. The outline is empty if sizes are zero, negative or missing, as the standard requires.
SvgOutline svg_outline(std::string_view name, const pugi::xml_node& node,
                       const SvgDeclared& declared, const SvgUnits& units,
                       std::size_t max_segments);

}  // namespace felt
