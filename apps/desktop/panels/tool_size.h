#pragma once

#include <optional>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// The one size of the tool in hand, in mm. Of the pencil it is the width of the line that a mouse
/// draws, a pen with pressure goes below and beyond it; of the others the option that size_option()
/// names.
struct ToolSize {
  double mm = 0.0;
  double min_mm = 0.0;
  double max_mm = 0.0;
};

/// Nothing if the tool has no size.
std::optional<ToolSize> tool_size(const Session& session);
/// Clamped to its range. The pencil keeps the ratio of its thinnest to its broadest line as long as
/// their ranges allow.
void set_tool_size(Studio& studio, double mm);
/// The next round number above or below. At the end of the range Studio::refused says so.
void step_tool_size(Studio& studio, bool up);

/// The next of the round numbers 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, ... above or below.
double next_size(double from, bool up);

}  // namespace felt::desktop
