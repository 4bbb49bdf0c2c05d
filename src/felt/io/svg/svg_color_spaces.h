#pragma once

#include <optional>
#include <string_view>

#include "felt/stroke/stroke.h"

namespace felt {

/// Parses a colour function of CSS Color 4 or 5: hwb(), lab(), lch(), oklab(), oklch(), color(),
/// color-mix(), light-dark() (its first colour), and the system colours of a light theme. Colours
/// outside sRGB are clamped channel by channel. color-mix() always mixes in sRGB, even if it names
/// another space. Returns nullopt for anything else, including relative colours ("from ...").
std::optional<Rgba> svg_color_in_space(std::string_view text);

}  // namespace felt
