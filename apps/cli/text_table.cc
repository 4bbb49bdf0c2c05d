#include "text_table.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "felt/base/check.h"
#include "felt/base/printable.h"

namespace felt::cli {
namespace {

constexpr std::size_t kColumnGap = 2;
constexpr std::size_t kNarrowestWrap = 24;

std::string padded(const std::string& cell, std::size_t width, TextTable::Align align) {
  const std::string blanks(width - std::min(width, cell.size()), ' ');
  return align == TextTable::Align::kRight ? blanks + cell : cell + blanks;
}

std::size_t terminal_width() {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

}  // namespace

TextStyle TextStyle::of_stdout() {
  TextStyle style;
  style.is_terminal = ::isatty(STDOUT_FILENO) != 0;
  if (!style.is_terminal) return style;
  const char* terminal = std::getenv("TERM");
  const char* no_color = std::getenv("NO_COLOR");
  style.width = terminal_width();
  style.emphasis = terminal != nullptr && std::string_view(terminal) != "dumb" &&
                   (no_color == nullptr || *no_color == '\0');
  return style;
}

std::string heading(const std::string& text, const TextStyle& style) {
  return style.emphasis ? "\x1b[1m" + text + "\x1b[0m" : text;
}

std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  if (width == 0) return text;
  std::string lines;
  std::size_t column = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::size_t length = end - at;
    if (column > 0 && column + 1 + length > width) {
      lines += "\n" + std::string(indent, ' ');
      column = 0;
    } else if (column > 0) {
      lines += ' ';
      ++column;
    }
    lines.append(text, at, length);
    column += length;
    at = end + 1;
  }
  return lines;
}

void TextTable::add_row(std::vector<std::string> cells) {
  FELT_CHECK(cells.size() == columns_.size());
  for (std::string& cell : cells) cell = printable(cell);
  rows_.push_back(std::move(cells));
}

std::vector<std::size_t> TextTable::widths() const {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    std::size_t width = columns_[c].name.size();
    for (const auto& row : rows_) width = std::max(width, row[c].size());
    widths.push_back(width);
  }
  return widths;
}

/// Returns one line of the table. `room` is the width in which the last cell wraps; 0 means
/// unlimited.
std::string TextTable::line(const std::vector<std::string>& cells,
                            const std::vector<std::size_t>& widths, std::size_t room) const {
  std::string text;
  std::size_t at = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const bool wraps = c + 1 == cells.size() && columns_[c].align == Align::kLeft;
    text += wraps ? wrapped(cells[c], room, at) : padded(cells[c], widths[c], columns_[c].align);
    at += widths[c] + kColumnGap;
    if (c + 1 < cells.size()) text += std::string(kColumnGap, ' ');
  }
  return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
}

std::string TextTable::text(const TextStyle& style) const {
  const std::vector<std::size_t> widths = this->widths();
  std::size_t last_at = 0;
  for (std::size_t c = 0; c + 1 < widths.size(); ++c) last_at += widths[c] + kColumnGap;
  const std::size_t room = style.width > last_at + kNarrowestWrap ? style.width - last_at : 0;
  std::vector<std::string> names;
  for (const Column& column : columns_) names.push_back(column.name);
  std::string top = line(names, widths, room);
  top.pop_back();
  std::string all = heading(top, style) + "\n";
  for (const auto& row : rows_) all += line(row, widths, room);
  return all;
}

}  // namespace felt::cli
