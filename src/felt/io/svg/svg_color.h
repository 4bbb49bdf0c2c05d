#pragma once

#include <optional>
#include <string_view>

#include "felt/stroke/stroke.h"

namespace felt {

/// Parses a CSS colour: #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(), rgba(), hsl(), hsla() with commas
/// or spaces, a name in any case, "transparent", and everything that svg_color_in_space() reads.
/// Returns nullopt for anything else, including "currentColor".
std::optional<Rgba> svg_color(std::string_view text);

/// The paint that fills or strokes a shape, as the property specifies it.
struct SvgPaint {
  enum class Kind {
    kNone,
    kColor,
    kCurrent,        ///< currentColor: the property `color` of the shape
    kServer,         ///< an element of the file, such as a gradient or pattern
    kContextFill,    ///< context-fill: the fill of the `use` that repeats the shape
    kContextStroke,  ///< context-stroke: the stroke of that `use`
  };
  Kind kind = Kind::kNone;
  Rgba color{0, 0, 0, 255};
  std::string_view server{};      ///< the id of the element, for kServer
  Kind fallback = Kind::kServer;  ///< paint if the element is missing; kServer: no fallback
  Rgba fallback_color{0, 0, 0, 255};
};

/// Parses a paint. Returns nullopt if the text has an error; the caller then treats the property as
/// missing.
std::optional<SvgPaint> svg_paint(std::string_view text);

/// Returns the id of "url(#id)", with or without quotes; empty if the text is not such a reference.
std::string_view svg_reference(std::string_view text);

/// Parses a fraction, "0.5" or "50%", clamped to 0..1. Returns nullopt if it is not a number.
std::optional<double> svg_share(std::string_view text);

/// Returns the colour with its alpha multiplied by a factor of 0..1.
Rgba svg_faded(Rgba color, double share) noexcept;

}  // namespace felt
