#pragma once

#include <cstdint>
#include <optional>

#include "felt/stroke/stroke.h"

namespace felt::desktop {

/// Returns the colour of a page, or of ink, after its material changed. `before` and `now` are the
/// usual colours of the old and the new material (0xRRGGBB); `first` is the colour in a new
/// drawing. If `color` is `before` or `first`, returns `now` with the opacity of `color`. Any other
/// colour was chosen by the user and is returned unchanged. A fully transparent colour is also
/// returned unchanged.
[[nodiscard]] inline Rgba usual_color(Rgba color, std::optional<std::uint32_t> before,
                                      std::uint32_t now, Rgba first) noexcept {
  const auto with = [&color](std::uint32_t rgb) {
    return Rgba{static_cast<std::uint8_t>(rgb >> 16U & 0xFFU),
                static_cast<std::uint8_t>(rgb >> 8U & 0xFFU),
                static_cast<std::uint8_t>(rgb & 0xFFU), color.a};
  };
  first.a = color.a;
  const bool is_chosen = color != first && (!before || color != with(*before));
  return is_chosen || color.a == 0 ? color : with(now);
}

}  // namespace felt::desktop
