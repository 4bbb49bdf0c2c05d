#pragma once

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Sets the size of the current tool in mm, clamped to the range that the tool allows.
void set_tool_size(Studio& studio, double mm);
/// Sets the size to the next larger or smaller round number. If the size is already at the end of
/// the tool's range, Studio::refused tells the user.
void step_tool_size(Studio& studio, bool up);

/// Returns the next round number above or below `from`. The round numbers are 1, 1.2, 1.5, 2, 2.5,
/// 3, 4, 5, 6, 8, 10, 12, ...
double next_size(double from, bool up);

}  // namespace felt::desktop
