#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "felt/tools/lasso/lasso_take.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// How the user draws an area.
enum class LassoMode : std::uint8_t { kFree, kRectangle };

inline constexpr std::array<std::string_view, 2> kLassoModes = {"free", "rectangle"};
inline constexpr std::array<std::string_view, 4> kLassoTakes = {"parts", "strokes", "points",
                                                                "on-curve"};
inline constexpr std::array<std::string_view, 3> kLassoCombines = {"replace", "add", "subtract"};

/// Rows of kLassoOptions.
struct LassoOption {
  enum Row : std::size_t { kMode, kTake, kCombine, kClickRadius, kStrength, kCount };
};

inline constexpr std::array<OptionSpec, LassoOption::kCount> kLassoOptions = {{
    {.id = "mode",
     .label = "Shape",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kLassoModes,
     .help = "Draw a line around the selection, or a rectangle from corner to corner."},
    {.id = "take",
     .label = "Select",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kLassoTakes,
     .help = "Lines that lead out of the loop: only their part inside (parts), or the whole line "
             "(strokes). By control points, as in the paper (points), or by joints (on-curve)."},
    {.id = "combine",
     .label = "Combine",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kLassoCombines,
     .help = "How to combine with the previous selection; the first button of the pen adds, the "
             "second subtracts.",
     .is_momentary = true},
    {.id = "click_radius_mm",
     .label = "Reach of a click",
     .unit = "mm",
     .min = 0.5,
     .max = 20.0,
     .fallback = 4.0,
     .help = "A short touch selects the nearest line within this distance.",
     .is_seldom = true},
    strength_option(
        "Force level of the surface's friction and grain. Does not affect its hardness."),
}};

/// The options in the form that the tool uses.
struct LassoSettings {
  LassoMode mode = LassoMode::kFree;
  LassoTake take = LassoTake::kParts;
  LassoCombine combine = LassoCombine::kReplace;
  double click_radius_mm = 4.0;
  double strength = 1.0;
};

/// Reads the options. Requires values of kLassoOptions.
LassoSettings lasso_settings(const OptionValues& values);

}  // namespace felt
