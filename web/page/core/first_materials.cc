// The reader of the materials in the first module, in place of felt/material/toml_entries.cc, which
// is large. It reads only the texts of built_in_texts(): tables, and one value on each line.

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

#include "felt/material/toml_entries.h"

namespace felt {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

/// Reads the value of a line, which may be followed by a comment.
void read_value(std::string_view text, TomlEntry& entry) {
  if (text.starts_with('"')) {
    entry.value = std::string(text.substr(1, text.find('"', 1) - 1));
    return;
  }
  text = trimmed(text.substr(0, text.find('#')));
  if (text == "true" || text == "false") {
    entry.value = text == "true";
    return;
  }
  double number = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  entry.value = number;
  entry.is_whole = text.find_first_of(".e") == std::string_view::npos;
}

}  // namespace

std::string toml_place(const std::string&, int) {
  return {};
}

std::string toml_value_text(const TomlEntry&) {
  return {};
}

std::optional<Error> toml_too_long(std::string_view, const std::string&, std::size_t) {
  return std::nullopt;
}

Result<std::vector<TomlEntry>> read_toml(std::string_view text, const std::string&,
                                         const TomlRules&) {
  std::vector<TomlEntry> entries;
  std::string table;
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (line.starts_with('[')) table = std::string(line.substr(1, line.find(']') - 1)) + ".";
    const std::size_t equals = line.find('=');
    if (line.empty() || line[0] == '#' || line[0] == '[' || equals == std::string_view::npos) {
      continue;
    }
    TomlEntry entry;
    entry.key = table + std::string(trimmed(line.substr(0, equals)));
    entry.line = number;
    read_value(trimmed(line.substr(equals + 1)), entry);
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace felt
