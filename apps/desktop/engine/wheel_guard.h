#pragma once

namespace felt::desktop {

/// Makes the wheel scroll, and never change a value, over every list, number and slider of the
/// program, also in dialogs that are opened later. The exception are tool bars, because nothing
/// scrolls there. Requires a QApplication. Further calls have no effect.
void guard_values_from_wheel();

}  // namespace felt::desktop
