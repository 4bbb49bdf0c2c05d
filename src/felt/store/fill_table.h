#pragma once

#include <cstdint>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/store/database.h"

namespace felt {

/// The table `fill` of a file. A drawing without fills does not have this table, nor do files that
/// were written before fills existed. An older program that saves the file keeps the table, except
/// for the fills of deleted layers.
inline constexpr std::string_view kFillTable =
    "CREATE TABLE fill(id INTEGER PRIMARY KEY, layer INTEGER NOT NULL, place INTEGER NOT NULL, "
    "shape BLOB NOT NULL, checksum INTEGER NOT NULL)";

/// Creates and fills the table if the document has fills.
Result<void> write_fills(Database& database, const Document& document);
/// Reads the table from an untrusted database into an edit that adds the fills. Requires that the
/// database has the table.
Result<void> read_fills(const Database& database, Edit& edit);
/// Returns the checksum that is stored in the row of a fill.
std::int64_t fill_checksum(std::int64_t id, std::int64_t layer, std::int64_t place,
                           std::string_view shape);

}  // namespace felt
