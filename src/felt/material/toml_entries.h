#pragma once

/// TOML as a flat list. Private to this layer; only toml_entries.cc uses the parser.

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "felt/base/result.h"

namespace felt {

/// A value of a type that materials do not use, such as an array or a date.
struct TomlOther {
  std::string_view what;  ///< the type, for messages: "a list"
};

inline constexpr std::string_view kTomlEmptyTable = "an empty table";

struct TomlEntry {
  std::string key;  ///< "grain.height_um"
  int line = 0;
  int column = 0;
  std::variant<double, bool, std::string, TomlOther> value;
  bool is_whole = false;  ///< a number written without a decimal point
};

/// Returns all entries of a TOML text in their order. The key of an entry in a table starts with
/// the table's name. An empty table gives one entry. Fails if the text is not TOML or is nested
/// deeper than a material can be; the message starts with `name` and the line.
Result<std::vector<TomlEntry>> read_toml(std::string_view text, const std::string& name);

/// Returns "file.toml:7: ".
std::string toml_place(const std::string& name, int line);

}  // namespace felt
