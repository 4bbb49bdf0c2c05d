#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace felt {

/// A row of a table as the pages of an SQLite file have it. A column that is the row's id has no
/// value of its own (monostate), like one that is null.
struct ScannedRow {
  /// What stands in a column; texts and blobs share a type, is_text tells them apart.
  struct Bytes {
    std::string value;
    bool is_text = false;
  };
  using Value = std::variant<std::monostate, std::int64_t, double, Bytes>;

  std::int64_t id = 0;
  std::vector<Value> values;
};

/// Goes over all pages of an SQLite file, one by one, and tells every row that stands in a page of
/// rows and can be made out, whatever table it is of; pages that lead to others are not needed. For
/// files that SQLite refuses: nothing is believed, everything is bounded. Rows of more than 64
/// columns are passed over. Format: sqlite.org/fileformat2.html.
void scan_rows(std::string_view bytes, const std::function<void(ScannedRow)>& tell);

}  // namespace felt
