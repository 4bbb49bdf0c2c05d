#pragma once

#include <cstdint>
#include <string_view>

#include "felt/base/result.h"
#include "felt/store/database.h"
#include "felt/store/felt_file.h"

namespace felt {

/// The table `material` of a file: texts of materials. A file without material texts does not have
/// this table, nor do files that were written before materials existed. An older program that saves
/// the file keeps the table unchanged.
inline constexpr std::string_view kMaterialTable =
    "CREATE TABLE material(id INTEGER PRIMARY KEY, text TEXT NOT NULL, checksum INTEGER NOT NULL)";

/// Creates and fills the table if the drawing has texts. Fails if the drawing has too many texts,
/// or if a text is not allowed in a file.
Result<void> write_materials(Database& database, const Drawing& drawing);
/// Reads the table from an untrusted database. Requires that the database has the table.
Result<void> read_materials(const Database& database, Drawing& drawing);
/// Returns the checksum that is stored beside a text.
std::int64_t material_checksum(std::string_view text) noexcept;

}  // namespace felt
