#include "report.h"

#include <fmt/core.h>

#include <vector>

namespace felt::bench {

void Report::bar(bool holds, const std::string& what) {
  fmt::print("{}: {}\n", holds ? "held" : "MISSED", what);
  if (!holds) ++missed_;
}

cli::TextTable table(std::initializer_list<const char*> columns) {
  using Align = cli::TextTable::Align;
  std::vector<cli::TextTable::Column> all;
  for (const char* name : columns)
    all.push_back({name, all.empty() ? Align::kLeft : Align::kRight});
  return cli::TextTable(all);
}

void print(const cli::TextTable& table) {
  fmt::print("{}\n", table.text(cli::TextStyle::of_stdout()));
}

}  // namespace felt::bench
