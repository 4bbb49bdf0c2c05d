#pragma once

#include <algorithm>
#include <string_view>

#include "felt/material/materials.h"
#include "felt/tools/tool.h"

namespace felt::desktop {

/// The medium at the first start. By default the pressure of a mouse is constant, and with constant
/// pressure this medium draws smooth, exact lines.
inline constexpr std::string_view kFirstMedium = "ink-pen";

/// Returns the option's specification with this program's default value. This value differs from
/// the library's default only for the medium, the widths and the pressure curve (gamma) of a tool
/// that draws.
[[nodiscard]] inline OptionSpec as_at_first(ToolKind kind, OptionSpec spec) {
  const Medium* medium = kind == ToolKind::kDraws ? find_medium(kFirstMedium) : nullptr;
  if (!medium) return spec;
  if (spec.id == "medium") {
    const auto at = std::find(spec.choices.begin(), spec.choices.end(), kFirstMedium);
    if (at != spec.choices.end()) spec.fallback = static_cast<double>(at - spec.choices.begin());
  }
  if (spec.id == "min_width_mm") spec.fallback = medium->line.min_mm;
  if (spec.id == "max_width_mm") spec.fallback = medium->line.max_mm;
  if (spec.id == "gamma") spec.fallback = medium->line.gamma;
  return spec;
}

}  // namespace felt::desktop
