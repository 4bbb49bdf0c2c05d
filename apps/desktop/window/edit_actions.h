#pragma once

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Adds undo, redo, cancel, delete, duplicate and what selects, as far as no other room has them.
/// They are enabled when they would do something.
void add_edit_actions(Actions& actions, Studio& studio);

}  // namespace felt::desktop
