#pragma once

#include <optional>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/store/database.h"
#include "felt/store/felt_extras.h"
#include "felt/store/felt_schema.h"

namespace felt {

/// The file that a drawing was read from, opened again to read its extras. The FeltExtras must
/// outlive it.
class CarriedFile {
 public:
  /// Opens the file. If the extras have no file, this is not an error: copy_to() then copies
  /// nothing.
  static Result<CarriedFile> open(const FeltExtras& extras);

  /// Returns the schema, or null if there is no file.
  [[nodiscard]] const FeltSchema* schema() const noexcept { return database_ ? &schema_ : nullptr; }
  [[nodiscard]] const Database* database() const noexcept {
    return database_ ? &*database_ : nullptr;
  }

  /// Copies content that only a newer Feltline understands into a database that already has our
  /// tables and their rows. Copies whole tables, and the additional columns of the drawing and of
  /// those layers and strokes that still exist. Leaves out rows of tables if their column "stroke"
  /// or "layer" names an object that no longer exists.
  Result<void> copy_to(Database& to, const Document& document) const;

 private:
  CarriedFile() = default;
  Result<void> copy_columns(Database& to, const FeltTable& table) const;
  Result<void> copy_table(Database& to, const FeltTable& table, const Document& document) const;

  std::optional<Database> database_;
  FeltSchema schema_;
};

/// Returns the statement that inserts a row with all columns of a table.
inline std::string insertion_into(const FeltTable& table) {
  std::string marks = "?", names;
  for (std::size_t i = 1; i < table.columns.size(); ++i) marks += ",?";
  for (const std::string& column : table.columns) {
    names += (names.empty() ? "\"" : ", \"") + column + "\"";
  }
  return "INSERT INTO " + table.name + "(" + names + ") VALUES(" + marks + ")";
}

/// Copies those rows of a table for which stays(row) is true. The table in `to` may have more
/// columns.
template <class Stays>
Result<void> copy_rows(const Database& from, const Database& to, const FeltTable& table,
                       Stays stays) {
  const auto read = from.prepare(("SELECT * FROM " + table.name + " NOT INDEXED").c_str());
  if (!read) return tl::unexpected(read.error());
  const auto write = to.prepare(insertion_into(table).c_str());
  if (!write) return tl::unexpected(write.error());
  for (;;) {
    const Result<bool> more = read->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    if (!stays(*read)) continue;
    for (int i = 0; i < static_cast<int>(table.columns.size()); ++i) {
      write->bind_column(i + 1, *read, i);
    }
    if (auto done = write->step(); !done) return tl::unexpected(done.error());
    write->reset();
  }
}

}  // namespace felt
