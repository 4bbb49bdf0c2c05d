#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/store/database.h"

namespace felt {

/// Reads an autosave database that may be damaged: skips rows that cannot be read, and reads those
/// before and behind them. Moves the WAL that a dead process left into the file, so it is for
/// copies only. One thread.
class AutosaveReader {
 public:
  /// Fails if it is no autosave database of this version, or nothing of it can be read. Adds what
  /// quick_check finds to `problems`.
  static Result<AutosaveReader> open(const std::string& path, std::vector<std::string>& problems);

  AutosaveReader(AutosaveReader&& other) noexcept;
  AutosaveReader& operator=(AutosaveReader&& other) noexcept;
  ~AutosaveReader();

  /// Calls `each` with every row of a table that can be read, by ascending key from `first` on.
  /// `columns` come after the key. Keys are consecutive numbers, except for deleted rows. False if
  /// some rows could not be read.
  bool rows(const std::string& table, const std::string& key, const std::string& columns,
            std::int64_t first, const std::function<void(const Statement&)>& each) const;

  /// True if rows were skipped because memory ran out, not because they are damaged: then nothing
  /// that was read is valid.
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
