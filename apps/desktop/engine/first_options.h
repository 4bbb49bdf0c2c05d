#pragma once

#include <string_view>

#include "felt/tools/tool_options.h"

namespace felt::desktop {

/// How hard a mouse presses with the pencil, 0..1: a line of 1.3 mm, which is a pen's, where the
/// library's 0.5 (R18) is a marker's.
inline constexpr double kFirstMousePressure = 0.18;
inline constexpr auto kMousePressureId = "pencil.mouse_pressure";

/// The row of a tool's option as this program has it: with what the option is at first as its
/// fallback. All are the library's but pencil.mouse_pressure.
[[nodiscard]] inline OptionSpec as_at_first(std::string_view tool, OptionSpec spec) {
  if (tool == "pencil" && spec.id == "mouse_pressure") spec.fallback = kFirstMousePressure;
  return spec;
}

}  // namespace felt::desktop
