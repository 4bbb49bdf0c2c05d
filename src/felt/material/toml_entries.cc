#include "felt/material/toml_entries.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "felt/base/utf8.h"

// A small file of figures: no exceptions, nothing printed, nothing deep. Version 3.3 states what it
// takes for granted of a text without having looked ("[=" is one, found by tests/fuzz): that is
// neither to end the program nor, in a build without assertions, to be believed.
#undef NDEBUG
#define TOML_ASSERT(expr) static_cast<void>(0)
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#define TOML_MAX_NESTED_VALUES 8
#include <toml++/toml.h>

namespace felt {
namespace {

constexpr int kMostDepth = 4;

int line_of(const toml::source_region& where) noexcept {
  return static_cast<int>(std::max<toml::source_index>(where.begin.line, 1));
}

/// A key that holds a point is none of ours, and must not look like one.
std::string name_of(const toml::key& key) {
  std::string name(key.str());
  return name.find('.') == std::string::npos ? name : "\"" + name + "\"";
}

std::string_view word_for(const toml::node& node) noexcept {
  if (node.is_table()) return kTomlEmptyTable;
  if (node.is_array()) return "a list";
  if (node.is_date()) return "a date";
  return "a time";
}

decltype(TomlEntry::value) value_of(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* number = node.as_floating_point()) return number->get();
  if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
  if (const auto* on = node.as_boolean()) return on->get();
  return TomlOther{word_for(node)};
}

struct Level {
  const toml::table* table;
  std::string prefix;
  int depth;
};

tl::unexpected<Error> too_deep(const std::string& name, const toml::key& key) {
  return fail(ErrorCode::kLimitExceeded, toml_place(name, line_of(key.source())) + "\"" +
                                             std::string(key.str()) +
                                             "\" is nested deeper than a material is");
}

/// Level by level instead of by recursion.
Result<std::vector<TomlEntry>> entries_of(const toml::table& root, const std::string& name) {
  std::vector<TomlEntry> entries;
  std::vector<Level> levels = {{&root, "", 1}};
  while (!levels.empty()) {
    const Level level = std::move(levels.back());
    levels.pop_back();
    for (const auto& [key, node] : *level.table) {
      const std::string id = level.prefix + name_of(key);
      const toml::table* table = node.as_table();
      if (table && !table->empty()) {
        if (level.depth == kMostDepth) return too_deep(name, key);
        levels.push_back({table, id + ".", level.depth + 1});
        continue;
      }
      entries.push_back({id, line_of(key.source()), static_cast<int>(key.source().begin.column),
                         value_of(node), node.is_integer()});
    }
  }
  std::sort(entries.begin(), entries.end(), [](const TomlEntry& a, const TomlEntry& b) {
    return std::pair(a.line, a.column) < std::pair(b.line, b.column);
  });
  return entries;
}

/// How long a string or comment is that begins here, up to the end where it has none; 0 for what is
/// neither.
std::size_t quoted_length(std::string_view text) noexcept {
  if (text.starts_with('#')) return std::min(text.find('\n'), text.size());
  for (const std::string_view quote : {"\"\"\"", "'''", "\"", "'"}) {
    if (!text.starts_with(quote)) continue;
    std::size_t at = quote.size();
    while (at < text.size() && !text.substr(at).starts_with(quote)) {
      if (quote.size() == 1 && text[at] == '\n') return at;  // it may not go on
      at += quote.front() == '"' && text[at] == '\\' ? 2 : 1;
    }
    return std::min(at + quote.size(), text.size());
  }
  return 0;
}

/// The parser looks for blanks among letters that are not ASCII by a table with holes; they may
/// stand in strings and comments only, where it does not. 0 where they do.
int line_of_stray_letter(std::string_view text) noexcept {
  int line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = std::max<std::size_t>(quoted_length(text.substr(at)), 1);
    if (static_cast<unsigned char>(text[at]) >= 0x80) return line;
    for (const char c : text.substr(at, length)) line += c == '\n' ? 1 : 0;
    at += length;
  }
  return 0;
}

/// The parser would go on in a header whose key is none; 0 where there is no such line. What begins
/// so within a text of several lines is refused, too: no material has that.
int line_of_bad_header(std::string_view text) noexcept {
  int line = 1;
  for (std::size_t at = 0; at < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view rest = text.substr(at, end - at);
    at = end + 1;
    const auto skip = [&rest](std::string_view what) {
      rest.remove_prefix(std::min(rest.find_first_not_of(what), rest.size()));
    };
    skip(" \t");
    if (!rest.starts_with('[')) continue;
    skip(" \t[");
    constexpr std::string_view kKeyBegins =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-\"']";
    if (rest.empty() || kKeyBegins.find(rest.front()) == std::string_view::npos) return line;
  }
  return 0;
}

}  // namespace

std::string toml_place(const std::string& name, int line) {
  return name + ":" + std::to_string(line) + ": ";
}

Result<std::vector<TomlEntry>> read_toml(std::string_view text, const std::string& name) {
  if (!is_utf8(text)) return fail(ErrorCode::kInvalidData, name + ": is not UTF-8");
  // The byte order mark, which some editors write before everything.
  if (constexpr std::string_view kMark = "\xEF\xBB\xBF"; text.starts_with(kMark)) {
    text.remove_prefix(kMark.size());
  }
  if (const int line = line_of_stray_letter(text)) {
    return fail(ErrorCode::kInvalidData,
                toml_place(name, line) + "a letter that is not ASCII stands outside of a string");
  }
  if (const int line = line_of_bad_header(text)) {
    return fail(ErrorCode::kInvalidData,
                toml_place(name, line) + "what follows '[' is not the name of a table");
  }
  const toml::parse_result parsed = toml::parse(text);
  if (parsed) return entries_of(parsed.table(), name);
  return fail(ErrorCode::kInvalidData, toml_place(name, line_of(parsed.error().source())) +
                                           std::string(parsed.error().description()));
}

}  // namespace felt
