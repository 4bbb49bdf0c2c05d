#pragma once

#include <algorithm>
#include <string_view>

#include "felt/material/materials.h"
#include "felt/tools/tool.h"

namespace felt::desktop {

/// The medium at the first start. It is smooth, and exact with a mouse, which presses evenly.
inline constexpr std::string_view kFirstMedium = "ink-pen";

/// Returns an option's row of the table with this program's default. It is the library's default
/// except for the medium and the widths of a tool that draws.
[[nodiscard]] inline OptionSpec as_at_first(ToolKind kind, OptionSpec spec) {
  const Medium* medium = kind == ToolKind::kDraws ? find_medium(kFirstMedium) : nullptr;
  if (!medium) return spec;
  if (spec.id == "material") {
    const auto at = std::find(spec.choices.begin(), spec.choices.end(), kFirstMedium);
    if (at != spec.choices.end()) spec.fallback = static_cast<double>(at - spec.choices.begin());
  }
  if (spec.id == "min_width_mm") spec.fallback = medium->line.min_mm;
  if (spec.id == "max_width_mm") spec.fallback = medium->line.max_mm;
  if (spec.id == "gamma") spec.fallback = medium->line.gamma;
  return spec;
}

}  // namespace felt::desktop
