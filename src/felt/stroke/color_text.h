#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "felt/stroke/stroke.h"

namespace felt {

/// The colour that "#rgb", "#rrggbb" or "#rrggbbaa" names; letters of either case. None for any
/// other text.
std::optional<Rgba> color_from_text(std::string_view text) noexcept;

/// "#rrggbb", or "#rrggbbaa" when not opaque; lower case. `color_from_text` gives it back.
std::string color_to_text(Rgba color);

}  // namespace felt
