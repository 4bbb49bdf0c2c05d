#pragma once

#include <algorithm>
#include <string_view>

#include "felt/material/materials.h"
#include "felt/tools/tool.h"

namespace felt::desktop {

/// The medium of a first start: smooth, and exact with a mouse, which presses evenly.
inline constexpr std::string_view kFirstMedium = "ink-pen";

/// Returns the row of an option with the default of this program: the library's, except for the
/// medium and the widths of a tool that draws.
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
