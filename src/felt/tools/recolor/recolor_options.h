#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "felt/tools/tool_options.h"

namespace felt {

/// What the lines get. The values are the indices of kRecolorGives.
enum class RecolorGives : std::uint8_t { kColor, kMedium, kBoth };

inline constexpr std::array<std::string_view, 3> kRecolorGives = {"colour", "medium", "both"};

/// Indices of the rows of kRecolorOptions.
struct RecolorOption {
  enum Row : std::size_t { kGives, kRadius, kStrength, kCount };
};

inline constexpr std::array<OptionSpec, RecolorOption::kCount> kRecolorOptions = {{
    {.id = "gives",
     .label = "Gives",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kRecolorGives,
     .help = "The lines get the current colour with its opacity, the current medium, or both."},
    {.id = "radius_mm",
     .label = "Radius",
     .unit = "mm",
     .min = 0.1,
     .max = 20.0,
     .fallback = 1.0,
     .help = "Lines whose ink is within this distance of the pen are changed."},
    strength_option(
        "Force level of the surface's friction and grain. Does not affect its hardness."),
}};

/// The values of the options in the form that the tool uses.
struct RecolorSettings {
  RecolorGives gives = RecolorGives::kColor;
  double radius_mm = 1.0;
  double strength = 1.0;
};

/// Returns the settings. Requires values of kRecolorOptions.
inline RecolorSettings recolor_settings(const OptionValues& values) {
  return {static_cast<RecolorGives>(values.choice(RecolorOption::kGives)),
          values.number(RecolorOption::kRadius), values.number(RecolorOption::kStrength)};
}

}  // namespace felt
