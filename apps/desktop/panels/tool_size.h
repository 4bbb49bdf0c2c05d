#pragma once

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Sets the size of the current tool, clamped to its range.
void set_tool_size(Studio& studio, double mm);
/// Sets the next larger or smaller round number. At the end of the range Studio::refused says so.
void step_tool_size(Studio& studio, bool up);

/// Returns the next of the round numbers 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, ... above or
/// below.
double next_size(double from, bool up);

}  // namespace felt::desktop
