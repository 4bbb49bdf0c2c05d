#pragma once

#include "desktop/canvas/canvas.h"
#include "desktop/files/file_actions.h"
#include "desktop/panels/motion_panel.h"

namespace felt::desktop {

/// Connects the panel of key drawings with the canvas, which shows the onion skin and the
/// matches and plays the film, and with the files, which export it.
void connect_motion(MotionPanel& panel, Canvas& canvas, FileActions& files, Actions& actions);

}  // namespace felt::desktop
