#pragma once

#include <cstdint>
#include <optional>

#include "felt/stroke/stroke.h"

namespace felt::desktop {

/// The colour of a page, or of ink, once its material is another one: the usual colour of that,
/// 0xRRGGBB, where it still is the usual one of the material `before` or `first`, that of a new
/// drawing. Else a person chose it, and it stays, as does no colour at all. Opacity stays.
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
