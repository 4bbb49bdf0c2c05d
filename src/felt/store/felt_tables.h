#pragma once

#include "felt/base/result.h"
#include "felt/store/database.h"
#include "felt/store/felt_file.h"

namespace felt {

/// Makes our tables in an empty database and fills them. Error: something that no file may hold (a
/// page out of its range, a name that is not UTF-8, a stroke that is too large), by its name.
Result<void> write_tables(Database& database, const StoredDrawing& drawing);

/// The other way round, from a database that is not trusted: its tables must be exactly ours, and
/// every row must make sense with the others. Error: names the row and the reason.
Result<StoredDrawing> read_tables(const Database& database);

}  // namespace felt
