#pragma once

#include "desktop/engine/actions.h"
#include "desktop/pens/pen_input.h"

namespace felt::desktop {

/// What can be asked of a pen besides drawing with it: pressure on and off ("feel.pressure"), and
/// the tool's modifiers held without a hand ("feel.hold_first", "feel.hold_second"). Both must
/// outlive the actions.
void add_pen_actions(Actions& actions, PenInput& input);

}  // namespace felt::desktop
