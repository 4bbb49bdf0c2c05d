#pragma once

#include <optional>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Returns the tool whose size the user sees and changes: the current tool, or the tool that draws
/// if the current tool has no size of its own (a shape, the lasso).
const Tool& sized_tool(const Session& session);
/// Returns true if the size is the width of new lines.
bool is_line_size(const Session& session);
/// Returns the size of sized_tool().
std::optional<ToolSize> tool_size(const Session& session);

/// Sets the size of the current tool in mm, clamped to the range that the tool allows.
void set_tool_size(Studio& studio, double mm);
/// If the size is the width of new lines, gives the selected lines this width: the widths are
/// scaled so that their mean becomes the size. Does nothing if nothing is selected.
void resize_selected(Studio& studio);
/// Sets the size to the next larger or smaller round number. If the size is already at the end of
/// the tool's range, Studio::refused tells the user. The selected lines
/// follow (resize_selected).
void step_tool_size(Studio& studio, bool up);

/// Returns the next round number above or below `from`. The round numbers are 1, 1.2, 1.5, 2, 2.5,
/// 3, 4, 5, 6, 8, 10, 12, ...
double next_size(double from, bool up);

}  // namespace felt::desktop
