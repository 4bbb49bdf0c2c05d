#pragma once

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Adds the commands for the drawing as a whole: edit.undo, edit.redo (their texts name the step),
/// edit.cancel, edit.delete, edit.duplicate, edit.select_all, edit.select_none,
/// edit.invert_selection. A command is enabled only if it has an effect. Both arguments must
/// outlive the actions.
void add_edit_actions(Actions& actions, Studio& studio);

}  // namespace felt::desktop
