#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "felt/stroke/stroke.h"

namespace felt {

/// Returns the colour of "#rgb", "#rrggbb" or "#rrggbbaa", in upper or lower case; nullopt for any
/// other text.
std::optional<Rgba> color_from_text(std::string_view text) noexcept;

/// Returns "#rrggbb", or "#rrggbbaa" if the colour is not opaque, in lower case. `color_from_text`
/// converts it back.
std::string color_to_text(Rgba color);

}  // namespace felt
