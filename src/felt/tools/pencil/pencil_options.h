#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/steady/shake.h"
#include "felt/tools/line_stabiliser.h"
#include "felt/tools/pencil/meanings.h"
#include "felt/tools/snapping.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// The ids of the built-in media that draw, as in media(). A session may have user-defined media,
/// too.
inline constexpr std::array<std::string_view, 9> kPencilMedia = {
    "pencil", "pencil-hard", "pencil-soft", "charcoal", "chalk",
    "crayon", "felt-tip",    "ink-pen",     "brush-pen"};
inline constexpr std::array<std::string_view, 3> kStabilisers = {"off", "inertia", "towed"};

/// Rows of kPencilOptions.
struct PencilOption {
  enum Row : std::size_t {
    kMedium,
    kMinWidth,
    kMaxWidth,
    kGamma,
    kWidthSteps,
    kMousePressure,
    kMouseTilt,
    kTolerance,
    kRefine,
    kSnap,
    kReach,
    kSnapRadius,
    kAttraction,
    kKeepSeparate,
    kRetrace,
    kStabiliser,
    kStabiliserMass,
    kStabiliserLength,
    kSteady,
    kSteadyHz,
    kSteadyAmplitude,
    kSteadyAxis,
    kScratchOut,
    kDoubleLoop,
    kShapes,
    kStrength,
    kCount
  };
};

inline constexpr std::array<OptionSpec, PencilOption::kCount> kPencilOptions = {{
    {.id = "medium",
     .label = "Medium",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kPencilMedia,
     .help = "The medium: how it looks and how it slides.",
     .open = OpenChoice::kMedia,
     .former_id = "material"},
    {.id = "min_width_mm",
     .label = "Thinnest line",
     .unit = "mm",
     .min = kMinWidthMm,
     .max = 20.0,
     .fallback = 0.3,
     .help = "Width of a line without pressure.",
     .is_seldom = true},
    {.id = "max_width_mm",
     .label = "Broadest line",
     .unit = "mm",
     .min = kMinWidthMm,
     .max = 50.0,
     .fallback = 6.0,
     .help = "Width of a line at full pressure; at least that of the thinnest line.",
     .is_seldom = true},
    {.id = "gamma",
     .label = "Pressure curve",
     .unit = "",
     .min = 0.2,
     .max = 5.0,
     .fallback = 1.0,
     .help = "Above 1, light pressure stays thin for longer; below 1, lines broaden sooner.",
     .is_seldom = true},
    {.id = "width_steps",
     .label = "Widths in steps",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "Holds the width at steps such as 0.3, 0.5 and 0.7 mm. A force-feedback pen clicks "
             "from step to step.",
     .is_seldom = true},
    {.id = "mouse_pressure",
     .label = "Pressure with a mouse",
     .unit = "",
     .min = 0.0,
     .max = 1.0,
     .fallback = 0.5,
     .help = "Pressure for devices that report neither pressure nor depth.",
     .is_seldom = true},
    {.id = "tilt_deg",
     .label = "Tilt with a mouse",
     .unit = "°",
     .min = 0.0,
     .max = 80.0,
     .fallback = 0.0,
     .help = "Tilt of the pen from upright, if the device does not report it. Some media draw "
             "broader and softer when tilted.",
     .is_seldom = true,
     .former_id = "lean_deg"},
    {.id = "tolerance_mm",
     .label = "Tolerance",
     .unit = "mm",
     .min = 0.05,
     .max = 3.0,
     .fallback = 0.15,
     .help = "Largest distance between the path of the pen and the line.",
     .is_seldom = true},
    {.id = "refine",
     .label = "Refine at pen-up",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 1,
     .help =
         "Fits the finished line again, with fewer segments within the same tolerance; lines of "
         "more than a minute stay as drawn.",
     .is_seldom = true},
    {.id = "snap",
     .label = "Snapping",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 3,
     .choices = kSnapModes,
     .help = "Whether a line that is meant to meet another or itself is attracted (force), "
             "connected (snap), or both."},
    {.id = "reach_mm",
     .label = "Reach of the attraction",
     .unit = "mm",
     .min = 1.0,
     .max = 40.0,
     .fallback = 3.0,
     .help = "How near to its target the pen is attracted, if it comes slowly and heads for it.",
     .when = "snap=force|both",
     .is_seldom = true},
    {.id = "snap_radius_mm",
     .label = "Snap radius",
     .unit = "mm",
     .min = 0.1,
     .max = 20.0,
     .fallback = 1.5,
     .help = "How near to its target a line that is meant to meet it is connected.",
     .when = "snap=snap|both",
     .is_seldom = true},
    {.id = "attraction_n",
     .label = "Attraction",
     .unit = "N",
     .min = 0.0,
     .max = 1.0,
     .fallback = 0.2,
     .help = "Force that draws a slow pen to its target, beyond the friction of the device.",
     .when = "snap=force|both",
     .is_seldom = true},
    {.id = "keep_separate",
     .label = "Keep lines separate",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 1,
     .help = "Lines that meet share the point but stay two lines; a line that meets both ends of "
             "another still closes it.",
     .when = "snap=snap|both",
     .is_seldom = true},
    {.id = "retrace_n",
     .label = "Retracing",
     .unit = "N",
     .min = 0.0,
     .max = 0.2,
     .fallback = 0.1,
     .help = "Force that holds a slow pen to a line that it draws over; 0 for none.",
     .is_seldom = true},
    {.id = "stabiliser",
     .label = "Stabiliser",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kStabilisers,
     .help = "Steadies the hand: the line is drawn by a mass, or by a nib on a rope."},
    {.id = "stabiliser_mass_g",
     .label = "Mass of the stabiliser",
     .unit = "g",
     .min = 5.0,
     .max = 500.0,
     .fallback = 50.0,
     .help = "A larger mass draws smoother lines with more lag; for the stabiliser 'inertia'.",
     .when = "stabiliser=inertia",
     .is_seldom = true},
    {.id = "stabiliser_length_mm",
     .label = "Rope of the stabiliser",
     .unit = "mm",
     .min = 0.5,
     .max = 40.0,
     .fallback = 4.0,
     .help = "A longer rope draws smoother lines with more lag; for the stabiliser 'towed'.",
     .when = "stabiliser=towed",
     .is_seldom = true},
    {.id = "steady",
     .label = "Steady hand",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "Removes the shaking of the hand from lines; Preferences > Pen measures how it "
             "shakes."},
    {.id = "steady_hz",
     .label = "Shakes a second",
     .unit = "Hz",
     .min = Shake::kMinHz,
     .max = Shake::kMaxHz,
     .fallback = 5.0,
     .help = "How often the hand shakes; for the steady hand.",
     .is_seldom = true},
    {.id = "steady_mm",
     .label = "Size of the shaking",
     .unit = "mm",
     .min = Shake::kMinAmplitudeMm,
     .max = Shake::kMaxAmplitudeMm,
     .fallback = 1.0,
     .help = "How far the hand shakes, from the middle to one side; for the steady hand.",
     .is_seldom = true},
    {.id = "steady_axis_deg",
     .label = "Direction of the shaking",
     .unit = "°",
     .min = 0.0,
     .max = Shake::kMaxAxisDeg,
     .fallback = 0.0,
     .help = "Direction of the largest shaking, clockwise from the right; for the steady hand.",
     .is_seldom = true},
    {.id = "scratch_out",
     .label = "Scratch out",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "Scribble over lines, at least six times to and fro: deleting them is offered."},
    {.id = "double_loop",
     .label = "Circle twice to select",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "Circle lines twice in one stroke: selecting them is offered."},
    {.id = "shapes",
     .label = "Hold for a shape",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "Hold the pen still at the end of a line: the shape that it resembles is offered. "
             "Press harder to get it, or go on drawing."},
    strength_option(
        "Force level of friction, grain, attraction, hold, retracing and stabiliser. Does not "
        "affect the hardness of the surface.",
        0.6),
}};

/// The options in the form that the tool uses.
struct PencilSettings {
  std::string medium;
  InkFitOptions ink;
  bool refine = true;
  SnapOptions snap;
  bool keep_separate = false;
  double retrace_n = 0.0;  ///< largest force of a line that is drawn over
  bool width_steps = false;
  StabiliserOptions stabiliser;
  std::optional<Shake> steady;  ///< the shaking to remove, if any
  GestureOptions gestures;
  double strength = 1.0;
};

/// Reads the options. Requires values of kPencilOptions.
PencilSettings pencil_settings(const OptionValues& values);

}  // namespace felt
