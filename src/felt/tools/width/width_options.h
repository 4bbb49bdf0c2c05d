#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "felt/stroke/fit/width_map.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// What a gesture of the width tool does.
enum class WidthMode { kBrush, kRetrace, kScale };
/// The direction in which the brush changes the width.
enum class WidthDirection { kPressure, kThicker, kThinner };

inline constexpr std::array<std::string_view, 3> kWidthModes = {"brush", "retrace", "scale"};
inline constexpr std::array<std::string_view, 3> kWidthDirections = {"pressure", "thicker",
                                                                     "thinner"};

/// Rows of kWidthOptions.
struct WidthOption {
  enum Row : std::size_t {
    kMode,
    kDirection,
    kRate,
    kReach,
    kMinWidth,
    kMaxWidth,
    kGamma,
    kMousePressure,
    kStrength,
    kCount
  };
};

inline constexpr std::array<OptionSpec, WidthOption::kCount> kWidthOptions = {{
    {.id = "mode",
     .label = "Mode",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kWidthModes,
     .help = "Brush: thicker or thinner under the pen. Retrace: drawing along a line gives it the "
             "new pressure. Scale: dragging up or down scales a whole line."},
    {.id = "direction",
     .label = "Direction of the brush",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kWidthDirections,
     .help = "By pressure, hard for thicker and light for thinner, or always the same way. The "
             "first button of the pen makes thinner, the second thicker.",
     .when = "mode=brush"},
    {.id = "rate_mm_per_s",
     .label = "Speed of the brush",
     .unit = "mm/s",
     .min = 0.1,
     .max = 50.0,
     .fallback = 6.0,
     .help = "How fast the width changes, per unit of pressure.",
     .when = "mode=brush",
     .is_seldom = true},
    {.id = "reach_mm",
     .label = "Reach of the brush",
     .unit = "mm",
     .min = 1.0,
     .max = 100.0,
     .fallback = 10.0,
     .help = "Length of line, to each side of the pen, whose width changes.",
     .when = "mode=brush"},
    {.id = "min_width_mm",
     .label = "Thinnest retraced line",
     .unit = "mm",
     .min = kMinWidthMm,
     .max = 20.0,
     .fallback = 0.3,
     .help = "Width of a retraced line without pressure.",
     .when = "mode=retrace",
     .is_seldom = true},
    {.id = "max_width_mm",
     .label = "Broadest line",
     .unit = "mm",
     .min = kMinWidthMm,
     .max = 50.0,
     .fallback = 6.0,
     .help =
         "Lines are not made broader than this. Lines that already are broader keep their width.",
     .is_seldom = true},
    {.id = "gamma",
     .label = "Pressure curve",
     .unit = "",
     .min = 0.2,
     .max = 5.0,
     .fallback = 1.0,
     .help = "For retracing: above 1, light pressure stays thin for longer.",
     .when = "mode=retrace",
     .is_seldom = true},
    {.id = "mouse_pressure",
     .label = "Pressure with a mouse",
     .unit = "",
     .min = 0.0,
     .max = 1.0,
     .fallback = 0.75,
     .help = "Pressure for devices that report neither pressure nor depth.",
     .when = "mode=brush|retrace",
     .is_seldom = true},
    strength_option(
        "Force level of friction, stops and pull. Does not affect the hardness of the surface."),
}};

/// The options in the form that the tool uses.
struct WidthSettings {
  WidthMode mode = WidthMode::kBrush;
  WidthDirection direction = WidthDirection::kPressure;
  double rate_mm_per_s = 6.0;
  double reach_mm = 10.0;
  WidthMapOptions map;  ///< for retracing; map.max_mm limits the width in all modes
  double strength = 1.0;
};

/// Reads the options. Requires values of kWidthOptions.
WidthSettings width_settings(const OptionValues& values);

}  // namespace felt
