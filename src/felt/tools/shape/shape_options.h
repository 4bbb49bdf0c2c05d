#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "felt/tools/shape/shape_ink.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// The names of ShapeKind, in its order.
inline constexpr std::array<std::string_view, 3> kShapeKinds = {"line", "rectangle", "ellipse"};

/// Indices of the rows of kShapeOptions.
struct ShapeOption {
  enum Row : std::size_t { kShape, kStrength, kCount };
};

inline constexpr std::array<OptionSpec, ShapeOption::kCount> kShapeOptions = {{
    {.id = "shape",
     .label = "Shape",
     .unit = "",
     .kind = OptionKind::kChoice,
     .fallback = 1,
     .choices = kShapeKinds,
     .help = "The shape that is drawn from corner to corner, with the current medium and size."},
    strength_option(
        "Force level of the surface's friction and grain. Does not affect its hardness.", 0.5),
}};

/// The values of the options in the form that the tool uses.
struct ShapeSettings {
  ShapeKind kind = ShapeKind::kRectangle;
  double strength = 0.5;
};

/// Returns the settings. Requires values of kShapeOptions.
inline ShapeSettings shape_settings(const OptionValues& values) {
  return {static_cast<ShapeKind>(values.choice(ShapeOption::kShape)),
          values.number(ShapeOption::kStrength)};
}

}  // namespace felt
