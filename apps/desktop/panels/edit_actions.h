#pragma once

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Adds the commands that edit the drawing: edit.undo and edit.redo (with the name of the step in
/// their texts), edit.exact, edit.cancel, edit.delete, edit.duplicate, edit.broader,
/// edit.thinner, edit.to_front, edit.to_back, edit.select_all, edit.select_none,
/// edit.invert_selection. A command is enabled only while it would have an effect. Both arguments
/// must outlive the actions.
void add_edit_actions(Actions& actions, Studio& studio);

}  // namespace felt::desktop
