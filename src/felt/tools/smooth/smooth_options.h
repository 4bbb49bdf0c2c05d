#pragma once

#include <array>
#include <cstddef>

#include "felt/tools/smooth/ironing.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// Rows of kSmoothOptions.
struct SmoothOption {
  enum Row : std::size_t { kRadius, kAmount, kSmoothCorners, kTolerance, kStrength, kCount };
};

inline constexpr std::array<OptionSpec, SmoothOption::kCount> kSmoothOptions = {{
    {.id = "radius_mm",
     .label = "Radius",
     .unit = "mm",
     .min = 2.0,
     .max = 40.0,
     .fallback = 10.0,
     .help = "Length of line on both sides of the pen that is smoothed. Waves up to this length "
             "can be removed."},
    {.id = "amount",
     .label = "Amount",
     .unit = "",
     .min = 0.05,
     .max = 1.0,
     .fallback = 0.5,
     .help = "How fast it irons; pressing harder irons faster too."},
    {.id = "smooth_corners",
     .label = "Smooth corners too",
     .unit = "",
     .kind = OptionKind::kSwitch,
     .fallback = 0,
     .help = "Rounds corners, which otherwise stay; ends of lines always do."},
    {.id = "tolerance_mm",
     .label = "Tolerance",
     .unit = "mm",
     .min = 0.01,
     .max = 0.5,
     .fallback = 0.05,
     .help = "How far the finished line may be from the ironed one, for fewer segments.",
     .is_seldom = true},
    strength_option("Force level of friction and roughness. Does not affect surface stiffness."),
}};

/// The options in the form that the tool uses.
struct SmoothSettings {
  double radius_mm = 10.0;
  double amount = 0.5;
  IronOptions iron;
  double strength = 1.0;
};

/// Reads the options. Requires values of kSmoothOptions.
inline SmoothSettings smooth_settings(const OptionValues& values) {
  using Row = SmoothOption::Row;
  SmoothSettings s;
  s.radius_mm = values.number(Row::kRadius);
  s.amount = values.number(Row::kAmount);
  s.iron.wave_mm = s.radius_mm;
  s.iron.smooth_corners = values.is_on(Row::kSmoothCorners);
  s.iron.tolerance_mm = values.number(Row::kTolerance);
  s.strength = values.number(Row::kStrength);
  return s;
}

}  // namespace felt
