#pragma once

#include <array>
#include <cstddef>

#include "felt/tools/snapping.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// Rows of kConnectOptions.
struct ConnectOption {
  enum Row : std::size_t {
    kSnap,
    kGrabRadius,
    kReach,
    kSnapRadius,
    kAttraction,
    kExtend,
    kKeepSeparate,
    kStrength,
    kCount
  };
};

/// The table of options of the connect tool (docs/design/editing.md#joining).
inline constexpr std::array<OptionSpec, ConnectOption::kCount> kConnectOptions{{
    {.id = "snap",
     .label = "Snapping",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 3,
     .choices = kSnapModes,
     .help = "Whether ends of lines attract the pen (force), connect to the dragged end (snap), or "
             "both."},
    {.id = "grab_radius_mm",
     .label = "Grab radius",
     .unit = "mm",
     .min = 0.5,
     .max = 40.0,
     .fallback = 8.0,
     .help = "Distance within which the pen grabs the end of a line.",
     .is_seldom = true},
    {.id = "reach_mm",
     .label = "Reach of the attraction",
     .unit = "mm",
     .min = 1.0,
     .max = 40.0,
     .fallback = 8.0,
     .help = "Radius around the end of a line within which it attracts the dragged end; a tap "
             "connects ends that are this near.",
     .is_seldom = true},
    {.id = "snap_radius_mm",
     .label = "Snap radius",
     .unit = "mm",
     .min = 0.1,
     .max = 20.0,
     .fallback = 2.0,
     .help = "Radius within which the dragged end is connected.",
     .is_seldom = true},
    {.id = "attraction_n",
     .label = "Attraction",
     .unit = "N",
     .min = 0.0,
     .max = 0.8,
     .fallback = 0.6,
     .help = "Force that draws the pen to the end of a line.",
     .when = "snap=force|both",
     .is_seldom = true},
    {.id = "extend",
     .label = "Leave the end where it is let go",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "An end that is let go beside all others stays there; without it, it goes back. The "
             "first modifier chooses the other.",
     .is_seldom = true},
    {.id = "keep_separate",
     .label = "Keep lines separate",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "Lines that meet share the point but stay two lines.",
     .is_seldom = true},
    strength_option(
        "Force level of friction, grain, attraction and pull. Does not affect surface stiffness."),
}};

/// The options in the form that the tool uses.
struct ConnectSettings {
  SnapOptions snap;
  double grab_radius_mm = 8.0;
  bool extend = false;
  bool keep_separate = false;
  double strength = 1.0;
};

/// Reads the options. Requires values of kConnectOptions.
ConnectSettings connect_settings(const OptionValues& values);

}  // namespace felt
