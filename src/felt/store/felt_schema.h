#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/store/database.h"

namespace felt {

/// Bounds of what a file may hold that is not ours.
inline constexpr std::size_t kMaxForeignTables = 64;
inline constexpr std::size_t kMaxColumns = 64;  ///< of a table
inline constexpr std::size_t kMaxIdentifierBytes = 63;

/// A table as its definition says.
struct FeltTable {
  std::string name;
  std::string sql;
  std::vector<std::string> columns;

  /// Of the columns that our own table of this name does not have: the names, each after a comma.
  [[nodiscard]] std::string beyond(std::size_t ours) const;
};

/// What tables a file has.
struct FeltSchema {
  FeltTable drawing, layer, palette, shown, stroke;
  bool has_materials = false;  ///< the table `material` (material_table.h)
  /// All three or none.
  std::vector<FeltTable> recordings;
  /// Of a newer Feltline, in the order of their names.
  std::vector<FeltTable> foreign;

  /// Whether there is anything that a drawing carries and does not look at.
  [[nodiscard]] bool has_extras() const noexcept;
};

/// The definitions of our own tables, and how many columns each has.
struct OwnTable {
  std::string_view name;
  std::string_view sql;
  std::size_t columns;
};
const OwnTable& own_table(std::string_view name);

/// Makes our tables in an empty database; those that a drawing carries columns in as `like` says.
Result<void> make_tables(Database& database, const FeltSchema* like);
/// Makes those of recordings, and the views through which other programs read them. Columns for the
/// pen's lean are there where `like` has them, or where they are asked for.
Result<void> make_recording_tables(Database& database, const FeltSchema* like, bool with_lean);
/// Whether a table of recordings has its column for the lean.
[[nodiscard]] bool has_lean(const FeltTable& table);

/// Takes a definition apart: CREATE TABLE name(column TYPE [PRIMARY KEY] [NOT NULL] [DEFAULT
/// literal], ...) with exactly these blanks, names of a-z, 0-9 and _, types INTEGER, REAL, TEXT and
/// BLOB. Nothing else can be said so: no check, no expression, no function, no module. Error: it is
/// anything else.
Result<FeltTable> parse_table(std::string_view sql);

/// Reads what tables a file that is not trusted has. Ours must be there and begin with our columns;
/// others must be such as parse_table() takes. Views and indexes of others are no data, and nobody
/// looks at them. Error: a trigger, a virtual table, an index on our tables, anything above.
Result<FeltSchema> read_schema(const Database& database);

}  // namespace felt
