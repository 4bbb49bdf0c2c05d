#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace felt {

/// How the colours of a layer are combined with the colours below it, as CSS mix-blend-mode. The
/// values are stored in the autosave, which holds 16 of them.
enum class BlendMode : std::uint8_t {
  kNormal,    ///< covers what is below
  kMultiply,  ///< multiplies the colours, so that they become darker: shading on line art
};

/// The names of the modes in CSS, files and events, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> kBlendModeNames = {"normal", "multiply"};

constexpr std::string_view blend_mode_name(BlendMode mode) noexcept {
  return kBlendModeNames[static_cast<std::size_t>(mode)];
}

/// Returns the mode with this name, or nullopt if Feltline does not have it.
constexpr std::optional<BlendMode> blend_mode_of(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kBlendModeNames.size(); ++i) {
    if (kBlendModeNames[i] == name) return static_cast<BlendMode>(i);
  }
  return std::nullopt;
}

static_assert(blend_mode_name(BlendMode::kMultiply) == "multiply");

}  // namespace felt
