#pragma once

#include <cstdint>
#include <string_view>

#include "felt/base/result.h"
#include "felt/store/database.h"
#include "felt/store/felt_file.h"

namespace felt {

/// The table `material` of a file: texts of materials. A file without any has no such table, as all
/// files from before there were any; a program that does not know it carries it on.
inline constexpr std::string_view kMaterialTable =
    "CREATE TABLE material(id INTEGER PRIMARY KEY, text TEXT NOT NULL, checksum INTEGER NOT NULL)";

/// Makes and fills it where the drawing has texts. Error: more of them, or others, than a file may
/// hold.
Result<void> write_materials(Database& database, const Drawing& drawing);
/// Reads it from a database that is not trusted and that has it.
Result<void> read_materials(const Database& database, Drawing& drawing);
/// Of a text, beside it.
std::int64_t material_checksum(std::string_view text) noexcept;

}  // namespace felt
