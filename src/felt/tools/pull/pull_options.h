#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "felt/tools/brush_reach.h"
#include "felt/tools/pull/bulge_gesture.h"
#include "felt/tools/pull/grab_pull.h"
#include "felt/tools/pull/push_gesture.h"
#include "felt/tools/pull/sweep_gesture.h"
#include "felt/tools/pull/touch_offset.h"
#include "felt/tools/tool_options.h"

namespace felt {

inline constexpr std::array<std::string_view, 6> kPullModes = {"brush", "grab",  "push",
                                                               "sweep", "bulge", "pinch"};
inline constexpr std::array<std::string_view, 3> kPullWeights = {"soft", "paper", "printed"};

/// In the order of kPullModes.
enum class PullMode : std::uint8_t { kBrush, kGrab, kPush, kSweep, kBulge, kPinch };

/// Rows of kPullOptions.
struct PullOption {
  enum Row : std::size_t {
    kMode,
    kRadius,
    kFreeEnds,
    kKeepOffset,
    kGrabRadius,
    kTolerance,
    kWeights,
    kAffected,
    kNibRadius,
    kSweepTime,
    kYield,
    kStrength,
    kCount
  };
};

inline constexpr std::array<OptionSpec, PullOption::kCount> kPullOptions = {{
    {.id = "mode",
     .label = "Mode",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kPullModes,
     .help =
         "Pull a stretch of a line (brush), bend one segment (grab), push lines from outside "
         "(push), move a line along the pen (sweep), spread all lines around the touch (bulge), "
         "or draw them together (pinch)."},
    {.id = "radius_mm",
     .label = "Radius",
     .unit = "mm",
     .min = 1.0,
     .max = 200.0,
     .fallback = 20.0,
     .help =
         "How far the brush reaches along the line, to each side; the radius of the circle that "
         "bulge and pinch change.",
     .when = "mode=brush|bulge|pinch"},
    {.id = "free_ends",
     .label = "Free ends and corners",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "Ends and corners move along instead of staying; the first modifier inverts this for "
             "one gesture.",
     .when = "mode=brush|grab"},
    {.id = "keep_offset",
     .label = "Keep distance from the pen",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "A grabbed line keeps its distance from the pen instead of moving to it.",
     .when = "mode=brush|grab",
     .is_seldom = true},
    {.id = "grab_radius_mm",
     .label = "Grab radius",
     .unit = "mm",
     .min = 0.5,
     .max = 50.0,
     .fallback = 8.0,
     .help = "Lines farther from the pen than this are not grabbed.",
     .when = "mode=brush|grab|sweep"},
    {.id = "tolerance_mm",
     .label = "Tolerance",
     .unit = "mm",
     .min = 0.01,
     .max = 0.5,
     .fallback = 0.1,
     .help = "How far a line may move when it is simplified after the gesture; more gives fewer "
             "segments.",
     .when = "mode=brush|bulge|pinch",
     .is_seldom = true},
    {.id = "weights",
     .label = "Weights",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kPullWeights,
     .help =
         "How grab and sweep bend a segment: with least motion (soft), by the paper's three cases "
         "(paper), or by its equation 7 as printed, which moves the line less than the pen.",
     .when = "mode=grab|sweep",
     .is_seldom = true},
    {.id = "affected_mm",
     .label = "Length bent by grab",
     .unit = "mm",
     .min = 0.0,
     .max = 200.0,
     .fallback = 0.0,
     .help = "Grab divides the line so that no more than this is bent; 0 bends whole segments.",
     .when = "mode=grab"},
    {.id = "nib_radius_mm",
     .label = "Radius of the nib",
     .unit = "mm",
     .min = 0.5,
     .max = 50.0,
     .fallback = 3.0,
     .help = "Size of the round nib that pushes lines.",
     .when = "mode=push"},
    {.id = "sweep_time_s",
     .label = "Time of sweep",
     .unit = "s",
     .min = 0.005,
     .max = 1.0,
     .fallback = 0.05,
     .help = "How slowly a line gives way to the pen that sweeps it.",
     .when = "mode=sweep",
     .is_seldom = true},
    {.id = "yield_s",
     .label = "Time to yield",
     .unit = "s",
     .min = 0.0,
     .max = 0.05,
     .fallback = 0.01,
     .help = "How long the counter-force lasts when the pen rests; 0: as long as the pen is down, "
             "as in the paper.",
     .when = "mode=brush|grab|bulge|pinch",
     .is_seldom = true},
    strength_option("Force level of the counter-force, friction and grain. Does not affect the "
                    "hardness of the surface."),
}};

/// The options in the form that the tool uses.
struct PullSettings {
  PullMode mode = PullMode::kBrush;
  BrushOptions brush;
  GrabOptions grab;
  PushOptions push;
  SweepOptions sweep;
  BulgeOptions bulge;
  TouchOffset offset = TouchOffset::kBlendedOut;
  double grab_radius_mm = 8.0;
  double yield_s = 0.0;  ///< time constant of the origin of the counter-force; 0: it stays
  double strength = 1.0;
};

/// Reads the options. Requires values of kPullOptions.
PullSettings pull_settings(const OptionValues& values);

}  // namespace felt
