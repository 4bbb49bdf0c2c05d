#pragma once

#include <string_view>

#include "felt/base/result.h"
#include "felt/store/database.h"
#include "felt/store/felt_file.h"
#include "felt/store/page_scan.h"

namespace felt {

/// The table `stroke_name` of a file: the names that strokes had in the file from which they came
/// (Drawing::names). A file without such names does not have this table, nor do files that were
/// written before it existed. An older program that saves the file keeps the rows of the strokes
/// that are left.
inline constexpr std::string_view kStrokeNameTable =
    "CREATE TABLE stroke_name(id INTEGER PRIMARY KEY, stroke INTEGER NOT NULL, "
    "name TEXT NOT NULL, checksum INTEGER NOT NULL)";

/// Returns true if a stroke may have this name in a file: UTF-8 without zero bytes, 1 to
/// limits::kMaxNameBytes bytes long.
bool is_stroke_name(std::string_view name) noexcept;
/// Creates and fills the table if strokes have names. Fails if a name is not allowed in a file.
Result<void> write_stroke_names(Database& database, const Drawing& drawing);
/// Reads the table from an untrusted database, into a drawing that has its strokes. Ignores names
/// of other strokes. Requires that the database has the table.
Result<void> read_stroke_names(const Database& database, Drawing& drawing);
/// Adds the name in a row of a damaged file. Returns false if it is not an intact row of this
/// table.
bool salvage_stroke_name(const ScannedRow& row, StrokeNames& names);

}  // namespace felt
