#pragma once

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Adds what can be done to a drawing as a whole: edit.undo, edit.redo (their texts name the step),
/// edit.cancel, edit.delete, edit.duplicate, edit.select_all, edit.select_none,
/// edit.invert_selection. They are enabled while they would do something. Both must live as long
/// as the actions.
void add_edit_actions(Actions& actions, Studio& studio);

}  // namespace felt::desktop
