#pragma once

#include <cstdint>
#include <optional>

#include "felt/stroke/stroke.h"

namespace felt::desktop {

/// Returns the colour without its opacity, 0xRRGGBB.
[[nodiscard]] inline std::uint32_t rgb_of(Rgba color) noexcept {
  return std::uint32_t{color.r} << 16U | std::uint32_t{color.g} << 8U | color.b;
}

/// Returns the colour `rgb` (0xRRGGBB) with the opacity of `color`.
[[nodiscard]] inline Rgba with_rgb(Rgba color, std::uint32_t rgb) noexcept {
  return {static_cast<std::uint8_t>(rgb >> 16U & 0xFFU),
          static_cast<std::uint8_t>(rgb >> 8U & 0xFFU), static_cast<std::uint8_t>(rgb & 0xFFU),
          color.a};
}

/// Returns the colour of a page, or of ink, after its material changed. `before` and `now` are the
/// usual colours of the old and the new material (0xRRGGBB); `first` is the colour in a new
/// drawing. If `color` is `before` or `first`, returns `now` with the opacity of `color`. Any other
/// colour was chosen by the user and is returned unchanged. A fully transparent colour is also
/// returned unchanged.
[[nodiscard]] inline Rgba usual_color(Rgba color, std::optional<std::uint32_t> before,
                                      std::uint32_t now, Rgba first) noexcept {
  first.a = color.a;
  const bool is_chosen = color != first && (!before || color != with_rgb(color, *before));
  return is_chosen || color.a == 0 ? color : with_rgb(color, now);
}

}  // namespace felt::desktop
