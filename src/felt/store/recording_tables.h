#pragma once

#include "felt/base/result.h"
#include "felt/store/carried_file.h"
#include "felt/store/database.h"
#include "felt/store/felt_extras.h"

namespace felt {

/// Writes recordings into a database that has our tables: first the recordings of `carried`, row by
/// row and unchanged, then those in FeltExtras::added. Creates no tables if there are no
/// recordings.
Result<void> write_recordings(Database& to, const FeltExtras& extras, const CarriedFile& carried);

}  // namespace felt
