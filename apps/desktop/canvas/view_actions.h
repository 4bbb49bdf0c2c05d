#pragma once

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"

namespace felt::desktop {

/// Adds view.*: how the sheet is looked at. None of it is a step of undo. `canvas` must outlive
/// the actions.
void add_view_actions(Actions& actions, Canvas& canvas);

}  // namespace felt::desktop
