#pragma once

#include "desktop/window/start_options.h"

namespace felt::desktop {

/// Makes the requested picture of a window or one of its dialogs, after playing a script. Returns
/// the exit code of the program; prints errors to stderr.
int make_picture(const PictureRequest& request);

}  // namespace felt::desktop
