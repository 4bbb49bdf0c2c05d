#pragma once

#include "felt/base/result.h"
#include "felt/store/carried_file.h"
#include "felt/store/database.h"
#include "felt/store/felt_extras.h"

namespace felt {

/// Writes recordings into a database that has our tables: those that are carried as they are, row
/// by row, then those that were added. Nothing, and no tables, where there are none.
Result<void> write_recordings(Database& to, const FeltExtras& extras, const CarriedFile& carried);

}  // namespace felt
