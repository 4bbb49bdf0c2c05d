#pragma once

#include <optional>
#include <string_view>

#include "felt/stroke/stroke.h"

namespace felt {

/// A colour of CSS: #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(), rgba(), hsl(), hsla() with commas or
/// spaces, a name in any case, "transparent", and what svg_color_in_space() reads. None for
/// anything else, "currentColor" included.
std::optional<Rgba> svg_color(std::string_view text);

/// What fills or strokes a shape, as the property says it.
struct SvgPaint {
  enum class Kind {
    kNone,
    kColor,
    kCurrent,        ///< the property `color` of the shape
    kServer,         ///< an element of the file: a gradient, a pattern
    kContextFill,    ///< the filling of the `use` that repeats it
    kContextStroke,  ///< its line
  };
  Kind kind = Kind::kNone;
  Rgba color{0, 0, 0, 255};
  std::string_view server{};      ///< its id
  Kind fallback = Kind::kServer;  ///< kServer: there is none
  Rgba fallback_color{0, 0, 0, 255};
};

/// None: the property has an error and counts as not there.
std::optional<SvgPaint> svg_paint(std::string_view text);

/// The id of "url(#id)", with or without quotes; empty where it is none.
std::string_view svg_reference(std::string_view text);

/// A share as "0.5" or "50%", clamped to 0..1. None: no number.
std::optional<double> svg_share(std::string_view text);

/// A colour with its alpha times a share of 0..1.
Rgba svg_faded(Rgba color, double share) noexcept;

}  // namespace felt
