#pragma once

#include "desktop/window/start_options.h"

namespace felt::desktop {

/// Makes the picture that is asked for: a window, or one of its dialogs, after a script was played.
/// The exit code of the program; says on stderr what went wrong.
int make_picture(const PictureRequest& request);

}  // namespace felt::desktop
