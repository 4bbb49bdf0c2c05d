#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/store/database.h"

namespace felt {

/// Reads an autosave database that may be damaged: skips rows that cannot be read, and reads all
/// other rows. Open only copies, because SQLite moves the WAL of a dead process into the database
/// file when it opens the database. Not thread-safe.
class AutosaveReader {
 public:
  /// Opens a database. Fails if it is not an autosave database of this version, or if no part of it
  /// can be read. Adds the errors that SQLite's quick_check finds to `problems`.
  static Result<AutosaveReader> open(const std::string& path, std::vector<std::string>& problems);

  AutosaveReader(AutosaveReader&& other) noexcept;
  AutosaveReader& operator=(AutosaveReader&& other) noexcept;
  ~AutosaveReader();

  /// Calls `each` with every readable row of a table, by ascending key from `first` on. Each row
  /// contains the key, followed by `columns`. Requires that keys are consecutive numbers, except
  /// for deleted rows. Returns false if some rows could not be read.
  bool rows(const std::string& table, const std::string& key, const std::string& columns,
            std::int64_t first, const std::function<void(const Statement&)>& each) const;

  /// Returns true if rows() skipped rows because memory ran out, although these rows may be intact.
  /// In that case, all rows read are invalid.
  [[nodiscard]] bool ran_out_of_memory() const noexcept { return ran_out_of_memory_; }

 private:
  AutosaveReader() = default;
  Result<void> check(std::vector<std::string>& problems);
  [[nodiscard]] Result<std::int64_t> pragma(const char* sql) const;

  void look_at_memory() const noexcept;

  sqlite3* db_ = nullptr;
  mutable bool ran_out_of_memory_ = false;
};

}  // namespace felt
