#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "felt/gather/gathered_stroke.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// The names of GatheredWidth, in its order.
inline constexpr std::array<std::string_view, 2> kGatherWidths = {"median", "strip"};

/// Indices of the rows of kGatherOptions.
struct GatherOption {
  enum Row : std::size_t { kRadius, kWidth, kStrength, kCount };
};

inline constexpr std::array<OptionSpec, GatherOption::kCount> kGatherOptions = {{
    {.id = "radius_mm",
     .label = "Radius",
     .unit = "mm",
     .min = 0.5,
     .max = 20.0,
     .fallback = 4.0,
     .help = "The brush gathers lines within this distance that run along its path."},
    {.id = "width",
     .label = "Width of the line",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kGatherWidths,
     .help = "The line gets the median width of its strokes, or the width of the strip that they "
             "cover."},
    strength_option("Force level of friction, grain and the resistance of the bundle. Does not "
                    "affect the hardness of the surface."),
}};

/// The values of the options in the form that the tool uses.
struct GatherSettings {
  double radius_mm = 4.0;
  GatheredWidth width = GatheredWidth::kMedian;
  double strength = 1.0;
};

/// Returns the settings. Requires values of kGatherOptions.
inline GatherSettings gather_settings(const OptionValues& values) {
  return {values.number(GatherOption::kRadius),
          static_cast<GatheredWidth>(values.choice(GatherOption::kWidth)),
          values.number(GatherOption::kStrength)};
}

}  // namespace felt
