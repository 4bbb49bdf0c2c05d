#pragma once

#include "desktop/engine/actions.h"
#include "desktop/pens/pen_input.h"

namespace felt::desktop {

/// Adds the commands for the pen: "feel.pressure" switches pressure on and off; "feel.hold_first"
/// and "feel.hold_second" switch the tool's modifiers on and off, so that the user does not have to
/// hold a key. Both arguments must outlive the actions.
void add_pen_actions(Actions& actions, PenInput& input);

}  // namespace felt::desktop
