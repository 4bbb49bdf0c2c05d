#pragma once

#include <string>
#include <vector>

namespace felt::testing {

/// Returns the cells of each line of CSV, read as RFC 4180 defines it.
inline std::vector<std::vector<std::string>> csv_rows(const std::string& csv) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool is_quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    std::string& cell = rows.back().back();
    if (is_quoted && csv[i] == '"' && i + 1 < csv.size() && csv[i + 1] == '"') {
      cell += csv[++i];
    } else if (csv[i] == '"') {
      is_quoted = !is_quoted;
    } else if (!is_quoted && csv[i] == ',') {
      rows.back().emplace_back();
    } else if (!is_quoted && csv[i] == '\n') {
      rows.push_back({""});
    } else {
      cell += csv[i];
    }
  }
  rows.pop_back();  // after the last end of line
  return rows;
}

}  // namespace felt::testing
