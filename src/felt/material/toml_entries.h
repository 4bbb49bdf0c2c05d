#pragma once

/// TOML as a flat list, for the materials and the studies. Internal: only toml_entries.cc uses the
/// parser, so that the repository has one reader of TOML.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "felt/base/result.h"

namespace felt {

/// A value of a type that no reader uses, such as a date.
struct TomlOther {
  std::string_view what;  ///< the type, for messages: "a list"
};

inline constexpr std::string_view kTomlEmptyTable = "an empty table";
inline constexpr std::string_view kTomlEmptyList = "an empty list";

struct TomlEntry {
  std::string key;  ///< "grain.height_um"
  int line = 0;
  int column = 0;
  std::variant<double, bool, std::string, TomlOther> value;
  bool is_whole = false;  ///< a number written without a decimal point
  /// The position of its table in a list of tables, from 0 ([[condition]]); -1 in other tables.
  int table = -1;
  /// The position of the value in a list, from 0; -1 if the value is not in a list.
  int item = -1;
};

/// What a reader accepts besides tables of values.
struct TomlRules {
  /// kOneValue: a list is one entry of type TomlOther. kItems: each value of a list is an entry,
  /// and so is each value of the tables of a list at the top level.
  enum class Lists { kOneValue, kItems } lists = Lists::kOneValue;
  std::string_view subject = "a material";  ///< for messages
};

/// The maximal length of a line.
inline constexpr std::size_t kMaxTomlLine = 500;

/// Returns an error if the text or a line is too long. Call it before read_toml, because the parser
/// nests as many tables as a line has dots. `max_bytes` is a multiple of 1024.
std::optional<Error> toml_too_long(std::string_view text, const std::string& name,
                                   std::size_t max_bytes);

/// Returns all entries of a TOML text in their order. The key of an entry in a table starts with
/// the table's name. An empty table gives one entry. Fails if the text is not TOML or is nested
/// deeper than any text that Feltline uses; the message starts with `name` and the line.
Result<std::vector<TomlEntry>> read_toml(std::string_view text, const std::string& name,
                                         const TomlRules& rules = {});

/// Returns "file.toml:7: ".
std::string toml_place(const std::string& name, int line);
/// Returns the value for messages: "0.5", "true", "a list", or a text between quotes, shortened and
/// without control characters.
std::string toml_value_text(const TomlEntry& entry);

}  // namespace felt
