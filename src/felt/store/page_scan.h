#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace felt {

/// A row of a table as it is stored in the pages of an SQLite file. A column that is the row's id
/// has no separate value and is monostate, like a null.
struct ScannedRow {
  /// Value of a text or blob column.
  struct Bytes {
    std::string value;
    bool is_text = false;
  };
  using Value = std::variant<std::monostate, std::int64_t, double, Bytes>;

  std::int64_t id = 0;
  std::vector<Value> values;
};

/// Scans all pages of an SQLite file, one by one, and calls `tell` for every readable row, of any
/// table. Only the leaf pages are needed, not the interior pages that lead to them. For files that
/// SQLite refuses: nothing is trusted, and work and memory are bounded. Skips rows of more than 64
/// columns. Format: sqlite.org/fileformat2.html.
void scan_rows(std::string_view bytes, const std::function<void(ScannedRow)>& tell);

}  // namespace felt
