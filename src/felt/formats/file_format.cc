#include "felt/formats/file_format.h"

#include <algorithm>

#include "felt/base/ascii.h"
#include "felt/formats/format_traits.h"

namespace felt {
namespace {

bool ends_with(std::string_view text, std::string_view ending) noexcept {
  if (text.size() <= ending.size()) return false;
  const std::string_view tail = text.substr(text.size() - ending.size());
  return std::equal(tail.begin(), tail.end(), ending.begin(),
                    [](char a, char b) { return ascii_lower(a) == b; });
}

/// Returns the name without its folders. A file ".felt" in a folder has no ending.
std::string_view file_name(std::string_view path) noexcept {
  return path.substr(path.find_last_of('/') + 1);
}

bool is_space(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

void skip_space(std::string_view& text) noexcept {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
}

/// Removes the text up to and including `mark`. Returns false if there is no `mark`.
bool skip_past(std::string_view& text, std::string_view mark) noexcept {
  const std::size_t at = text.find(mark);
  if (at == std::string_view::npos) return false;
  text.remove_prefix(at + mark.size());
  return true;
}

/// Removes a document type, which may contain declarations in brackets.
bool skip_document_type(std::string_view& text) noexcept {
  const std::size_t end = text.find('>');
  const std::size_t bracket = text.find('[');
  if (bracket < end && !skip_past(text, "]")) return false;
  return skip_past(text, ">");
}

/// Returns the name of the first element, without its prefix; "" if there is none.
std::string_view root_element(std::string_view text) noexcept {
  for (;;) {
    skip_space(text);
    if (text.empty() || text.front() != '<') return {};
    if (text.substr(0, 2) == "<?") {
      text.remove_prefix(2);
      if (!skip_past(text, "?>")) return {};
    } else if (text.substr(0, 4) == "<!--") {
      text.remove_prefix(4);
      if (!skip_past(text, "-->")) return {};
    } else if (text.substr(0, 2) == "<!") {
      if (!skip_document_type(text)) return {};
    } else {
      const std::size_t end = std::min(text.find_first_of(" \t\r\n/>"), text.size());
      const std::string_view name = text.substr(1, end - 1);
      const std::size_t colon = name.find(':');
      return colon == std::string_view::npos ? name : name.substr(colon + 1);
    }
  }
}

/// Converts UTF-16 to its ASCII characters, which are sufficient to recognise the marks.
std::string narrowed(std::string_view head, std::size_t low_byte) {
  std::string text;
  for (std::size_t i = 2; i + 1 < head.size(); i += 2) {
    text += head[i + 1 - low_byte] == 0 ? head[i + low_byte] : '?';
  }
  return text;
}

}  // namespace

Result<FileFormat> format_of_path(const std::string& path) {
  const std::string_view name = file_name(path);
  std::string known;
  for (const FormatTraits& row : format_table()) {
    for (const std::string_view ending : row.endings) {
      if (ends_with(name, ending)) return row.format;
      known += ' ' + std::string(ending);
    }
  }
  return fail(ErrorCode::kUnsupported,
              path + ": unknown file extension; the extensions are" + known);
}

bool is_compressed_name(const std::string& path) {
  return ends_with(path, ".svgz");
}

std::optional<FileFormat> format_of_bytes(std::string_view head) {
  const auto begins = [&head](std::string_view mark) {
    return head.substr(0, mark.size()) == mark;
  };
  if (begins(std::string_view("SQLite format 3\0", 16))) return FileFormat::kFelt;
  if (begins("\x1f\x8b") || begins("PK\x03\x04")) return FileFormat::kXopp;
  if (begins("%PDF-")) return FileFormat::kPdf;
  if (begins("\x89PNG\r\n")) return FileFormat::kPng;
  std::string plain;
  if (begins("\xff\xfe"))
    head = plain = narrowed(head, 0);
  else if (begins("\xfe\xff"))
    head = plain = narrowed(head, 1);
  else if (begins("\xef\xbb\xbf"))
    head.remove_prefix(3);
  skip_space(head);
  if (begins("{")) return FileFormat::kNdjson;
  const std::string_view root = root_element(head);
  if (root == "svg") return FileFormat::kSvg;
  if (root == "ink") return FileFormat::kInkml;
  if (root == "xournal") return FileFormat::kXopp;
  return std::nullopt;
}

NdjsonContent ndjson_content(std::string_view head) noexcept {
  while (!head.empty()) {
    const std::string_view line = head.substr(0, head.find('\n'));
    const auto has = [line](std::string_view key) {
      return line.find(key) != std::string_view::npos;
    };
    if (has("\"points\":") || has("\"segments\":")) return NdjsonContent::kStrokes;
    if (has("\"drawing\":") || has("\"drawing\" :")) return NdjsonContent::kQuickdraw;
    if (has("\"event\":") || has("\"event\" :")) return NdjsonContent::kEvents;
    head.remove_prefix(std::min(line.size() + 1, head.size()));
  }
  return NdjsonContent::kStrokes;
}

}  // namespace felt
