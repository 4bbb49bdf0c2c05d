#pragma once

#include "desktop/engine/actions.h"
#include "desktop/pens/pen_input.h"

namespace felt::desktop {

/// Adds the commands for the pen: pressure on and off ("feel.pressure"), and the tool's modifiers,
/// which these commands hold without a key ("feel.hold_first", "feel.hold_second"). Both arguments
/// must outlive the actions.
void add_pen_actions(Actions& actions, PenInput& input);

}  // namespace felt::desktop
