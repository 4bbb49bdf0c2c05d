#pragma once

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"

namespace felt::desktop {

/// Adds view.*, the commands that change the view. They are not steps of undo. `canvas` must
/// outlive the actions.
void add_view_actions(Actions& actions, Canvas& canvas);

}  // namespace felt::desktop
