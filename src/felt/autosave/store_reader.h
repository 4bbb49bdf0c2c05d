#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/store/database.h"

namespace felt {

/// Reads a working store that may be damaged: rows that cannot be read are left out, those before
/// and behind them are not. Takes the journal that a dead process left into the file: for copies
/// only. One thread.
class StoreReader {
 public:
  /// Error: no working store of this version, or nothing of it can be read. What quick_check finds
  /// goes into `problems`.
  static Result<StoreReader> open(const std::string& path, std::vector<std::string>& problems);

  StoreReader(StoreReader&& other) noexcept;
  StoreReader& operator=(StoreReader&& other) noexcept;
  ~StoreReader();

  /// Every row that can be read of a table, by ascending key from `first` on. `columns` come after
  /// the key. Keys are numbers that follow one another, but for those that were deleted. True: all
  /// rows were read; false: some could not be.
  bool rows(const std::string& table, const std::string& key, const std::string& columns,
            std::int64_t first, const std::function<void(const Statement&)>& each) const;

  /// Rows were left out because memory was short, not because they are damaged: nothing that was
  /// read counts.
  [[nodiscard]] bool ran_out_of_memory() const noexcept { return ran_out_of_memory_; }

 private:
  StoreReader() = default;
  Result<void> check(std::vector<std::string>& problems);
  [[nodiscard]] Result<std::int64_t> pragma(const char* sql) const;

  void look_at_memory() const noexcept;

  sqlite3* db_ = nullptr;
  mutable bool ran_out_of_memory_ = false;
};

}  // namespace felt
