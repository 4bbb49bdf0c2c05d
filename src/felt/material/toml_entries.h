#pragma once

/// TOML as a flat list. Private to this layer; the only place that knows the parser.

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "felt/base/result.h"

namespace felt {

/// A value of a kind that no material has: an array, a date.
struct TomlOther {
  std::string_view what;  ///< "a list"
};

inline constexpr std::string_view kTomlEmptyTable = "an empty table";

struct TomlEntry {
  std::string key;  ///< "grain.height_um"
  int line = 0;
  int column = 0;
  std::variant<double, bool, std::string, TomlOther> value;
  bool is_whole = false;  ///< of a number: written without a point
};

/// What it says, in the order of the text; `name` and the line begin the message of an error. A
/// table is the entries in it, and one without any is an entry. Error: not TOML, deeper than a
/// material is.
Result<std::vector<TomlEntry>> read_toml(std::string_view text, const std::string& name);

/// "file.toml:7: "
std::string toml_place(const std::string& name, int line);

}  // namespace felt
