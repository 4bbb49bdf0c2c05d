#pragma once

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/material/materials.h"
#include "felt/render/grain.h"

namespace felt {

/// Returns the grain of a drawing's surface (SheetPage::surface), or the grain of paper if the
/// drawing names no surface, and how its media look on it. Searches the drawing's own materials and
/// those in `here`. Fails if neither of them contains the surface; the message names its id.
Result<Grain> grain_of(const Drawing& drawing, const Materials& here = Materials::built_in());

}  // namespace felt
