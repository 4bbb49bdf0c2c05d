#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "felt/tools/tool_options.h"

namespace felt {

/// Which part of a line is erased.
enum class EraserMode {
  kTouched,   ///< the part that the eraser covers
  kCrossing,  ///< the part of a line between its crossings with other lines or with itself
  kStroke,    ///< the whole line
};

inline constexpr std::array<std::string_view, 3> kEraserModes = {"touched", "crossing", "stroke"};

/// Rows of kEraserOptions.
struct EraserOption {
  enum Row : std::size_t {
    kMode,
    kRadius,
    kIncludeWidth,
    kPressThrough,
    kStrength,
    kGuard,
    kCount
  };
};

inline constexpr std::array<OptionSpec, EraserOption::kCount> kEraserOptions = {{
    {.id = "mode",
     .label = "Erase",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kEraserModes,
     .help = "What is covered, the part of a line up to its next crossings, or the whole line."},
    {.id = "radius_mm",
     .label = "Radius",
     .unit = "mm",
     .min = 0.2,
     .max = 50.0,
     .fallback = 2.0,
     .help = "Radius of the eraser."},
    {.id = "include_width",
     .label = "Erase by ink width",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 1,
     .help = "Erases the ink that the ring covers. If off, cuts a line where the ring covers its "
             "centre line."},
    {.id = "press_through",
     .label = "Press hard for whole lines",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "Pressing hard erases the whole line under the ring. A force-feedback pen clicks at "
             "this pressure."},
    strength_option(
        "Force level of friction and grain. Does not affect the hardness of the surface."),
    {.id = "guard_n",
     .label = "Guard of other lines",
     .unit = "N",
     .min = 0.0,
     .max = 0.4,
     .fallback = 0.25,
     .help = "Largest force with which lines that the eraser has not touched yet push a "
             "force-feedback pen away. Push on to erase them, too."},
}};

/// The options in the form that the tool uses.
struct EraserSettings {
  EraserMode mode = EraserMode::kTouched;
  double radius_mm = 2.0;
  bool include_width = true;
  bool press_through = false;
  double strength = 1.0;
  double guard_n = 0.0;  ///< largest force of lines that were not meant
};

/// Reads the options. Requires values of kEraserOptions.
EraserSettings eraser_settings(const OptionValues& values);

}  // namespace felt
