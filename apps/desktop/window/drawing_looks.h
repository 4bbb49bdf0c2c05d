#pragma once

#include "desktop/canvas/canvas.h"
#include "desktop/files/file_actions.h"
#include "desktop/panels/colors_panel.h"

namespace felt::desktop {

/// Returns the functions that store the view and the palette of a window in its drawing, and show
/// those of a drawing. Both arguments must outlive the result.
DrawingLooks looks_of(Canvas& canvas, ColorsPanel& colors);

}  // namespace felt::desktop
