#pragma once

#include <algorithm>
#include <string_view>

#include "felt/material/materials.h"
#include "felt/tools/tool_options.h"

namespace felt::desktop {

/// What is drawn with at first: smooth and exact with a mouse, which presses evenly.
inline constexpr std::string_view kFirstMedium = "ink-pen";

/// The row of a tool's option as this program has it: with what the option is at first as its
/// fallback. All are the library's but the pencil's medium and its widths.
[[nodiscard]] inline OptionSpec as_at_first(std::string_view tool, OptionSpec spec) {
  const Medium* medium = tool == "pencil" ? find_medium(kFirstMedium) : nullptr;
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
