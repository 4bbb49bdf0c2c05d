#pragma once

#include "desktop/window/start_options.h"

namespace felt::desktop {

/// Plays the requested script and makes the requested picture of a window or one of its dialogs.
/// Returns the exit code of the program; prints errors to stderr.
int make_picture(const PictureRequest& request);

}  // namespace felt::desktop
