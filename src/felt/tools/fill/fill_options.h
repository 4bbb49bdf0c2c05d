#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "felt/tools/tool_options.h"

namespace felt {

/// What becomes of a fill whose boundary is opened, in the order of WhenOpened.
inline constexpr std::array<std::string_view, 2> kFillOpened = {"close", "remove"};

/// Indices of the rows of kFillOptions.
struct FillOption {
  enum Row : std::size_t { kGap, kOpened, kRidge, kStrength, kCount };
};

inline constexpr std::array<OptionSpec, FillOption::kCount> kFillOptions = {{
    {.id = "gap_mm",
     .label = "Gap",
     .unit = "mm",
     .min = 0.0,
     .max = 20.0,
     .fallback = 2.0,
     .help = "Gaps of the outline up to this size count as closed. 0: only outlines that touch."},
    {.id = "opened",
     .label = "Opened areas",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kFillOpened,
     .help = "If an edit opens the outline of a fill: a straight edge closes it, or the fill is "
             "removed."},
    {.id = "ridge",
     .label = "Felt edge",
     .unit = "",
     .min = 0.0,
     .max = 1.0,
     .fallback = 0.0,
     .help = "Height of the soft ridge at the edge of the area under the pen while it fills."},
    strength_option("Force level of the surface's friction and grain, and of the ridge. Does not "
                    "affect the surface's hardness."),
}};

/// The values of the options in the form that the tool uses. The session reads `opened`.
struct FillSettings {
  double gap_mm = 2.0;
  double ridge = 0.0;
  double strength = 1.0;
};

/// Returns the settings. Requires values of kFillOptions.
inline FillSettings fill_settings(const OptionValues& values) {
  return {values.number(FillOption::kGap), values.number(FillOption::kRidge),
          values.number(FillOption::kStrength)};
}

}  // namespace felt
