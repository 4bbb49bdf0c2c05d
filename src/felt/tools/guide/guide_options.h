#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "felt/document/drawing_guide.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// The kinds that the tool places: all except a teacher's path, in the order of DrawingGuideKind.
inline constexpr std::array<std::string_view, kDrawingGuideKinds - 1> kPlacedGuideKinds = {
    "ruler",    "line",        "parallels", "set-square",     "protractor", "compass", "ellipse",
    "ellipses", "perspective", "grid",      "isometric-grid", "symmetry",   "trace"};

/// Indices of the rows of kGuideToolOptions.
struct GuideToolOption {
  enum Row : std::size_t { kKind, kAxes, kPoints, kHold, kStrength, kCount };
};

inline constexpr std::array<OptionSpec, GuideToolOption::kCount> kGuideToolOptions = {{
    {.id = "kind",
     .label = "Kind",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 0,
     .choices = kPlacedGuideKinds,
     .help = "The guide that a drag on a free part of the page places."},
    {.id = "axes",
     .label = "Mirror axes",
     .unit = "",
     .kind = OptionKind::kNumber,
     .min = DrawingGuide::kMinAxes,
     .max = DrawingGuide::kMaxAxes,
     .fallback = 1,
     .choices = {},
     .help = "How many axes a new symmetry has. Each stroke gets twice as many images.",
     .when = "kind=symmetry"},
    {.id = "points",
     .label = "Vanishing points",
     .unit = "",
     .kind = OptionKind::kNumber,
     .min = 1,
     .max = DrawingGuide::kMaxVanishingPoints,
     .fallback = 1,
     .choices = {},
     .help = "How many vanishing points a new perspective has.",
     .when = "kind=perspective"},
    {.id = "hold",
     .label = "Hold",
     .unit = "",
     .kind = OptionKind::kNumber,
     .min = 0.0,
     .max = 1.0,
     .fallback = 1.0,
     .choices = {},
     .help = "How strongly a new guide holds the pen of the pencil."},
    strength_option(
        "Force level of the surface's friction and grain. Does not affect its hardness.", 0.5),
}};

/// The values of the options in the form that the tool uses.
struct GuideToolSettings {
  DrawingGuideKind kind = DrawingGuideKind::kRuler;
  int axes = 1;
  int points = 1;
  double hold = 1.0;
  double strength = 0.5;
};

/// Returns the settings. Requires values of kGuideToolOptions.
inline GuideToolSettings guide_tool_settings(const OptionValues& values) {
  using Row = GuideToolOption;
  return {static_cast<DrawingGuideKind>(values.choice(Row::kKind)),
          static_cast<int>(std::lround(values.number(Row::kAxes))),
          static_cast<int>(std::lround(values.number(Row::kPoints))), values.number(Row::kHold),
          values.number(Row::kStrength)};
}

}  // namespace felt
