#pragma once

#include "desktop/window/start_options.h"

namespace felt::desktop {

/// Plays the script of the request, if any, and then makes the picture of the window or of one of
/// its dialogs. Returns the exit code of the program; prints errors to stderr.
int make_picture(const PictureRequest& request);

}  // namespace felt::desktop
