#pragma once

#include <initializer_list>
#include <string>

#include "apps/cli/text_table.h"

namespace felt::bench {

/// Prints bars, and counts those that are missed.
class Report {
 public:
  void bar(bool holds, const std::string& what);
  [[nodiscard]] int missed() const { return missed_; }

 private:
  int missed_ = 0;
};

/// Returns a table whose first column is text and the others numbers.
cli::TextTable table(std::initializer_list<const char*> columns);
void print(const cli::TextTable& table);

}  // namespace felt::bench
