#pragma once

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/material/materials.h"
#include "felt/render/grain.h"

namespace felt {

/// The grain of the sheet that a drawing says it is made on (SheetPage::surface), and how its media
/// look on it; of paper where it says none. They are those that it brings along, and those that are
/// known here. Error: a sheet that is neither, by its id.
Result<Grain> grain_of(const Drawing& drawing, const Materials& here = Materials::built_in());

}  // namespace felt
