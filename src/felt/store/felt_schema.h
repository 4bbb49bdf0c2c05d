#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/store/database.h"

namespace felt {

/// Limits of foreign tables in a file.
inline constexpr std::size_t kMaxForeignTables = 64;
inline constexpr std::size_t kMaxColumns = 64;  ///< of a table
inline constexpr std::size_t kMaxIdentifierBytes = 63;

/// A table of a file, parsed from its SQL definition.
struct FeltTable {
  std::string name;
  std::string sql;
  std::vector<std::string> columns;

  /// Returns the names of the columns after the first `ours` columns, with a comma before each
  /// name. A newer Feltline added these columns to our table.
  [[nodiscard]] std::string beyond(std::size_t ours) const;
};

/// The tables of a file.
struct FeltSchema {
  FeltTable drawing, layer, palette, shown, stroke;
  bool has_materials = false;     ///< the table `material` (material_table.h)
  bool has_fills = false;         ///< the table `fill` (fill_table.h)
  bool has_guides = false;        ///< the table `guide` (guide_table.h)
  bool has_symmetries = false;    ///< the table `symmetry` (guide_table.h)
  bool has_layer_looks = false;   ///< the table `layer_look` (layer_look_table.h)
  bool has_pictures = false;      ///< the table `picture` (layer_look_table.h)
  bool has_layer_blends = false;  ///< the table `layer_blend` (layer_group_table.h)
  bool has_layer_groups = false;  ///< the table `layer_group` (layer_group_table.h)
  bool has_key_timings = false;   ///< the table `key_timing` (key_timing_table.h)
  bool has_body_edits = false;    ///< the table `body_edit` (body_edit_table.h)
  bool has_stroke_names = false;  ///< the table `stroke_name` (stroke_name_table.h)
  /// The three tables of recordings; empty if the file has no recordings.
  std::vector<FeltTable> recordings;
  /// Tables of a newer Feltline, in the order of their names.
  std::vector<FeltTable> foreign;

  /// Returns true if the file has content that a drawing keeps as FeltExtras.
  [[nodiscard]] bool has_extras() const noexcept;
};

/// Definition and number of columns of one of our own tables.
struct OwnTable {
  std::string_view name;
  std::string_view sql;
  std::size_t columns;
};
const OwnTable& own_table(std::string_view name);

/// Creates our tables in an empty database. If `like` is not null, the tables also get the
/// additional columns that they have in `like`.
Result<void> make_tables(Database& database, const FeltSchema* like);
/// Creates the tables of recordings, and the views through which other programs read them. The
/// tables get columns for the pen's tilt if `with_tilt` is true or the tables in `like` have these
/// columns.
Result<void> make_recording_tables(Database& database, const FeltSchema* like, bool with_tilt);
/// Returns true if this table of recordings has the column for the tilt.
[[nodiscard]] bool has_tilt(const FeltTable& table);

/// Parses a definition: CREATE TABLE name(column TYPE [PRIMARY KEY] [NOT NULL] [DEFAULT literal],
/// ...) with exactly these spaces. Names consist of a-z, 0-9 and _; types are INTEGER, REAL, TEXT
/// and BLOB. This form allows no check, expression, function or module. Fails for any other text.
Result<FeltTable> parse_table(std::string_view sql);

/// Reads the tables of an untrusted file. Ignores views, and indexes on tables that are not ours,
/// because these are not data. Fails if one of our tables is missing or does not begin with our
/// columns, if parse_table() rejects a table, or if the file has a trigger, a virtual table or an
/// index on our tables.
Result<FeltSchema> read_schema(const Database& database);

}  // namespace felt
