#pragma once

#include <optional>
#include <string_view>

#include "felt/stroke/stroke.h"

namespace felt {

class SvgDocument;

/// What a gradient or pattern looks like as one colour: the mean of a gradient along its way from 0
/// to 1, grey for patterns. None where there is no such element that paints, or a gradient without
/// stops, which paints nothing. `current` is what currentColor means.
struct SvgServerColor {
  bool paints = false;  ///< whether the id names a gradient, pattern or their like
  std::optional<Rgba> color;
  bool is_gradient = false;
  bool is_solid = false;  ///< solidColor of SVG Tiny: that colour, exactly
};
SvgServerColor svg_server_color(SvgDocument& document, std::string_view id, Rgba current);

}  // namespace felt
