#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace felt {

/// A row of a table as it is stored in the pages of an SQLite file. SQLite stores no separate value
/// for the column that is the row's id. Here, that column has the value monostate, as a null does.
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

/// Scans all pages of an SQLite file, one by one, and calls `report` for every readable row of
/// every table. Needs only the leaf pages, not the interior pages that lead to them. Used for files
/// that SQLite refuses. Nothing in these files is trusted, and the work and memory of the scan are
/// bounded. Skips rows of more than 64 columns. Format: sqlite.org/fileformat2.html.
void scan_rows(std::string_view bytes, const std::function<void(ScannedRow)>& report);

}  // namespace felt
