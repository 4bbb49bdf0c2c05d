#pragma once

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"

namespace felt::desktop {

/// Adds the commands that change the view (view.*). Changes of the view cannot be undone. `canvas`
/// must outlive the actions.
void add_view_actions(Actions& actions, Canvas& canvas);

}  // namespace felt::desktop
