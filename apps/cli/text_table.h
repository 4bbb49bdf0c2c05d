#pragma once

#include <string>
#include <vector>

namespace felt::cli {

/// How stdout wants text: what a person sees at a terminal, or what the next program reads.
struct TextStyle {
  bool is_terminal = false;
  bool emphasis = false;  ///< bold headings; never with NO_COLOR, on a dumb terminal or in a pipe
  std::size_t width = 0;  ///< columns to wrap at; 0 = as long as it takes

  /// Of this program's stdout.
  static TextStyle of_stdout();
};

/// A heading as the style shows it.
std::string heading(const std::string& text, const TextStyle& style);

/// Lines no longer than `width` (0: one line), broken at blanks, each after the first indented.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);

/// Columns that line up, each as wide as it needs; numbers to the right.
class TextTable {
 public:
  enum class Align { kLeft, kRight };
  struct Column {
    std::string name;
    Align align = Align::kLeft;
  };

  explicit TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// One cell for each column. The text is ASCII.
  void add_row(std::vector<std::string> cells);
  /// The whole table with a line of names above. The last column wraps where the style is narrow.
  [[nodiscard]] std::string text(const TextStyle& style) const;

 private:
  [[nodiscard]] std::vector<std::size_t> widths() const;
  [[nodiscard]] std::string line(const std::vector<std::string>& cells,
                                 const std::vector<std::size_t>& widths, std::size_t room) const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace felt::cli
