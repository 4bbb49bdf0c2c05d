#pragma once

#include <optional>
#include <string_view>

#include "felt/stroke/stroke.h"

namespace felt {

/// A colour function of CSS Color 4 or 5: hwb(), lab(), lch(), oklab(), oklch(), color(),
/// color-mix(), light-dark() (its first colour), and the system colours of a light theme. Colours
/// outside of sRGB are held to it, channel by channel; color-mix() mixes in sRGB, whatever space it
/// names. Nullopt for anything else, also for relative colours ("from ...").
std::optional<Rgba> svg_color_in_space(std::string_view text);

}  // namespace felt
