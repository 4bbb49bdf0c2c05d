#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "felt/tools/tool_options.h"

namespace felt {

/// Which transform a touch begins.
enum class TransformMode : std::uint8_t { kAuto, kMove, kRotate, kScale, kStretch };

inline constexpr std::array<std::string_view, 5> kTransformModes = {"auto", "move", "rotate",
                                                                    "scale", "stretch"};

/// Rows of kTransformOptions.
struct TransformOption {
  enum Row : std::size_t {
    kMode,
    kConstrain,
    kDuplicate,
    kAboutCentre,
    kScaleWidths,
    kGrabRadius,
    kStrength,
    kCount
  };
};

inline constexpr std::array<OptionSpec, TransformOption::kCount> kTransformOptions = {{
    {.id = "mode",
     .label = "What a touch does",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kTransformModes,
     .help = "By the handle that is touched (auto), or always the same."},
    {.id = "constrain",
     .label = "Constrain",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "Moves along one axis, turns in steps of 15 degrees, and corners stretch both axes "
             "freely, like the first button of the pen.",
     .is_momentary = true},
    {.id = "duplicate",
     .label = "Duplicate",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "Keeps the lines and transforms a copy, like the second button of the pen.",
     .is_momentary = true},
    {.id = "about_centre",
     .label = "About the centre",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help =
         "Corners and edges scale and stretch about the centre and not about the opposite side, "
         "like the third button of the pen.",
     .is_momentary = true},
    {.id = "scale_widths",
     .label = "Scale widths",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "Scaling makes lines broader or thinner as well."},
    {.id = "grab_radius_mm",
     .label = "Reach",
     .unit = "mm",
     .min = 0.5,
     .max = 20.0,
     .fallback = 4.0,
     .help = "If nothing is selected, a touch selects the nearest line within this distance.",
     .is_seldom = true},
    strength_option("Force level of the tethers, friction and grain."),
}};

/// The options in the form that the tool uses.
struct TransformSettings {
  TransformMode mode = TransformMode::kAuto;
  bool constrain = false;
  bool duplicate = false;
  bool about_centre = false;
  bool scale_widths = false;
  double grab_radius_mm = 4.0;
  double strength = 1.0;
};

/// Reads the options. Requires values of kTransformOptions.
TransformSettings transform_settings(const OptionValues& values);

}  // namespace felt
