#pragma once

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Adds the commands of the menu Guides: show or hide the guides, add a guide of each kind at the
/// middle of the page (a trace: along each selected line), remove all guides, and unlink mirrored
/// lines. The guide tool is chosen after a guide was added, so that the guide can be moved.
void add_guide_actions(Actions& actions, Studio& studio);

}  // namespace felt::desktop
