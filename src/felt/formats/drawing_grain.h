#pragma once

#include "felt/base/result.h"
#include "felt/render/grain.h"
#include "felt/store/felt_file.h"

namespace felt {

/// The grain of the sheet that a drawing says it is made on (SheetPage::surface); of paper where it
/// says none; among those that it brings along, too. Error: a sheet that is not known here, by its
/// id.
Result<Grain> grain_of(const StoredDrawing& drawing);

}  // namespace felt
