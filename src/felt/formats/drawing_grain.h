#pragma once

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/material/materials.h"
#include "felt/render/grain.h"

namespace felt {

/// Returns the grain of a drawing's surface (Page::surface), or the grain of paper if the
/// drawing names no surface. The Grain also describes how each medium looks on this surface.
/// Searches the materials of the drawing, then those in `here`. Fails if the surface is in neither;
/// the message contains the id of the surface.
Result<Grain> grain_of(const Drawing& drawing, const Materials& here = Materials::built_in());

}  // namespace felt
